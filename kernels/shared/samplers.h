/// How the conditional over the eye segment is sampled: a build option (-DSAMPLER=n), `--sampler` on the command line.
#ifndef SAMPLERS_H
#define SAMPLERS_H

enum {
    SAMPLER_PAPER_ISOTROPIC = 0,  ///< equi-angular: the talk's for isotropic media
    SAMPLER_PAPER = 1,            ///< product of phase functions in the angle: the talk's for anisotropic media; the same as 0 where all scatter isotropically
};

#ifndef SAMPLER
#define SAMPLER SAMPLER_PAPER_ISOTROPIC
#endif

#endif
