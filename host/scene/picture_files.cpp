#include "scene/picture_files.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tyndall {
namespace {

constexpr std::string_view png_start = "\x89PNG\r\n\x1a\n", exr_start = "\x76\x2f\x31\x01";

void check_values(const Picture& picture)
{
    const std::size_t row = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        if (!std::isfinite(picture.values[i]))
            throw PictureFault(fmt::format("pixel ({}, {}) is {}; every value must be a finite number", i % row / static_cast<std::size_t>(picture.channels), i / row, picture.values[i]));
}

void drop_equal_channels(Picture& picture)
{
    if (picture.channels != 3) return;
    for (std::size_t i = 0; i < picture.values.size(); i += 3)
        if (picture.values[i] != picture.values[i + 1] || picture.values[i] != picture.values[i + 2]) return;
    for (std::size_t i = 0; 3 * i < picture.values.size(); ++i) picture.values[i] = picture.values[3 * i];
    picture.values.resize(picture.values.size() / 3), picture.channels = 1;
}

}  // namespace

void check_picture_size(std::int64_t width, std::int64_t height)
{
    if (width < 1 || height < 1) throw PictureFault(fmt::format("says that it has {} x {} pixels; it needs at least one", width, height));
    if (width > most_pixels || height > most_pixels || width * height > most_pixels)
        throw PictureFault(fmt::format("says that it has {} x {} pixels; {} are possible", width, height, most_pixels));
}

double linear_from_srgb(double encoded) { return encoded <= .04045 ? encoded / 12.92 : std::pow((encoded + .055) / 1.055, 2.4); }

Picture read_picture(std::string_view bytes)
{
    if (!bytes.starts_with(png_start) && !bytes.starts_with(exr_start)) throw PictureFault("is neither a PNG nor an OpenEXR file");
    Picture picture = bytes.starts_with(png_start) ? read_png_picture(bytes) : read_exr_picture(bytes);
    check_values(picture);
    drop_equal_channels(picture);
    return picture;
}

}  // namespace tyndall
