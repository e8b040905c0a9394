#include "library/pictures_from_description.hpp"

#include <algorithm>
#include <cmath>

#include "scene/environment_maps.hpp"

namespace tyndall {
namespace {

/// Tables of a map take twenty bytes for each pixel.
constexpr std::int64_t most_environment_pixels = std::int64_t{1} << 25;

/// Refuses texels that are not as many as the size says, or outside of [0, most].
void check_texels(const std::vector<float>& texels, int width, int height, int channels, float most, const char* range, const Place& place)
{
    place.require(width >= 1 && height >= 1, fmt::format("a picture of {} x {} pixels", width, height));
    const std::size_t columns = static_cast<std::size_t>(width), each = static_cast<std::size_t>(channels);
    place.require(texels.size() / each / columns == static_cast<std::size_t>(height) && texels.size() % (each * columns) == 0,
                  fmt::format("a picture of {} x {} pixels with {} channels has {} values", width, height, channels, texels.size()));
    for (std::size_t i = 0; i < texels.size(); ++i)
        place.require(texels[i] >= 0 && texels[i] <= most, fmt::format("pixel ({}, {}) is {}; {}", i / each % columns, i / each / columns, texels[i], range));
}

Rgb largest_of(const Texture& texture)
{
    if (texture.type == Texture::Type::checkerboard) return glm::max(texture.even, texture.odd);
    Rgb largest(0);
    for (std::size_t i = 0; i < texture.texels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (texture.channels == 1 || static_cast<std::size_t>(c) == i % 3) largest[c] = std::max(largest[c], double{texture.texels[i]});
    return largest;
}

Texture::Filter filter_of(api::Texture::Filter filter) { return filter == api::Texture::Filter::nearest ? Texture::Filter::nearest : Texture::Filter::bilinear; }

Texture::Wrap wrap_of(api::Texture::Wrap wrap)
{
    if (wrap == api::Texture::Wrap::mirror) return Texture::Wrap::mirror;
    return wrap == api::Texture::Wrap::clamp ? Texture::Wrap::clamp : Texture::Wrap::repeat;
}

}  // namespace

void add_texture(const api::Texture& from, const Place& place, Scene& scene)
{
    Texture texture{.name = from.name, .filter = filter_of(from.filter), .wrap = wrap_of(from.wrap)};
    if (from.type == api::Texture::Type::checkerboard) {
        texture.type = Texture::Type::checkerboard;
        texture.even = place.colour("even", from.even, 1), texture.odd = place.colour("odd", from.odd, 1);
    } else {
        place.require(from.channels == 1 || from.channels == 3, fmt::format("channels = {} must be 1 (grey) or 3", from.channels));
        check_texels(from.texels, from.width, from.height, from.channels, 1, "a surface reflects between 0 and 1 of the light", place);
        texture.width = from.width, texture.height = from.height, texture.channels = from.channels, texture.texels = from.texels;
    }
    const auto number = [&](std::size_t i) { return place.number("a number of to_uv", from.to_uv[i], -largest_coordinate, largest_coordinate); };
    texture.to_uv[0] = {number(0), number(3), 0, 0}, texture.to_uv[1] = {number(1), number(4), 0, 0}, texture.to_uv[3] = {number(2), number(5), 0, 1};
    texture.largest = largest_of(texture);
    scene.textures.push_back(std::move(texture));
}

void add_environment_map(const api::EnvironmentMap& from, const Place& place, Scene& scene)
{
    place.require(from.width >= 2 && from.height >= 2 && std::int64_t{from.width} * from.height <= most_environment_pixels,
                  fmt::format("a map of {} x {} pixels; it has at least 2 x 2, and at most {}", from.width, from.height, most_environment_pixels));
    check_texels(from.texels, from.width, from.height, 3, std::numeric_limits<float>::max(), "radiance is finite and not negative", place);
    EnvironmentMap map{.name = from.name, .width = from.width, .height = from.height, .texels = from.texels};
    prepare_environment(map);
    scene.environment_maps.push_back(std::move(map));
}

Mat3 turning_of(const api::Emitter& from, const Place& place)
{
    const Vec3 up = place.direction("up", from.up), middle = place.direction("middle", from.middle), across = glm::cross(up, middle);
    place.require(glm::length(across) > 1e-6, "up and middle are parallel, so that nothing says how the map is turned");  // 1e-6 of a turn: less than a pixel of any map
    const Vec3 x = glm::normalize(across);
    return {x, up, glm::cross(x, up)};
}

}  // namespace tyndall
