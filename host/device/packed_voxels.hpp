#pragma once
/// Voxels as the fast lookup reads them (kernels/volumes/grid_march.h).
#include <cstdint>
#include <vector>

#include "device/pair_stage.hpp"

namespace tyndall {

/// For each voxel, at its place in `tables.voxels`, a word: itself in the lower half, its neighbour ahead in x (itself at the end of a row) in the upper half, each
/// the upper half of a float, rounded to nearest. Words that belong to no grid are 0.
std::vector<std::uint32_t> packed_voxels(const MediaTables& tables);

}  // namespace tyndall
