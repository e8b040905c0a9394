#pragma once
/// Kernel text for the device compiler: one flat file, with #line, so that messages name our files and lines.
#include <map>
#include <string>

namespace tyndall {

/// Text of `path` ("kernels/stages/gather_lights.cl") with every `#include "..."` replaced by the file's text, each file once. Names in `substitutions`
/// stand for paths: {"LIGHT", "kernels/lights/virtual_ray_light.h"}. Throws BuildError if a file does not exist.
std::string flattened_kernel(const std::string& path, const std::map<std::string, std::string>& substitutions);

}  // namespace tyndall
