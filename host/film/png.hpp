#pragma once
/// The picture beside the EXR: 8-bit sRGB PNG, tone-mapped. The one place that knows libpng.
#include <filesystem>
#include <span>

#include "scene/vector.hpp"

namespace tyndall {

/// Writes `image` (row-major, top row first, linear) through `tone_map` (film/tone_map.hpp) at the exposure in stops. Atomic; throws
/// IoError.
void write_png(const std::filesystem::path& file, std::span<const Rgb> image, int width, double exposure);

}  // namespace tyndall
