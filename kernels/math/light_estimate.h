/// What estimates of any virtual light have in common: lobes that stand for a block's, and what is left of a light's colour on its way
/// (kernels/README.md, section 16). Everything is bounded and nothing is random.
#ifndef LIGHT_ESTIMATE_H
#define LIGHT_ESTIMATE_H

#include "kernels/math/phase_product.h"
#include "kernels/math/rod_table.h"

#define ESTIMATE_ANGLES 3  ///< of the eye segment, seen from a light or a place on it

/// A block of pixels sees a lobe under many angles: the estimate is the mean of a lobe that is slightly and of one that is much broader than the medium's.
#define NARROW_LOBE R(0.95)
#define BROAD_LOBE R(0.6)

/// Mean cosines times `breadth`, and what makes the product of both lobes comparable between media: (1 - g^2) (1 - g^2).
typedef struct { real g_eye, g_light, scale; } GuideLobes;
PURE GuideLobes guide_lobes(real g_eye, real g_light, real breadth)
{
    GuideLobes l = {g_eye * breadth, g_light * breadth, R(1.0)};
    l.scale = fma(-l.g_eye, l.g_eye, R(1.0)) * fma(-l.g_light, l.g_light, R(1.0));
    return l;
}

PURE real guide_product(GuideLobes l, real mu_eye, real mu_light)
{
    real over = R(1.0) / (blunt_lobe(l.g_eye, mu_eye) * blunt_lobe(l.g_light, mu_light));
    return l.scale * over * sqrt(over);
}

/// Mean of the narrow and the broad product of phase functions, times (4 pi)^2.
PURE real guide_phase(real g_eye, real g_light, real mu_eye, real mu_light)
{
    return R(0.5) * (guide_product(guide_lobes(g_eye, g_light, NARROW_LOBE), mu_eye, mu_light) + guide_product(guide_lobes(g_eye, g_light, BROAD_LOBE), mu_eye, mu_light));
}

/// What an estimate goes by: a light's colour times what it loses. Extinctions along eye segment, light and connection, per unit of length and channel.
typedef struct {
    real3 colour;                 ///< of what would arrive if nothing were lost on the way
    real3 eye, light, leg;
    real g_eye, g_light;          ///< mean cosines
    int lobes, coloured;          ///< known when the kernel is built: phase functions matter; channels differ in extinction
} EstimateMedia;

PURE real channel_left(real colour, real eye, real light, real leg, real u, real v, real w)
{
    return colour * decay(fmin(fma(eye, u, fma(light, v, leg * w)), DEEPEST_GUIDE));
}

/// Sum over channels of what is left after u along the eye segment, v along the light and w between.
PURE real colour_left(EstimateMedia m, real u, real v, real w)
{
    if (!m.coloured) return channel_left(m.colour.x + m.colour.y + m.colour.z, m.eye.x, m.light.x, m.leg.x, u, v, w);
    return channel_left(m.colour.x, m.eye.x, m.light.x, m.leg.x, u, v, w) + channel_left(m.colour.y, m.eye.y, m.light.y, m.leg.y, u, v, w) +
           channel_left(m.colour.z, m.eye.z, m.light.z, m.leg.z, u, v, w);
}

/// A surface point's block sees the light from points with other normals too: a share that does not ask for the cosine.
#define ESTIMATE_ANY_NORMAL R(0.1)

#endif
