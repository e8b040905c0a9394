#pragma once
/// Textures and environment maps of a description.
#include "library/checked_values.hpp"
#include "scene/scene.hpp"

namespace tyndall {

/// Adds a texture. Throws SceneError.
void add_texture(const api::Texture& from, const Place& place, Scene& scene);

/// Adds a map. Throws SceneError.
void add_environment_map(const api::EnvironmentMap& from, const Place& place, Scene& scene);

/// The rotation from the space of an environment map, in which +y is up and +z the middle of the picture. Throws SceneError.
Mat3 turning_of(const api::Emitter& from, const Place& place);

}  // namespace tyndall
