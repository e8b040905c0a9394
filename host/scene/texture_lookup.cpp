#include "scene/texture_lookup.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall {
namespace {

/// The texel that stands at position `i` of an axis of `size`.
std::size_t wrapped(double i, int size, Texture::Wrap wrap)
{
    const double n = size;
    if (wrap == Texture::Wrap::clamp) return static_cast<std::size_t>(std::clamp(i, 0.0, n - 1));
    if (wrap == Texture::Wrap::repeat) return static_cast<std::size_t>(std::clamp(i - n * std::floor(i / n), 0.0, n - 1));
    const double turn = i - 2 * n * std::floor(i / (2 * n));
    return static_cast<std::size_t>(std::clamp(turn < n ? turn : 2 * n - 1 - turn, 0.0, n - 1));
}

Rgb texel(const Texture& texture, double x, double y)
{
    const std::size_t column = wrapped(x, texture.width, texture.wrap), row = wrapped(y, texture.height, texture.wrap), channels = static_cast<std::size_t>(texture.channels);
    const float* value = texture.texels.data() + (row * static_cast<std::size_t>(texture.width) + column) * channels;
    return channels == 1 ? Rgb(value[0]) : Rgb(value[0], value[1], value[2]);
}

Rgb bitmap_at(const Texture& texture, const Vec2& uv)
{
    const Vec2 place = uv * Vec2(texture.width, texture.height);
    if (texture.filter == Texture::Filter::nearest) return texel(texture, std::floor(place.x), std::floor(place.y));
    const Vec2 low = glm::floor(place - .5), share = place - .5 - low;
    const Rgb above = (1 - share.x) * texel(texture, low.x, low.y) + share.x * texel(texture, low.x + 1, low.y);
    const Rgb below = (1 - share.x) * texel(texture, low.x, low.y + 1) + share.x * texel(texture, low.x + 1, low.y + 1);
    return (1 - share.y) * above + share.y * below;
}

}  // namespace

Rgb texture_at(const Texture& texture, const Vec2& uv)
{
    const Vec2 place(texture.to_uv * glm::dvec4(uv, 0, 1));
    if (!std::isfinite(place.x) || !std::isfinite(place.y)) return texture.type == Texture::Type::bitmap ? texel(texture, 0, 0) : texture.even;
    if (texture.type == Texture::Type::bitmap) return bitmap_at(texture, place);
    const Vec2 part = place - glm::floor(place);
    return (part.x > .5) == (part.y > .5) ? texture.even : texture.odd;
}

}  // namespace tyndall
