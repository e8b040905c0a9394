// Connections through density grids: two ways of drawing their places, and the transmittance of their three legs (kernels/README.md, section 13).
#ifndef GRID_CONNECTION_H
#define GRID_CONNECTION_H

#include "kernels/stages/light_table.h"

/// The exact value is computed for one in so many pairs of a group of eyes, and counts as often.
#define CORRECTION_PERIOD 64u

/// Salts of choices; any numbers that differ.
#define SALT_CORRECTION 0x51ed270bu
#define SALT_STRATEGY 0x2545f491u
#define SALT_SHIFT 0x68bc21ebu

/// Chance that a pair is drawn from the tables: grows from this optical depth of both rays together, by so much per unit, up to a most.
#define MATTER_FROM 1.0f
#define MATTER_SLOPE 0.1f
#define MATTER_MOST 0.05f

/// 32 random bits that all eyes of the group of EYE_GROUP share for a pair.
PURE uint shared_bits(const EyeGroup* around, uint counter, uint salt) { return mix_scalar(around->key + mix_scalar(counter ^ salt)); }

/// Mean grey optical depth of a light; nothing lies along a point.
PURE float depth_of_light(Surroundings s, Light light, uint number)
{
    if (!LIGHT_IS_LINE) return 0.0f;
    MediumRecord m = medium_of(s, light);
    __global const float* end = s.light_tables + (size_t)number * TABLE_FLOATS + TABLE_INTERVALS;
    float red = end[0], green = COLOURED_GRIDS ? end[TABLE_NODES] : red, blue = COLOURED_GRIDS ? end[2u * TABLE_NODES] : red;
    return (m.sigma_t_r * red + m.sigma_t_g * green + m.sigma_t_b * blue) / 3.0f;
}

/// Chance that a pair is drawn from the tables, from the optical depths of both rays.
PURE float share_of_matter(const EyeGroup* around, Surroundings s, Light light, uint number)
{
    if (medium_of(s, light).density_grid == NO_GRID) return 0.0f;
    float depth = depth_of_light(s, light, number);
    if (!(LIGHT_IS_LINE | EYES_HAVE_TABLES)) return 0.0f;                // two points: there is nothing to draw
    if (LIGHT_IS_LINE && !(depth > 0.0f)) return 0.0f;
    if (EYES_HAVE_TABLES && !(around->depth > 0.0f)) return 0.0f;
    return fmin(MATTER_SLOPE * fmax(depth + around->depth - MATTER_FROM, 0.0f), MATTER_MOST);
}

/// Which pairs are drawn from the tables: bit i stands for the pair counter + i.
PURE uint pairs_by_matter(const EyeGroup* around, Surroundings s, __global const Light* lights, uint counter, uint count, uint samples)
{
    uint pairs = 0u;
    for (uint i = 0; i < count; ++i) {
        uint number = light_in_slot(around, (counter + i) / samples).number;
        float share = share_of_matter(around, s, lights[number], number);
        if (share > 0.0f && (float)(shared_bits(around, counter + i, SALT_STRATEGY) >> 8) * 0x1p-24f < share) pairs |= 1u << i;
    }
    return pairs;
}

/// What was passed along a light up to a place.
PURE Passed passed_on_light(Surroundings s, Light light, uint number, real v)
{
    Passed none = {make_real3(R(0.0), R(0.0), R(0.0)), make_real3(R(0.0), R(0.0), R(0.0))};
    return LIGHT_IS_LINE ? passed(table_of_light(s, light, number), v) : none;
}

/// Both places of such a pair, weighed as if the other way of drawing had placed them.
APART OnBoth place_by_matter(Eye eye, const EyeGroup* around, Light light, Surroundings s, uint number, Random2 xi)
{
    MediumRecord medium = medium_of(s, light);
    real v = R(0.0);
    if (LIGHT_IS_LINE) v = sample_matter(table_of_light(s, light, number), sigma_t_of(medium), (real)light_length(light), light_is_even(light), xi.first);
    return find_eye(eye, &around->table, light, medium, phase_tables(s), find_light(eye, light, medium, v), xi.second);
}

