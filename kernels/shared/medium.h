/// A medium as the device sees it; coefficients per unit of render-space length; 48 bytes.
#ifndef MEDIUM_H
#define MEDIUM_H

#define NO_MEDIUM 0xffffffffu
#define NO_GRID 0xffffffffu
#define DENSITY_GRID_COLOURED 1u
#define ALBEDO_GRID_COLOURED 2u

typedef struct {
    float sigma_t_r, sigma_t_g, sigma_t_b;  ///< extinction; of a grid: where its value is 1
    float g;                                ///< mean cosine of the phase function, 0 for isotropic
    float sigma_s_r, sigma_s_g, sigma_s_b;  ///< scattering, the same; with an albedo grid: extinction, to be multiplied by the albedo
    uint first_lobe, lobe_count;            ///< of its phase function; no lobes: Henyey and Greenstein's for g
    uint density_grid, albedo_grid;         ///< NO_GRID: constant
    uint grid_colours;                      ///< sum of DENSITY_GRID_COLOURED and ALBEDO_GRID_COLOURED: those grids have three channels, the others one
} MediumRecord;
LAYOUT(MediumRecord, 48)

#endif
