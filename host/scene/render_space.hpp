#pragma once
/// Render space: the scene moved so that the centre of its bounds is the origin, and scaled by a power of two so that the half diagonal of
/// its bounds lies in (1/2, 1]. Every epsilon of the tracing code is then relative to 1, whatever the scene's units.
#include "scene/scene.hpp"

namespace tyndall {

/// Takes a scene in the units of its file there, and sets `centre` and `unit`. What has a length in it follows: positions, clip distances;
/// extinctions (1/m) are multiplied by `unit`; point and spot intensities (W/sr, whose irradiance falls with distance squared) are divided
/// by unit squared. Radiances, irradiances and angles stay. A scene whose bounds are one point keeps unit 1. Throws SceneError if the scene
/// is larger than 1e100, smaller than 1e-100, or if an intensity leaves what double can hold.
void to_render_space(Scene& scene);

/// A render-space position in the scene file's units.
inline Vec3 to_file_space(const Scene& scene, const Vec3& p) { return scene.centre + scene.unit * p; }

}  // namespace tyndall
