#include "film/png.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cassert>
#include <string>
#include <vector>

#include "film/atomic_file.hpp"
#include "film/tone_map.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

std::vector<std::uint8_t> tone_mapped(std::span<const Rgb> image, double exposure)
{
    std::vector<std::uint8_t> bytes(3 * image.size());
    for (std::size_t i = 0; i < image.size(); ++i)
        std::ranges::copy(tone_map(image[i], exposure), bytes.begin() + static_cast<std::ptrdiff_t>(3 * i));
    return bytes;
}

}  // namespace

// libpng's simplified interface: no callbacks, no long jumps through C++; 8-bit RGB in the sRGB space.
std::string encode_png(std::span<const std::uint8_t> pixels, int width, int height, const std::string& name)
{
    assert(width > 0 && height > 0 && pixels.size() == 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(width), png.height = static_cast<png_uint_32>(height);
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr))
        throw IoError(fmt::format("{}: libpng could not write the picture: {}", name, png.message));
    bytes.resize(size);
    return bytes;
}

void write_png(const std::filesystem::path& file, std::span<const Rgb> image, int width, double exposure)
{
    assert(width > 0 && !image.empty() && image.size() % static_cast<std::size_t>(width) == 0);
    const int height = static_cast<int>(image.size() / static_cast<std::size_t>(width));
    write_atomically(file, encode_png(tone_mapped(image, exposure), width, height, file.string()));
}

}  // namespace tyndall
