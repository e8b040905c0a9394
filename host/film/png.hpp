#pragma once
/// The picture beside the EXR: 8-bit sRGB PNG, tone-mapped. The one place that knows libpng.
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "scene/vector.hpp"

namespace tyndall {

/// Writes `image` (row-major, top row first, linear) through `tone_map` (film/tone_map.hpp) at the exposure in stops. Atomic; throws
/// IoError.
void write_png(const std::filesystem::path& file, std::span<const Rgb> image, int width, double exposure);

/// The bytes of a PNG with these 8-bit RGB values, row-major, top row first; width x height x 3 of them. Throws IoError, with `name` for the picture.
std::string encode_png(std::span<const std::uint8_t> pixels, int width, int height, const std::string& name);

}  // namespace tyndall
