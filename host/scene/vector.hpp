#pragma once
/// Host mathematics is GLM in double. GLM types never cross into kernels/.
#include <glm/glm.hpp>

namespace tyndall {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Rgb = glm::dvec3;  ///< linear, red green blue
using Mat4 = glm::dmat4;

}  // namespace tyndall
