/// One part of a phase function that is a weighted sum of parts; 32 bytes.
#ifndef PHASE_LOBE_H
#define PHASE_LOBE_H

#define PHASE_LOBE_HENYEY_GREENSTEIN 0u
#define PHASE_LOBE_RAYLEIGH 1u
#define PHASE_LOBE_TABLE 2u

typedef struct {
    uint kind;
    float weight;                    ///< in (0, 1]; those of a medium sum to 1
    float g;                         ///< mean cosine
    uint first_value, value_count;   ///< table: per steradian, at value_count >= 2 equally spaced cosines from -1 to 1, linear between; it integrates to 1
    uint padding_0, padding_1, padding_2;
} PhaseLobeRecord;
LAYOUT(PhaseLobeRecord, 32)

#endif
