#pragma once
/// What the voxels of volumes amount to.
#include <cstddef>
#include <optional>

#include "scene/scene.hpp"

namespace tyndall {

inline std::size_t voxel_count(const Volume& volume)
{
    return static_cast<std::size_t>(volume.size_x) * static_cast<std::size_t>(volume.size_y) * static_cast<std::size_t>(volume.size_z);
}

/// Of the voxels, per channel; the same three times if there is one channel.
struct VolumeStatistics {
    Rgb least{0}, mean{0}, largest{0};
    std::size_t bytes = 0;  ///< of memory
};
VolumeStatistics statistics_of(const Volume& volume);

/// Extinction where the medium is densest; per unit of render-space length.
Rgb largest_extinction(const Scene& scene, const Medium& medium);

/// The same values on a grid of as many more voxels of the same size as let its box hold that of `inner`; the new voxels have the values of the old outermost
/// ones, so nothing changes inside the old box, and outside of it the values are those of its nearest face. Nothing if it would take more than `most` voxels.
/// A box that is too small by no more than rounding is left alone.
std::optional<Volume> reaching_over(const Volume& volume, const Volume& inner, double most);

}  // namespace tyndall
