#include "transport/surface_place.hpp"

#include <algorithm>
#include <cmath>

#include "transport/warp.hpp"

namespace tyndall {
namespace {

/// In [0, 1).
double turn_of(double y, double x)
{
    const double turn = std::atan2(y, x) / (2 * pi);
    return turn < 0 ? turn + 1 : turn;
}

SurfacePlace place_on_mesh(const Mesh& mesh, unsigned primitive, const Vec3& position)
{
    const glm::uvec3 index = mesh.triangles[primitive];
    const Vec3 v0 = mesh.vertices[index.x], e1 = mesh.vertices[index.y] - v0, e2 = mesh.vertices[index.z] - v0, q = position - v0;
    const Vec3 normal = glm::cross(e1, e2);
    const double square = glm::dot(normal, normal);
    const double b1 = glm::dot(glm::cross(q, e2), normal) / square, b2 = glm::dot(glm::cross(e1, q), normal) / square;
    if (mesh.uvs.empty()) return {.uv = {b1, b2}};
    const Vec2 t0 = mesh.uvs[index.x], d1 = mesh.uvs[index.y] - t0, d2 = mesh.uvs[index.z] - t0;
    const double determinant = d1.x * d2.y - d1.y * d2.x;
    return {.uv = t0 + b1 * d1 + b2 * d2, .along_u = std::copysign(1.0, determinant) * (d2.y * e1 - d1.y * e2)};
}

}  // namespace

SurfacePlace place_on_surface(const Scene& scene, const Hit& hit)
{
    const Shape& shape = scene.shapes[static_cast<std::size_t>(hit.shape)];
    if (shape.type == Shape::Type::mesh) return place_on_mesh(shape.mesh, hit.primitive, hit.position);
    const Vec3 local(glm::inverse(shape.to_world) * glm::dvec4(hit.position, 1));
    const auto along = [&](const Vec3& direction) { return Vec3(shape.to_world * glm::dvec4(direction, 0)); };
    const double turn = turn_of(local.y, local.x), radius = std::hypot(local.x, local.y);
    switch (shape.type) {
        case Shape::Type::sphere: return {.uv = {turn, std::atan2(radius, local.z) / pi}, .along_u = along({-local.y, local.x, 0})};
        case Shape::Type::disk: return {.uv = {radius, turn}, .along_u = along({local.x, local.y, 0})};
        case Shape::Type::cylinder: return {.uv = {turn, local.z}, .along_u = along({-local.y, local.x, 0})};
        case Shape::Type::mesh: break;
    }
    return {};
}

}  // namespace tyndall
