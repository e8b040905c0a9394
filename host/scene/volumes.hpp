#pragma once
/// <volume> elements: gridvolume, openvdbvolume, constvolume.
#include "scene/scene_builder.hpp"

namespace tyndall {

/// What a parameter is that may vary in space: one value, or the voxels of a grid.
struct VolumeValue {
    Rgb constant{0};              ///< if there are no voxels
    std::optional<Volume> voxels;
};

/// The parameter of a medium that may be written as <rgb>, <float>, or as a nested <volume>; not negative. `to_world` maps to the units of the file.
VolumeValue read_varying(SceneBuilder& builder, Properties& properties, const std::string& name, const Rgb& fallback);

/// Adds a volume to the scene and returns its index; one that is already there, from the same element and with the same voxels, is taken again.
int add_volume(SceneBuilder& builder, Volume volume);

inline constexpr double most_voxels = 1u << 31;  ///< values of all volumes of a scene: kernels count them in 32 bits

}  // namespace tyndall
