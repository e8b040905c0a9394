// Selection, first step: what each light sends, roughly, to each of the eyes that stand for a block of pixels. One work-item per LANES blocks and LIGHT_BLOCK lights.
#include "kernels/stages/pair_stage.h"

/// Density grids: the mean density along a light is what it scatters with. What lies around it is taken for a part of that, because lights are where matter is
/// (scenes/plume: .3 has a third of the variance of 1 on surfaces, and as much inside the plume). It bends the choice, not the image.
#define AROUND_LIGHTS 0.3f
PURE float density_around(Surroundings s, Light light, uint number)
{
    MediumRecord medium = medium_of(s, light);
    if (!HETEROGENEOUS) return 1.0f;
    if (medium.density_grid == NO_GRID) return 1.0f;
    if (!LIGHT_IS_LINE) {
        float density[LANES];
        store_lanes(grid_values(s, medium.density_grid, 0u, 0u, light_origin(light)).x, 0, density);
        return density[0];
    }
    float unit = (medium.sigma_t_r + medium.sigma_t_g + medium.sigma_t_b) / 3.0f * light_length(light);
    return unit > 0.0f ? depth_of_light(s, light, number) / unit : 0.0f;
}

/// A light that no path of the allowed length can join is never chosen: -1.
PURE real allowed_estimate(Eye eye, Light light, real estimate, uint vertex_limit)
{
    if (!DEPTH_LIMIT) return estimate;
    return select(R(-1.0), estimate, to_mask(eye.depth + light_depth(light) + 2u <= vertex_limit));
}

/// Lights first ... first + count - 1; estimates and powers are counted from the first of them. weights: what each light counts for, 1 unless it was chosen.
__kernel void estimate_lights(__global const EyeRecord* eyes, uint groups, __global const Light* lights, __global const float* weights, uint first_light, uint count,
                              uint vertex_limit, SURROUNDINGS_PARAMETERS, TABLES_PARAMETERS, __global float* estimates, __global float* powers)
{
    uint light_blocks = (count + LIGHT_BLOCK - 1u) / LIGHT_BLOCK, item = (uint)get_global_id(0), group = item / light_blocks, first = item % light_blocks * LIGHT_BLOCK;
    if (group >= groups) return;
    Surroundings s = SURROUNDINGS;
    Eye eye = load_eye(eyes, group, s);
    for (uint number = first; number < min(first + LIGHT_BLOCK, count); ++number) {
        Light light = lights[first_light + number];
        MediumRecord medium = medium_of(s, light);
        float density = density_around(s, light, first_light + number), counts = (LIGHT_IS_LINE ? density : 1.0f) * weights[first_light + number];  // a point's power has the density
        float around = HETEROGENEOUS && medium.density_grid != NO_GRID ? density * AROUND_LIGHTS : density;
        real estimate = estimate_light(eye, light, medium, (real)around) * (real)counts;
        estimate = select(R(0.0), fmin(estimate, R(1e30)), estimate > R(0.0));               // not a number: 0
        store_lanes(allowed_estimate(eye, light, estimate, vertex_limit), 0, estimates + ((size_t)group * count + number) * LANES);
        if (group > 0u) continue;
        float power[LANES];
        store_lanes(light_power(light, medium) * (real)counts, 0, power);
        powers[number] = power[0] > 0.0f ? fmin(power[0], 1e30f) : 0.0f;
    }
}
