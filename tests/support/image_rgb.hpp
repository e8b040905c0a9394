#pragma once
/// Images as tests read them.
#include <filesystem>
#include <string>
#include <vector>

#include "scene/vector.hpp"

namespace tyndall::test {

/// Row-major, top row first.
struct ImageRgb {
    int width = 0, height = 0;
    std::vector<Vec3> pixels;

    Vec3& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
    const Vec3& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
};

/// The beauty (R, G, B) of an EXR file, or one of its layers ("media_to_media", "variance", ...). A file with the single channel Y is grey.
/// Throws IoError if it cannot be read or lacks the channels.
ImageRgb read_rgb(const std::filesystem::path& file, const std::string& layer = "");

/// The sum of several layers of one file.
ImageRgb read_layers(const std::filesystem::path& file, const std::vector<std::string>& layers);

}  // namespace tyndall::test
