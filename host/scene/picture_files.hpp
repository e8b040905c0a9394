#pragma once
/// Pictures that a scene names, out of the bytes of PNG and EXR files. Sizes are checked before memory is asked for.
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall {

/// What is wrong with a picture: "is cut off". The loader adds the file and the place in the scene.
struct PictureFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Picture {
    int width = 0, height = 0;
    int channels = 1;            ///< 1 (grey) or 3 (r, g, b)
    std::vector<float> values;   ///< [y][x][channel], top row first, as the file has them: finite; of a PNG from 0 to 1
    bool encoded = false;        ///< by the sRGB curve (PNG); an EXR is linear
};

inline constexpr std::uintmax_t largest_picture_file = std::uintmax_t{1} << 30;
inline constexpr std::int64_t most_pixels = std::int64_t{1} << 26;  ///< of one picture: 8192 x 8192

/// PNG or EXR, by its first bytes. Alpha is left out. Three channels that are equal everywhere become one.
Picture read_picture(std::string_view bytes);

/// 1 to 16 bits, grey, coloured or with a palette.
Picture read_png_picture(std::string_view bytes);

/// One part, not deep: channels R, G and B, or one named Y, or one only. The data window is the picture.
Picture read_exr_picture(std::string_view bytes);

/// Throws unless 1 <= width, height and width x height <= most_pixels.
void check_picture_size(std::int64_t width, std::int64_t height);

/// Linear value of a value that is encoded by the sRGB curve (IEC 61966-2-1).
double linear_from_srgb(double encoded);

}  // namespace tyndall
