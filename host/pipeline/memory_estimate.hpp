#pragma once
/// Memory that a render will take, estimated before anything is allocated.
#include <vector>

#include "pipeline/build_masks.hpp"
#include "report/explanation.hpp"

namespace tyndall {

/// Eyes on the device at a time, a multiple of eye_alignment: 32 MiB of records; with tables of what lies along them 16 MiB (48 MiB) of those.
std::size_t eyes_at_a_time(std::uint32_t features);

/// Estimates of one light for one square of pixels on the device at a time: 64 MiB with their ticks.
inline constexpr std::size_t estimates_at_a_time = 1u << 23;

/// Numbers of near lights that are listed at a time, if all of them are near: 64 MiB.
inline constexpr std::size_t near_numbers_at_a_time = 1u << 24;

/// Film, pass image and eye records on the host; eyes, lights, sums and tiles on the device. One eye segment and one eye point per pixel and camera sample are
/// assumed: mirrors, glass and several containers make more.
std::vector<MemoryReport> estimate_memory(const Scene& scene, const RenderSettings& settings, const LayerPlan& plan, const BuildMasks& masks);

}  // namespace tyndall
