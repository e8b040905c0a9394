#pragma once
/// Colours over surfaces.
#include "scene/scene.hpp"

namespace tyndall {

/// The colour at texture coordinates `uv`, before Texture::to_uv. As Mitsuba 3 has it: a bitmap's first row is at v = 0, texel (x, y) has its centre at
/// ((x + 1/2) / width, (y + 1/2) / height); a checkerboard is `even` where both coordinates are in the same half of their unit.
Rgb texture_at(const Texture& texture, const Vec2& uv);

}  // namespace tyndall
