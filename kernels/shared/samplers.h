/// How a virtual ray light and an eye segment are connected, and from which numbers: build options (-DSAMPLER=n -DSEQUENCE=n), `--sampler` and `--sequence` on
/// the command line.
#ifndef SAMPLERS_H
#define SAMPLERS_H

enum {
    SAMPLER_PAPER_ISOTROPIC = 0,  ///< the talk's marginal, equi-angular conditional: the talk's for isotropic media
    SAMPLER_PAPER = 1,            ///< the talk's marginal, product of phase functions in the angle, 10 vertices; the same as 0 where all scatter isotropically
    SAMPLER_PAPER_6 = 2,          ///< the talk's marginal, product of phase functions and transmittance in the angle, 6 vertices
    SAMPLER_TABLE = 3,            ///< marginal from a table of 8 nodes x 6 angles, conditional as 2 with 10 vertices
    SAMPLER_TABLE_4X4 = 4,        ///< 4 nodes x 4 angles, 6 vertices
    SAMPLER_TABLE_3X2 = 5,        ///< 3 nodes x 2 angles, 4 vertices
};

enum {
    SEQUENCE_RANDOM = 0,  ///< independent numbers
    SEQUENCE_SOBOL = 1,   ///< scrambled Sobol points, along the samples of a pair and then along the lights of an eye
};

#ifndef SAMPLER
#define SAMPLER SAMPLER_PAPER_ISOTROPIC
#endif
#ifndef SEQUENCE
#define SEQUENCE SEQUENCE_RANDOM
#endif

/// Numbers of each sampler. The conditional follows the phase functions or the transmittance; whether there are lobes is the scene's affair (ANISOTROPIC).
#define SAMPLER_WARPS (SAMPLER != SAMPLER_PAPER_ISOTROPIC && (ANISOTROPIC || SAMPLER != SAMPLER_PAPER))
#define SAMPLER_ABSORBS (SAMPLER >= SAMPLER_PAPER_6)
#define SAMPLER_TABULATES (SAMPLER >= SAMPLER_TABLE)
#define SAMPLER_VERTICES (SAMPLER == SAMPLER_PAPER_6 || SAMPLER == SAMPLER_TABLE_4X4 ? 6 : SAMPLER == SAMPLER_TABLE_3X2 ? 4 : 10)
#define SAMPLER_NODES (SAMPLER == SAMPLER_TABLE ? 8 : SAMPLER == SAMPLER_TABLE_4X4 ? 4 : 3)
#define SAMPLER_ANGLES (SAMPLER == SAMPLER_TABLE ? 6 : SAMPLER == SAMPLER_TABLE_4X4 ? 4 : 2)

#endif
