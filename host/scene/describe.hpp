#pragma once
/// What was read from a scene file: for `tyndall info`.
#include <string>

#include "scene/scene.hpp"

namespace tyndall {

/// For people: camera, film, media with their optical thickness across the scene, shapes, emitters, bsdfs, warnings; lengths in the scene
/// file's units.
std::string describe(const Scene& scene);

/// As scene files call it.
const char* type_name(Bsdf::Type type);
const char* type_name(Emitter::Type type);

}  // namespace tyndall
