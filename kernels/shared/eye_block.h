/// Eyes of neighbouring pixels that share one estimate of every light: `groups` groups of 16 eyes; 32 bytes. The camera samples of a square of pixels are parts
/// of one choice: a part takes one of every `parts` strata, so that a pixel's samples together take all.
#ifndef EYE_BLOCK_H
#define EYE_BLOCK_H

typedef struct {
    uint first, groups;  ///< in groups of 16 eyes
    uint key;            ///< random key, a function of (seed, pass, square); the same for all parts
    uint standing;       ///< number of the eye whose estimates the block uses; the same for all parts
    uint part, parts;    ///< part < parts
    uint padding_0, padding_1;
} EyeBlock;
LAYOUT(EyeBlock, 32)

#endif