PURE OnBoth share_with_matter(Eye eye, const EyeGroup* around, Surroundings s, Light light, uint number, OnBoth at, Passed to_eye, Passed to_light)
{
    float share = share_of_matter(around, s, light, number);
    if (!(share > 0.0f)) return at;
    MatterDensity on_light = {R(1.0), R(0.0)};                         // a point is where it is
    if (LIGHT_IS_LINE) {
        real mass = (real)s.light_tables[(size_t)number * TABLE_FLOATS + TABLE_FLOATS - 1u];
        on_light = matter_density(to_light, sigma_t_of(medium_of(s, light)), mass, light_is_even(light));
    }
    return share_pair(eye, around->over_mass, light, at, to_eye, on_light, (real)share);
}

/// The connection with all that grids have a part in.
PURE Connection with_matter(Eye eye, const EyeGroup* around, Light light, Surroundings s, OnBoth at, Matter on_eye, Matter on_light,
                                     MarchShift shift, uint exact)
{
    MediumRecord medium = medium_of(s, light);
    Connection c = connect_eye(eye, light, medium, phase_tables(s), at, on_eye, on_light);
    Leg leg = {c.from, sub3(c.to, c.from), c.length, shift, exact};
    c.radiance = mul3(c.radiance, transmittance3(leg_depth(&around->facing, s, medium, leg)));
    return c;
}
PURE Connection exactly(Eye eye, const EyeGroup* around, Light light, Surroundings s, OnBoth at, uint number)
{
    return with_matter(eye, around, light, s, at, exact_matter_at_eye(s, &around->media, eye, &around->table, at),
                       exact_matter_on_light(s, medium_of(s, light), light, number, at.v), march_shift((bits)(0u)), 1u);
}

/// A connection whose transmittances are approximate, unless TRANSMITTANCE says exact; what scatters at its ends is exact.
PURE Connection connect_in_grids(Eye eye, const EyeGroup* around, Light light, Surroundings s, OnBoth at, uint number, uint counter)
{
    MediumRecord medium = medium_of(s, light);
    Passed to_light = passed_on_light(s, light, number, at.v), to_eye = passed_to_eye(eye, &around->table, at);
    at = share_with_matter(eye, around, s, light, number, at, to_eye, to_light);
    if (TRANSMITTANCE == TRANSMITTANCE_EXACT) return exactly(eye, around, light, s, at, number);
    Matter on_eye = matter_at_eye(s, &around->media, eye, at, to_eye.path);
    Matter on_light = even_matter(R(0.0));
    if (LIGHT_IS_LINE) on_light.path = to_light.path, on_light.scattering = scattering_at(s, medium, along3(light_origin(light), at.v, light_direction(light)));
    return with_matter(eye, around, light, s, at, on_eye, on_light, march_shift(mix_lanes(eye.key + mix_scalar(counter ^ SALT_SHIFT))), 0u);
}

/// Which pairs are corrected: bit i stands for the pair counter + i.
PURE uint corrected_pairs(const EyeGroup* around, uint counter, uint count)
{
    uint pairs = 0u;
    for (uint i = 0; i < count; ++i)
        if (shared_bits(around, counter + i, SALT_CORRECTION) % CORRECTION_PERIOD == 0u) pairs |= 1u << i;
    return pairs;
}

/// Radiance of such a pair: approximate + CORRECTION_PERIOD (exact - approximate), unbiased whatever the approximation.
APART real3 corrected_radiance(Eye eye, const EyeGroup* around, Light light, Surroundings s, OnBoth at, uint number, real3 approximate)
{
    at = share_with_matter(eye, around, s, light, number, at, passed_to_eye(eye, &around->table, at), passed_on_light(s, light, number, at.v));
    real3 error = sub3(exactly(eye, around, light, s, at, number).radiance, approximate);
    return along3(approximate, (real)(float)CORRECTION_PERIOD, error);
}

#endif
