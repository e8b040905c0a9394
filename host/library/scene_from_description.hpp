#pragma once
/// The public description of a scene as the renderer's own.
#include "library/checked_values.hpp"
#include "scene/scene.hpp"
#include "tyndall/scene_description.hpp"

namespace tyndall {

/// Checks and copies everything, moves it to render space and adds the warnings that a scene file would get. Throws SceneError, which names the element.
Scene scene_from(const api::SceneDescription& description);

/// Adds one medium and its voxels, in the caller's units.
void add_medium(const api::Medium& from, const Place& place, Scene& scene);

}  // namespace tyndall
