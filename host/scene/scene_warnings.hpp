#pragma once
/// What is probably not meant, though it can be rendered.
#include "scene/scene_builder.hpp"

namespace tyndall {

/// A medium that nothing refers to; a container that is not closed; a camera or a light that stands in a medium without its ref; no light
/// at all; what warn_of_grids says.
void add_warnings(SceneBuilder& builder);

/// A grid of density that lies outside of the shapes that hold its medium, or sticks out of them. Told from nine places in its box.
void warn_of_grids(SceneBuilder& builder);

/// The medium at `to`, found from the medium at `from` by crossing every medium boundary on the straight line between them. Needs no
/// acceleration structure: the loader calls it once per light.
int medium_at(const Scene& scene, const Vec3& from, int medium, const Vec3& to);

/// The medium far away from everything, found by crossing every boundary between the camera and there. The scene is in render space.
int outermost_medium(const Scene& scene);

}  // namespace tyndall
