#pragma once
/// Images out of OpenEXR files, as they are compared: one layer or the sum of several, with what the file says of noise and origin.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/vector.hpp"

namespace tyndall {

struct ImageFile {
    std::filesystem::path file;
    int x = 0, y = 0, width = 0, height = 0;  ///< data window within the display window, pixels
    std::vector<Rgb> pixels;                  ///< row-major, top row first; finite
    std::vector<Rgb> variance;                ///< of every value, from the channels `variance.R/G/B`; empty: the file, or a layer of it, has none
    std::string scene_hash, method;           ///< attributes `tyndall.scene_hash` and `tyndall.method`; empty: none
};

/// The image (no layer named, or "image": channels R, G and B) or the sum of layers (channels <layer>.R ...). Throws IoError for a file that cannot be read, SceneError for a layer
/// that is not there (the message lists those that are) and for values that are not finite (it names the first).
ImageFile load_image_file(const std::filesystem::path& file, const std::vector<std::string>& layers);

/// The layers of tyndall/layer.hpp that the file has, by name. Throws as load_image_file does.
std::map<std::string, std::vector<Rgb>> load_known_layers(const std::filesystem::path& file);

/// Throws SceneError, naming both files, if they do not show the same window of pixels.
void require_same_window(const ImageFile& image, const ImageFile& reference);

}  // namespace tyndall
