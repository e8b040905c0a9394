#pragma once
/// Intersections in double: Embree finds which primitive a ray meets, these say where.
#include <array>

#include "visibility/visibility.hpp"

namespace tyndall {

/// Where a line meets a triangle's plane: distance and barycentric coordinates of vertices 1 and 2, clamped to the triangle.
struct TriangleHit {
    double t, u, v;
};

/// False if the line lies in the triangle's plane or the triangle has no area. No test against the edges: Embree has decided that,
/// watertight.
bool meet_plane(const Mesh& mesh, unsigned triangle, const Ray& ray, TriangleHit& hit);

/// A point on an analytic shape in the shape's own space: up to two distances along the line, ascending.
struct QuadricHits {
    int count = 0;
    std::array<double, 2> t{};
};

/// sphere: |p| = 1; disk: z = 0, r <= 1; cylinder: r = 1, 0 <= z <= 1, without caps. The direction need not have unit length.
QuadricHits meet_quadric(Shape::Type type, const Vec3& local_origin, const Vec3& local_direction);

/// Unit outward normal of triangle `triangle` before flip_normals, by the right-hand rule of its vertices.
Vec3 triangle_normal(const Mesh& mesh, unsigned triangle);

/// The point nearest to `p` on the unit shape, for a `p` that is on it up to rounding.
Vec3 onto_quadric(Shape::Type type, const Vec3& p);

/// Outward normal of the unit shape at the point `p` on it.
Vec3 quadric_normal(Shape::Type type, const Vec3& p);

}  // namespace tyndall
