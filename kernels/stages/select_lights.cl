// Selection, after estimate_lights: which share of the choice each light has in each square of pixels, and `slots` lights for every group of EYE_GROUP eyes
// (kernels/README.md, section 16).
#include "kernels/math/random.h"
#include "kernels/shared/eye_block.h"
#include "kernels/shared/light_choice.h"

/// Probabilities are whole numbers of ticks, so that they add up without rounding: what a light is divided by is what it was chosen with.
#define ALL_TICKS R(0x1p30)
#define POOLED_LIGHTS 256u  // per work-item of pool_shares

typedef struct {
    float total;      ///< power of all lights
    float defence;
} PowerShare;
PURE PowerShare power_share(__global const float* powers, uint count, float defence)
{
    PowerShare p = {0.0f, defence};
    for (uint i = 0; i < count; ++i) p.total += powers[i];
    if (!(p.total > 0.0f)) p.defence = 0.0f;
    return p;
}

/// Ticks of every light for LANES blocks; returns their sums. An estimate below 0 forbids the light; any other gives at least one tick.
PURE bits fill_ticks(__global const float* estimates, __global const float* powers, PowerShare power, uint count, __global uint* ticks)
{
    real sum = R(0.0);
    for (uint i = 0; i < count; ++i) sum = sum + fmax(load_lanes(estimates, i), R(0.0));
    mask lit = sum > REAL_SMALLEST;
    real over = select(R(1.0), sum, lit), by_estimate = select(R(0.0), R(1.0) - (real)power.defence, lit);
    bits total = (bits)(0u);
    for (uint i = 0; i < count; ++i) {
        real estimate = load_lanes(estimates, i), by_power = (real)(power.defence > 0.0f ? powers[i] / power.total * power.defence : 0.0f);
        real share = fma(estimate / over, by_estimate, by_power);
        bits q = to_bits(select(R(0.0), fma(fmin(share, R(1.0)), ALL_TICKS, R(1.0)), estimate >= R(0.0)));
        store_bits(q, 0, ticks + (size_t)i * LANES);
        total += q;
    }
    return total;
}

/// Shares follow the estimates and, for the part `defence`, power alone. One work-item per LANES standing eyes; ticks lie as the estimates do, totals are their sums.
__kernel void weigh_lights(uint groups, uint count, float defence, __global const float* estimates, __global const float* powers, __global uint* ticks,
                           __global uint* totals)
{
    uint group = (uint)get_global_id(0);
    if (group >= groups) return;
    size_t first = (size_t)group * count * LANES;
    store_bits(fill_ticks(estimates + first, powers, power_share(powers, count, defence), count, ticks + first), group, totals);
}

/// Strata of a block, in the order of the lights: for every slot one for each of its groups, out of parts x groups.
typedef struct {
    EyeBlock block;
    uint slots;
    ulong step;   ///< 2^64 / (slots x parts x groups)
} Strata;

/// Which of `count` neighbouring strata something takes in a slot: random, the same for all that share the key.
PURE uint rotation(uint key, uint slot, uint count) { return mix_scalar(key ^ mix_scalar(~slot)) % count; }

/// A place in the block's stratum, in ticks: uniform over the stratum.
PURE uint place_in(Strata s, uint stratum, uint total)
{
    EyeBlock b = s.block;
    uint slot = stratum / b.groups, of_all = (slot * b.parts + (b.part + rotation(b.key, slot, b.parts)) % b.parts) * b.groups + stratum % b.groups;
    uint high = mix_scalar(b.key + mix_scalar(of_all)), low = mix_scalar(high ^ 0x9e3779b9u);
    return (uint)mul_hi((ulong)of_all * s.step + mul_hi(((ulong)high << 32) | low, s.step), (ulong)total);
}

/// Lights for one block, by one walk over all lights. Each group takes a random one of its slot's strata.
PURE void choose_for_block(__global const uint* ticks, __global const float* weights, uint count, uint total, Strata s, __global LightChoice* choices)
{
    EyeBlock b = s.block;
    uint strata = b.groups * s.slots, stratum = 0u, below = 0u, place = place_in(s, 0u, total);
    for (uint i = 0; i < count && stratum < strata; ++i) {
        uint q = ticks[(size_t)i * LANES];
        below += q;
        while (stratum < strata && place < below) {
            uint slot = stratum / b.groups, group = (stratum + rotation(b.key + b.part + 1u, slot, b.groups)) % b.groups;
            LightChoice choice = {i, (float)total / ((float)(s.slots * b.parts) * (float)q) * weights[i]};
            choices[(b.first + group) * s.slots + slot] = choice;
            ++stratum;
            place = place_in(s, stratum, total);
        }
    }
    for (; stratum < strata; ++stratum) {                                   // no light is allowed
        LightChoice nothing = {0u, 0.0f};
        choices[(b.first + stratum % b.groups) * s.slots + stratum / b.groups] = nothing;
    }
}

/// For a region of many squares: the mean share of each light over `eyes` eyes that stand for it. One work-item per POOLED_LIGHTS lights; total starts at 0.
__kernel void pool_shares(__global const uint* ticks, uint eyes, uint count, __global uint* pooled, __global uint* total)
{
    uint first = (uint)get_global_id(0) * POOLED_LIGHTS, sum = 0u;
    for (uint i = first; i < min(first + POOLED_LIGHTS, count); ++i) {
        ulong all = 0;
        for (uint eye = 0; eye < eyes; ++eye) all += ticks[((size_t)(eye / LANES) * count + i) * LANES + eye % LANES];
        uint mean = (uint)((all + eyes - 1u) / eyes);                      // upwards: no light that an eye needs is lost
        pooled[(size_t)i * LANES] = mean;
        sum += mean;
    }
    if (sum > 0u) atomic_add(total, sum);                                  // of whole numbers: in any order
}

/// One work-item per block. weights: as in estimate_lights.
__kernel void select_lights(__global const EyeBlock* blocks, uint block_count, __global const float* weights, uint count, uint slots, __global const uint* ticks,
                            __global const uint* totals, __global LightChoice* choices)
{
    if (get_global_id(0) >= block_count) return;
    EyeBlock block = blocks[get_global_id(0)];
    Strata s = {block, slots, 0xfffffffffffffffful / max(slots * block.parts * block.groups, 1u)};
    choose_for_block(ticks + ((size_t)(block.standing / LANES) * count) * LANES + block.standing % LANES, weights, count, totals[block.standing], s, choices);
}
