#pragma once
/// The public description of a scene as the renderer's own.
#include "scene/scene.hpp"
#include "tyndall/scene_description.hpp"

namespace tyndall {

/// Checks and copies everything, moves it to render space and adds the warnings that a scene file would get. Throws SceneError, which names the element.
Scene scene_from(const api::SceneDescription& description);

}  // namespace tyndall
