#pragma once
#include <string>

#include "scene/scene.hpp"

namespace tyndall {

/// A scene as JSON ("schema": "tyndall-scene/1"): film, media, shapes, emitters, BSDFs by name and type, warnings. Lengths and coefficients
/// are in the scene file's units; the hash is text.
std::string to_json(const Scene& scene);

}  // namespace tyndall
