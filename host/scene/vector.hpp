#pragma once
/// Host mathematics is GLM in double. GLM types never cross into kernels/.
#include <algorithm>

#include <glm/glm.hpp>

namespace tyndall {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Rgb = glm::dvec3;  ///< linear, red green blue
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;

inline double largest(const Rgb& c) { return std::max({c.r, c.g, c.b}); }
inline double sum(const Rgb& c) { return c.r + c.g + c.b; }

}  // namespace tyndall
