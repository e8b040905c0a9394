/// Beer and Lambert, and distances sampled from it. sigma: per unit of length; optical depths have no unit.
#ifndef TRANSMITTANCE_H
#define TRANSMITTANCE_H

#include "kernels/math/stable.h"

/// exp(-optical_depth), optical_depth >= 0. Where it would be below the smallest normal number it is 0 on devices that flush.
PURE real transmittance(real optical_depth) { return decay(optical_depth); }

/// exp(reference - optical_depth): a ratio of transmittances both of which may underflow (eq. 19).
PURE real transmittance_ratio(real optical_depth, real reference) { return exp(reference - optical_depth); }

/// What a ray has passed up to a point and what scatters there, per channel, relative to the coefficients of its medium. Homogeneous: the distance, and 1.
typedef struct {
    real3 path;        ///< integral of the density from the ray's start to the point: times sigma_t it is the optical depth
    real3 scattering;  ///< density x albedo at the point: what sigma_s is multiplied by
} Matter;
PURE Matter even_matter(real distance)
{
    Matter m;
    m.path = make_real3(distance, distance, distance);
    m.scattering = make_real3(R(1.0), R(1.0), R(1.0));
    return m;
}

/// Distance in [0, length] with density proportional to exp(-sigma_t t), cut at `length` (eq. 20): no digit is lost for small optical depths,
/// sigma_t = 0 gives xi length, length = infinity is allowed if sigma_t > 0. xi in [0, 1).
PURE real sample_distance(real sigma_t, real length, real xi)
{
    real depth = sigma_t * length;
    mask thin = depth < R(1.0);
    real absorbed_over = expm1_over(-select(R(1.0), depth, thin));                        // (1 - T) / depth
    real x = xi * absorbed_over * depth;
    real near_t = xi * length * absorbed_over * log1p_over(-select(R(0.0), x, thin));
    real far_t = -log1p(xi * expm1(-depth)) / select(sigma_t, R(1.0), thin);
    return fmin(select(far_t, near_t, thin), length);
}

/// Density of sample_distance at t in [0, length], per unit of length.
PURE real pdf_distance(real sigma_t, real length, real t)
{
    real depth = sigma_t * length;
    mask thin = depth < R(1.0);
    real normal = select(-expm1(-depth) / select(sigma_t, R(1.0), thin), select(R(1.0), length, thin) * expm1_over(-select(R(1.0), depth, thin)), thin);
    return exp(-sigma_t * t) / normal;
}

/// The xi for which sample_distance returns t.
PURE real invert_distance(real sigma_t, real length, real t)
{
    real depth = sigma_t * length;
    mask thin = depth < R(1.0);
    real near_xi = t * expm1_over(-sigma_t * t) / (length * expm1_over(-select(R(1.0), depth, thin)));
    return select(expm1(-sigma_t * t) / select(expm1(-depth), R(-1.0), thin), near_xi, thin);
}

#endif
