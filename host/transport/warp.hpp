#pragma once
/// From the unit square to simple domains. Each sample_x has its density beside it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/vector.hpp"

namespace tyndall {

inline constexpr double pi = std::numbers::pi;
inline constexpr double pdf_uniform_sphere = 1 / (4 * pi);  ///< per steradian

/// Unit vector at polar cosine `z` (clamped to [-1, 1] against rounding) and azimuth 2 pi `turn` around +z.
inline Vec3 spherical(double z, double turn)
{
    const double c = std::clamp(z, -1.0, 1.0), r = std::sqrt((1 - c) * (1 + c)), phi = 2 * pi * turn;
    return {r * std::cos(phi), r * std::sin(phi), c};
}

/// Uniform on the unit sphere.
inline Vec3 sample_uniform_sphere(const Vec2& xi) { return spherical(1 - 2 * xi.x, xi.y); }

/// Uniform in the unit disk, z = 0.
inline Vec3 sample_uniform_disk(const Vec2& xi)
{
    const double r = std::sqrt(xi.x), phi = 2 * pi * xi.y;
    return {r * std::cos(phi), r * std::sin(phi), 0};
}

/// Proportional to the cosine on the hemisphere z >= 0; density z / pi.
inline Vec3 sample_cosine_hemisphere(const Vec2& xi)
{
    const Vec3 p = sample_uniform_disk(xi);
    return {p.x, p.y, std::sqrt(1 - xi.x)};
}
inline double pdf_cosine_hemisphere(double cosine) { return std::max(cosine, 0.0) / pi; }

/// 1 - cos of `angle` without cancellation: the solid angle of a cone of that half angle is 2 pi times it.
inline double one_minus_cos(double angle)
{
    const double s = std::sin(.5 * angle);
    return 2 * s * s;
}

/// Uniform in the cone around +z whose 1 - cos of the half angle is `height`; density 1 / (2 pi height).
inline Vec3 sample_uniform_cone(double height, const Vec2& xi)
{
    const double h = xi.x * height, r = std::sqrt(h * (2 - h)), phi = 2 * pi * xi.y;
    return {r * std::cos(phi), r * std::sin(phi), 1 - h};
}
inline double pdf_uniform_cone(double height) { return 1 / (2 * pi * height); }

/// Barycentric coordinates of vertices 1 and 2, uniform over the triangle.
inline Vec2 sample_uniform_triangle(const Vec2& xi)
{
    const double root = std::sqrt(xi.x);
    return {root * (1 - xi.y), root * xi.y};
}

/// The interval's inner position of xi, after it chose the interval [low, high): in [0, 1).
inline double rescale(double xi, double low, double high) { return std::clamp((xi - low) / (high - low), 0.0, 0x1.fffffffffffffp-1); }

/// Power heuristic with exponent 2 of two densities of the same measure [Veach 1997, 9.2.4], as a ratio: no overflow, no 0/0 unless both
/// are 0.
inline double mis_weight(double pdf, double other)
{
    if (pdf >= other) {
        const double ratio = other / pdf;
        return 1 / (1 + ratio * ratio);
    }
    const double ratio = pdf / other;
    return ratio * ratio / (1 + ratio * ratio);
}

}  // namespace tyndall
