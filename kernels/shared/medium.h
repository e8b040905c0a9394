/// A homogeneous medium as the device sees it; coefficients per unit of render-space length; 32 bytes.
#ifndef MEDIUM_H
#define MEDIUM_H

#define NO_MEDIUM 0xffffffffu

typedef struct {
    float sigma_t_r, sigma_t_g, sigma_t_b;  ///< extinction
    float g;                                ///< mean cosine of the phase function, 0 for isotropic
    float sigma_s_r, sigma_s_g, sigma_s_b;  ///< scattering
    uint padding;
} MediumRecord;
LAYOUT(MediumRecord, 32)

#endif
