#pragma once
/// Orthonormal bases.
#include <cmath>

#include "scene/vector.hpp"

namespace tyndall {

/// Right-handed orthonormal basis around a unit vector n, continuous but at n.z = 0 [Duff et al. 2017].
struct Frame {
    Vec3 s, t, n;

    explicit Frame(const Vec3& normal) : n(normal)
    {
        const double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
        s = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
        t = {b, sign + n.y * n.y * a, -n.y};
    }
    /// With s along the part of `tangent` that is perpendicular to the normal; the other constructor's if there is none.
    Frame(const Vec3& normal, const Vec3& tangent) : Frame(normal)
    {
        const Vec3 along = tangent - glm::dot(tangent, normal) * normal;
        const double length = glm::length(along);
        if (length > 1e-9 * glm::length(tangent)) s = along / length, t = glm::cross(n, s);  // 1e-9: what rounding leaves of a tangent along the normal
    }
    Vec3 to_world(const Vec3& local) const { return local.x * s + local.y * t + local.z * n; }
    Vec3 to_local(const Vec3& world) const { return {glm::dot(world, s), glm::dot(world, t), glm::dot(world, n)}; }
};

}  // namespace tyndall
