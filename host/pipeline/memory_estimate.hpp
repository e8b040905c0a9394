#pragma once
/// Memory that a render will take, estimated before anything is allocated.
#include <vector>

#include "pipeline/build_masks.hpp"
#include "report/explanation.hpp"

namespace tyndall {

inline constexpr std::size_t eye_chunk = 1u << 19;  ///< eyes on the device at a time: 32 MiB of records

/// Film, pass image and eye records on the host; eyes, lights, sums and tiles on the device. `lights`: per pass, aimed at. One eye segment and one eye point per
/// pixel are assumed: mirrors, glass and several containers make more.
std::vector<MemoryReport> estimate_memory(const Scene& scene, const RenderSettings& settings, const LayerPlan& plan, const BuildMasks& masks, std::uint32_t lights);

}  // namespace tyndall
