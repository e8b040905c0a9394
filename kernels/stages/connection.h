// What every stage of the pair pipeline shares: placing and connecting batches of pairs, and sums.
#ifndef CONNECTION_H
#define CONNECTION_H

#include "kernels/stages/sums.h"

/// Pairs that are taken through one step together: the steps of one pair depend on each other, the same step of several pairs does not, and a processor
/// that executes out of order fills the waits of one with the others (bench: 1.4 times the pairs per second of one pair after another). Devices that hide
/// waits by threads take one at a time.
enum { PAIR_BATCH = LANES == 1 ? 1 : 8 };

/// The two numbers of a pair.
PURE Random2 numbers_of_pair(Eye eye, uint counter)
{
    return SEQUENCE == SEQUENCE_SOBOL ? scrambled_sobol2(eye.key, counter) : random2(eye.key, counter);
}

/// Where `count` <= PAIR_BATCH connections run, of the pairs with the numbers counter, counter + 1, ...: number / samples is the slot of the light. What few pairs need
/// has a loop of its own, so that it takes no registers from the others.
PURE void place_pairs(OnBoth* places, Eye eye, const EyeGroup* around, __global const Light* lights, Surroundings s, uint counter, uint count,
                               uint samples)
{
    OnLight on_light[PAIR_BATCH];
    real second[PAIR_BATCH];
    uint by_matter = HETEROGENEOUS ? pairs_by_matter(around, s, lights, counter, count, samples) : 0u;
    for (uint i = 0; i < count; ++i) {
        if (by_matter >> i & 1u) continue;
        Light light = lights[light_in_slot(around, (counter + i) / samples).number];
        Random2 xi = numbers_of_pair(eye, counter + i);
        on_light[i] = place_light(eye, light, medium_of(s, light), xi.first), second[i] = xi.second;
    }
    for (uint i = 0; i < count; ++i) {
        if (by_matter >> i & 1u) continue;
        Light light = lights[light_in_slot(around, (counter + i) / samples).number];
        places[i] = place_eye(eye, light, medium_of(s, light), phase_tables(s), on_light[i], second[i]);
    }
    for (uint i = 0; by_matter >> i != 0u; ++i) {
        uint number = light_in_slot(around, (counter + i) / samples).number;
        if (by_matter >> i & 1u) places[i] = place_by_matter(eye, around, lights[number], s, number, numbers_of_pair(eye, counter + i));
    }
}

/// One sample of one light for LANES eyes, with everything but visibility.
PURE Connection connect_pair(Eye eye, const EyeGroup* around, Light light, Surroundings s, OnBoth at, uint number, uint counter)
{
    if (HETEROGENEOUS) return connect_in_grids(eye, around, light, s, at, number, counter);
    MediumRecord medium = medium_of(s, light);
    Connection c = connect_eye(eye, light, medium, phase_tables(s), at, matter_to_eye(at), even_matter(at.v));
    Leg leg = {c.from, sub3(c.to, c.from), c.length, march_shift((bits)(0u)), 0u};
    c.radiance = mul3(c.radiance, transmittance3(leg_depth(&around->facing, s, medium, leg)));
    return c;
}

/// One sample of each pair of a batch, as place_pairs placed them, with everything but visibility.
PURE void connect_pairs(Connection* connections, Eye eye, const EyeGroup* around, __global const Light* lights, Surroundings s, const OnBoth* places,
                                 uint counter, uint count, uint samples)
{
    for (uint i = 0; i < count; ++i) {
        uint number = light_in_slot(around, (counter + i) / samples).number;
        connections[i] = connect_pair(eye, around, lights[number], s, places[i], number, counter + i);
    }
    if (!HETEROGENEOUS) return;
    if (TRANSMITTANCE == TRANSMITTANCE_EXACT) return;
    uint corrected = corrected_pairs(around, counter, count);
    for (uint i = 0; corrected >> i != 0u; ++i) {
        uint number = light_in_slot(around, (counter + i) / samples).number;
        if (corrected >> i & 1u) connections[i].radiance = corrected_radiance(eye, around, lights[number], s, places[i], number, connections[i].radiance);
    }
}

/// A connection's radiance, with its ledger. What is not finite is counted (0: how many, 1 and 2: the first eye and counter) and taken out of the sum; pairs
/// under the floor are counted (3) and stay.
PURE real3 counted_radiance(Eye eye, const EyeGroup* around, __global const Light* lights, Connection c, uint samples, uint vertex_limit, uint counter,
                            __global uint* ledger)
{
    SlotLight slot = light_in_slot(around, counter / samples);
    if (SELECTION) c.radiance = scale3(c.radiance, (real)slot.weight);
    if (DEPTH_LIMIT) {
        mask allowed = to_mask(eye.depth + light_depth(lights[slot.number]) + 2u <= vertex_limit);
        c.radiance = select3(make_real3(R(0.0), R(0.0), R(0.0)), c.radiance, allowed);
    }
    if (any_lane(c.floored)) atomic_add(&ledger[3], count_lanes(c.floored));
    mask finite = to_mask(isfinite(c.radiance.x + c.radiance.y + c.radiance.z));
    if (!all_lanes(finite)) {
        uint lanes = count_lanes(finite);
        if (atomic_add(&ledger[0], LANES - lanes) == 0u) ledger[1] = around->number * LANES, ledger[2] = counter;
        c.radiance = select3(make_real3(R(0.0), R(0.0), R(0.0)), c.radiance, finite);
    }
    return c.radiance;
}

/// A connection's radiance and the part of it that the clamp takes away (kernels/README.md, eq. 61).
typedef struct { real3 kept, removed; } ClampedRadiance;
PURE ClampedRadiance clamped_radiance(Connection c, real3 radiance)
{
    ClampedRadiance r = {radiance, make_real3(R(0.0), R(0.0), R(0.0))};
    if (!CLAMPS) return r;
    real share = fmin(c.length * c.length * (real)CLAMP, R(1.0));
    r.removed = scale3(radiance, R(1.0) - share), r.kept = scale3(radiance, share);
    return r;
}

#endif
