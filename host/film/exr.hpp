#pragma once
/// OpenEXR files: any number of named channels, attributes, data and display window. The one place of host/film that knows OpenEXR.
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace tyndall {

/// One channel, row-major, top row first.
struct ExrChannel {
    std::vector<float> values;
    /// Stored as 16-bit float (11 bits of precision, at most 65504). A channel with a larger value is written as 32-bit float all the same:
    /// nothing is clamped.
    bool half = false;
};

using ExrAttribute = std::variant<std::string, int, double>;

struct ExrImage {
    int x = 0, y = 0, width = 0, height = 0;     ///< data window: what `channels` hold, within the display window
    int display_width = 0, display_height = 0;   ///< display window: the whole film
    std::map<std::string, ExrChannel> channels;  ///< "R", "media_to_media.R", ...
    std::map<std::string, ExrAttribute> attributes;
};

/// Writes atomically (film/atomic_file.hpp), ZIP compressed, one part, rows top to bottom. Equal images give equal bytes. Throws IoError.
void write_exr(const std::filesystem::path& file, const ExrImage& image);

/// From now on images are compressed in so many threads of this process, which stay; their bytes are the same. For programs: OpenEXR's threads are shared by all who use it, so a library keeps its hands off.
void compress_exr_in_threads(int threads);

/// Reads every channel of a one-part scan-line or tiled file as float. Attributes of other types than ExrAttribute's are left out.
/// Throws IoError for what is missing, incomplete, damaged, deep, multi-part, subsampled or too large to be true for its file size.
ExrImage read_exr(const std::filesystem::path& file);

}  // namespace tyndall
