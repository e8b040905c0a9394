/// What a virtual ray light sends to an eye segment or a surface point, roughly and in few operations: where the choice of lights is made, not the image
/// (kernels/README.md, section 16). Everything is bounded and nothing is random.
#ifndef ROD_ESTIMATE_H
#define ROD_ESTIMATE_H

#include "kernels/math/light_estimate.h"
#include "kernels/math/rod_table.h"

#define ESTIMATE_NODES 2   ///< along the light

/// Integral over the light of what it scatters, summed over channels.
PURE real rod_power(EstimateMedia m, real length)
{
    real red = m.light.x * length, green = m.light.y * length, blue = m.light.z * length;
    return length * fma(m.colour.x, expm1_over(-fmin(red, DEEPEST_GUIDE)), fma(m.colour.y, expm1_over(-fmin(green, DEEPEST_GUIDE)), m.colour.z * expm1_over(-fmin(blue, DEEPEST_GUIDE))));
}

/// Sum over channels of the integral over light and segment of colour x phase functions x transmittance / w^2, times (4 pi)^2: the mid-point rule in the rod
/// variable and in the angle.
PURE real rod_estimate(real3 q, real3 a, real3 b, real length, real eye_length, EstimateMedia media)
{
    RodFrame f = rod_frame(q, a, b, length);
    RodPiece whole = rod_whole(f);
    GuideMedia nothing = {R(0.0), R(0.0), R(0.0), R(0.0), R(0.0)};
    RodView view = rod_view(f, q, a, b, eye_length, nothing);
    TableShape shape = {ESTIMATE_NODES, ESTIMATE_ANGLES, 0};
    RodNode node[ESTIMATE_NODES];
    real v[ESTIMATE_NODES], sum = R(0.0);
    for (int k = 0; k < ESTIMATE_NODES; ++k) {
        v[k] = rod_place(f, whole, (real)(((float)k + 0.5f) / (float)ESTIMATE_NODES));
        node[k] = rod_node(f, view, shape, v[k]);
    }
    for (int i = 0; i < ESTIMATE_ANGLES; ++i)
        for (int k = 0; k < ESTIMATE_NODES; ++k) {
            RodNode n = node[k];
            real over = R(1.0) / fmax(n.sine, REAL_EPSILON), furthest = n.D + fmax(fabs(n.foot), fabs(view.eye_length - n.foot));
            real w = fmin(n.D * over, furthest), u = fmin(fmax(fma(-n.D * n.cosine, over, n.foot), R(0.0)), view.eye_length);
            real value = colour_left(media, u * f.scale, v[k] * f.scale, w * f.scale) * n.angle;
            if (media.lobes) value = value * guide_phase(media.g_eye, media.g_light, n.cosine, fma(n.across, n.sine, -view.slope * n.cosine));
            sum = sum + value;
            node[k] = turned_node(n);
        }
    return whole.potential * sum * (real)(1.0f / (float)(ESTIMATE_NODES * ESTIMATE_ANGLES));
}

/// Sum over channels of the integral over the light of colour x cosine x phase function x transmittance / w^2, per unit of length, times 4 pi. p: the light's
/// origin seen from the point.
PURE real surface_rod_estimate(real3 p, real3 b, real length, real3 n, EstimateMedia media)
{
    real3 from = make_real3(-p.x, -p.y, -p.z);
    real sum = R(0.0), over_distance = R(0.0);
    for (int k = 0; k < ESTIMATE_NODES; ++k) {
        AngleSample at = sample_equiangular(from, b, length, (real)(((float)k + 0.5f) / (float)ESTIMATE_NODES));
        real3 d = along3(p, at.u, b);
        real w = length3(d), over = R(1.0) / fmax(w, REAL_SMALLEST);
        real value = (ESTIMATE_ANY_NORMAL + fmax(dot3(n, d) * over, R(0.0))) * colour_left(media, R(0.0), at.u, w);
        if (media.lobes) value = value * guide_phase(R(0.0), media.g_light, R(1.0), -dot3(b, d) * over);
        sum = sum + value, over_distance = at.angle_over_distance;
    }
    return over_distance * sum * (real)(1.0f / (float)ESTIMATE_NODES);
}

#endif
