#pragma once
/// A volume as kernels see it.
#include <cstddef>

#include "kernels/shared/records.hpp"
#include "scene/scene.hpp"

namespace tyndall {

/// `first`: number of its first voxel in the table of voxels.
GridRecord grid_record(const Volume& volume, std::size_t first);

}  // namespace tyndall
