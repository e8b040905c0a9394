#pragma once
/// What can be rendered but is probably not meant, or not by this method; found by looking around in the scene with rays.
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "tyndall/settings.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

/// A light that reaches nothing, a medium that the camera does not see, an extinction for which virtual ray lights are the wrong tool, a medium on another scale
/// than the scene. Each with file:line:column and what to do. The same for the same scene: its random numbers are fixed.
std::vector<std::string> doubts_about(const Scene& scene, const RenderSettings& settings, const Visibility& visibility);

}  // namespace tyndall
