#include "visibility/exact_hit.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall {
namespace {

/// Roots of a t^2 + 2 b t + c = 0 given its reduced discriminant, without cancellation; ascending.
QuadricHits roots(double a, double b, double c, double discriminant)
{
    if (!(discriminant >= 0) || a == 0) return {};
    const double root = std::sqrt(discriminant), q = b > 0 ? -(b + root) : root - b;
    if (q == 0) return {.count = 1, .t = {0, 0}};
    const double one = q / a, other = c / q;
    return {.count = 2, .t = {std::min(one, other), std::max(one, other)}};
}

QuadricHits meet_sphere(const Vec3& o, const Vec3& d)
{
    const double a = glm::dot(d, d), b = glm::dot(o, d);
    const Vec3 foot = o - (b / a) * d;  // a (1 - |foot|^2) keeps the digits that b^2 - a c loses for a distant origin
    return roots(a, b, glm::dot(o, o) - 1, a * (1 - glm::dot(foot, foot)));
}

QuadricHits meet_cylinder(const Vec3& o, const Vec3& d)
{
    const double a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y, across = o.x * d.y - o.y * d.x;
    const QuadricHits line = roots(a, b, o.x * o.x + o.y * o.y - 1, a - across * across);
    QuadricHits hits;
    for (int i = 0; i < line.count; ++i) {
        const double z = o.z + line.t[i] * d.z;
        if (z >= 0 && z <= 1) hits.t[hits.count++] = line.t[i];
    }
    return hits;
}

QuadricHits meet_disk(const Vec3& o, const Vec3& d)
{
    if (d.z == 0) return {};
    const double t = -o.z / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
    if (!(x * x + y * y <= 1)) return {};
    return {.count = 1, .t = {t, 0}};
}

}  // namespace

bool meet_plane(const Mesh& mesh, unsigned triangle, const Ray& ray, TriangleHit& hit)
{
    const glm::uvec3 index = mesh.triangles[triangle];
    const Vec3 v0 = mesh.vertices[index.x], e1 = mesh.vertices[index.y] - v0, e2 = mesh.vertices[index.z] - v0;
    const Vec3 p = glm::cross(ray.direction, e2);
    const double determinant = glm::dot(e1, p);
    if (determinant == 0) return false;
    const Vec3 s = ray.origin - v0, q = glm::cross(s, e1);
    hit.t = glm::dot(e2, q) / determinant;
    hit.u = std::clamp(glm::dot(s, p) / determinant, 0.0, 1.0);
    hit.v = std::clamp(glm::dot(ray.direction, q) / determinant, 0.0, 1.0 - hit.u);
    return std::isfinite(hit.t);
}

QuadricHits meet_quadric(Shape::Type type, const Vec3& local_origin, const Vec3& local_direction)
{
    switch (type) {
        case Shape::Type::sphere:
            return meet_sphere(local_origin, local_direction);
        case Shape::Type::cylinder:
            return meet_cylinder(local_origin, local_direction);
        case Shape::Type::disk:
            return meet_disk(local_origin, local_direction);
        case Shape::Type::mesh:
            break;
    }
    return {};
}

Vec3 triangle_normal(const Mesh& mesh, unsigned triangle)
{
    const glm::uvec3 index = mesh.triangles[triangle];
    const Vec3 v0 = mesh.vertices[index.x];
    return glm::normalize(glm::cross(mesh.vertices[index.y] - v0, mesh.vertices[index.z] - v0));
}

Vec3 onto_quadric(Shape::Type type, const Vec3& p)
{
    switch (type) {
        case Shape::Type::sphere:
            return glm::normalize(p);
        case Shape::Type::cylinder:
            return Vec3(glm::normalize(Vec2(p)), p.z);
        default:
            return {p.x, p.y, 0};
    }
}

Vec3 quadric_normal(Shape::Type type, const Vec3& p)
{
    switch (type) {
        case Shape::Type::sphere:
            return p;
        case Shape::Type::cylinder:
            return {p.x, p.y, 0};
        default:
            return {0, 0, 1};
    }
}

}  // namespace tyndall
