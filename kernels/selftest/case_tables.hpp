#pragma once
/// What cases of kernels/selftest/evaluate.h refer to besides their inputs: voxels and values, lobes of phase functions, grids. Made up, fixed for ever; the host
/// and every device read the same.
#include <array>
#include <cstddef>
#include <span>

#include "kernels/shared/records.hpp"

namespace tyndall {

namespace case_tables {

/// A number in [0, 1), a multiple of 2^-10, without any pattern.
constexpr float jumbled(std::uint32_t i)
{
    std::uint32_t x = (i + 1u) * 2654435761u;
    x ^= x >> 15, x *= 2246822519u, x ^= x >> 13;
    return float(x >> 22) * 0x1p-10f;
}

inline constexpr std::array<float, 10> phase_table{.0625f, .03125f, .015625f, 0, 0, 0, .00625f, .03125f, .09375f, .28125f};
inline constexpr std::uint32_t spike_values = 201, spike_at = 140;  ///< the one at cosine .4 alone is not small

/// First value of each part.
inline constexpr std::uint32_t first_phase = 0, first_spike = first_phase + 10, first_pair = first_spike + spike_values, first_holes = first_pair + 2, first_sheared = first_holes + 5 * 4 * 3,
                               first_coloured = first_sheared + 4 * 6 * 3, value_count = first_coloured + 3 * 3 * 4 * 3;

constexpr std::array<float, value_count> make_values()
{
    std::array<float, value_count> v{};
    for (std::uint32_t i = 0; i < phase_table.size(); ++i) v[first_phase + i] = phase_table[i];
    for (std::uint32_t i = 0; i < spike_values; ++i) v[first_spike + i] = i == spike_at ? 15.f : .01f;
    v[first_pair] = 0, v[first_pair + 1] = 1;
    for (std::uint32_t i = first_holes; i < first_sheared; ++i) v[i] = jumbled(i) < .4f ? 0.f : 3 * jumbled(2 * i);  // two voxels in five are empty
    for (std::uint32_t i = first_sheared; i < value_count; ++i) v[i] = .125f + 2 * jumbled(i);
    return v;
}
inline constexpr std::array<float, value_count> values = make_values();

inline constexpr PhaseLobeRecord lobes[] = {
    {PHASE_LOBE_RAYLEIGH, 1, 0, 0, 0, 0, 0, 0},
    {PHASE_LOBE_TABLE, 1, .5f, first_phase, 10, 0, 0, 0},
    {PHASE_LOBE_HENYEY_GREENSTEIN, .5f, .99f, 0, 0, 0, 0, 0},
    {PHASE_LOBE_HENYEY_GREENSTEIN, .5f, -.99f, 0, 0, 0, 0, 0},
    {PHASE_LOBE_RAYLEIGH, .25f, 0, 0, 0, 0, 0, 0},
    {PHASE_LOBE_TABLE, .25f, .5f, first_phase, 10, 0, 0, 0},
    {PHASE_LOBE_HENYEY_GREENSTEIN, .5f, .75f, 0, 0, 0, 0, 0},
    {PHASE_LOBE_TABLE, 1, .05f, first_spike, spike_values, 0, 0, 0},
};

/// Four voxels per unit of length around the origin, so that coordinates of cases are exact; the third is sheared and nowhere special.
inline constexpr GridRecord grids[] = {
    {4, 0, 0, 1, 0, 4, 0, .5f, 0, 0, 4, .5f, 2, 1, 1, first_pair},
    {4, 0, 0, 2.5f, 0, 4, 0, 2, 0, 0, 4, 1.5f, 5, 4, 3, first_holes},
    {9.5f, -1.25f, .75f, 2, -2.5f, 11, -1.5f, 3.25f, .5f, 2.25f, 7.75f, 1.5f, 4, 6, 3, first_sheared},
    {4, 0, 0, 1.5f, 0, 4, 0, 1.5f, 0, 0, 4, 2, 3, 3, 4, first_coloured},
};

}  // namespace case_tables
}  // namespace tyndall
