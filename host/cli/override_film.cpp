#include <fmt/format.h>

#include "cli/render_command.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

/// The film takes about 350 bytes a pixel with every layer: 2^26 pixels (8192 x 8192) are 23 GB.
constexpr std::int64_t most_pixels = std::int64_t(1) << 26;

struct Interval {
    int low, size;
};

/// [low, low + size) of `before` pixels, on `after` pixels, rounded outward.
Interval scaled(Interval interval, int before, int after)
{
    const auto low = std::int64_t(interval.low) * after / before;
    const auto high = (std::int64_t(interval.low + interval.size) * after + before - 1) / before;
    return {static_cast<int>(low), static_cast<int>(high - low)};
}

void resize(Camera& camera, int width, int height)
{
    const auto x = scaled({camera.crop_x, camera.crop_width}, camera.width, width);
    const auto y = scaled({camera.crop_y, camera.crop_height}, camera.height, height);
    camera.crop_x = x.low, camera.crop_width = x.size, camera.crop_y = y.low, camera.crop_height = y.size;
    camera.width = width, camera.height = height;
}

void set_crop(Camera& camera, const Crop& crop)
{
    if (crop.x + crop.width > camera.width || crop.y + crop.height > camera.height)
        throw UsageError(fmt::format("--crop {},{},{},{}: must lie in the film of {} x {} pixels", crop.x, crop.y, crop.width, crop.height,
                                     camera.width, camera.height));
    camera.crop_x = crop.x, camera.crop_y = crop.y, camera.crop_width = crop.width, camera.crop_height = crop.height;
}

}  // namespace

void override_film(Camera& camera, const std::optional<std::pair<int, int>>& resolution, const std::optional<Crop>& crop)
{
    if (resolution) resize(camera, resolution->first, resolution->second);
    if (crop) set_crop(camera, *crop);
    if (std::int64_t(camera.crop_width) * camera.crop_height > most_pixels)
        throw UsageError(fmt::format("{} x {} pixels are more than the {} that one render may have; render parts with --crop",
                                     camera.crop_width, camera.crop_height, most_pixels));
}

}  // namespace tyndall
