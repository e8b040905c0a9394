#include "scene/containers.hpp"

#include <algorithm>

#include "scene/text.hpp"

namespace tyndall {
namespace {

constexpr std::size_t most_planes = 64;  ///< a container with more is walked on the host: the kernel's loop over planes would cost more

/// The distinct planes of a convex mesh; nothing if there are more than a kernel should loop over.
std::optional<std::vector<HalfSpace>> planes_of(const Mesh& mesh)
{
    std::vector<HalfSpace> planes;
    for (const glm::uvec3& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t.x], &b = mesh.vertices[t.y], &c = mesh.vertices[t.z];
        const Vec3 n = glm::cross(b - a, c - a);
        const double area = glm::length(n);
        if (area == 0) continue;
        const HalfSpace plane{n / area, glm::dot(n / area, (a + b + c) / 3.0)};
        const bool known = std::any_of(planes.begin(), planes.end(), [&](const HalfSpace& p) {
            return glm::distance(p.normal, plane.normal) < 1e-7 && std::abs(p.offset - plane.offset) < 1e-9;  // two triangles of one facet, in double
        });
        if (!known) planes.push_back(plane);
        if (planes.size() > most_planes) return std::nullopt;
    }
    // The mesh may be wound inwards: its centre is inside.
    const Bounds bounds = [&] { Bounds b; for (const Vec3& v : mesh.vertices) b.grow(v); return b; }();
    for (HalfSpace& p : planes)
        if (glm::dot(p.normal, bounds.centre()) > p.offset) p.normal = -p.normal, p.offset = -p.offset;
    return planes;
}

/// Why the shape cannot be a container beside the others; empty if it can.
std::string why_no_container(const Scene& scene, const Shape& shape, const std::vector<Container>& others)
{
    if (!is_null(scene, shape)) return "is a surface and a boundary of a medium at once";
    if (shape.exterior != vacuum) return "has a medium outside";
    if (shape.type != Shape::Type::mesh) return "is round";
    if (!shape.mesh.closed) return "is not closed";
    if (!shape.mesh.convex) return "is not convex";
    if (shape.flip_normals) return "has flipped normals";
    for (const Container& other : others)
        if (boxes_overlap(bounds_of(shape), bounds_of(scene.shapes[static_cast<std::size_t>(other.shape)]), 0)) return "may overlap another boundary";
    return {};
}

/// Sets the obstacle where camera or a light says that it is in a medium that no container holds.
void check_refs(const Scene& scene, ContainerSearch& search)
{
    const auto known = [&](int medium) {
        return medium == vacuum || std::any_of(search.containers.begin(), search.containers.end(), [&](const Container& c) { return c.medium == medium; });
    };
    if (search.containers.empty()) return;
    if (!known(scene.camera.medium)) search.obstacle = "the sensor is in a medium that no boundary holds", search.where = scene.camera.where;
    for (const Emitter& emitter : scene.emitters)
        if (search.convex() && !known(emitter.medium)) search.obstacle = "emitter " + in_quotes(emitter.name) + " is in a medium that no boundary holds", search.where = emitter.where;
}

}  // namespace

bool is_null(const Scene& scene, const Shape& shape)
{
    return scene.bsdfs[static_cast<std::size_t>(shape.bsdf)].type == Bsdf::Type::null;
}

bool boxes_overlap(const Bounds& a, const Bounds& b, double slack)
{
    for (int axis = 0; axis < 3; ++axis)
        if (a.high[axis] <= b.low[axis] + slack || b.high[axis] <= a.low[axis] + slack) return false;
    return true;
}

bool flat_and_outermost(const Scene& scene, const Shape& shape)
{
    if (shape.type != Shape::Type::mesh || shape.mesh.triangles.empty()) return false;
    const auto planes = planes_of(shape.mesh);
    if (!planes || planes->empty()) return false;
    const HalfSpace plane = planes->front();
    const auto off_plane = [&](const Vec3& v) { return std::abs(glm::dot(plane.normal, v) - plane.offset) > 1e-7; };
    if (std::any_of(shape.mesh.vertices.begin(), shape.mesh.vertices.end(), off_plane)) return false;
    bool above = false, below = false;
    for (const Shape& other : scene.shapes) {
        if (&other == &shape) continue;  // its own corners lie on the plane, those of its box need not
        const Bounds b = bounds_of(other);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 v{corner & 1 ? b.high.x : b.low.x, corner & 2 ? b.high.y : b.low.y, corner & 4 ? b.high.z : b.low.z};
            const double side = glm::dot(plane.normal, v) - plane.offset;
            above |= side > 1e-7, below |= side < -1e-7;
        }
    }
    return !(above && below);
}

ContainerSearch find_containers(const Scene& scene)
{
    ContainerSearch search;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        if (!shape.medium_boundary || (shape.interior == vacuum && shape.exterior == vacuum)) continue;
        std::string why = why_no_container(scene, shape, search.containers);
        auto planes = why.empty() ? planes_of(shape.mesh) : std::nullopt;
        if (why.empty() && !planes) why = "has more than " + std::to_string(most_planes) + " sides";
        if (!why.empty()) return {{}, "shape " + in_quotes(shape.name) + " " + why, shape.where};
        search.containers.push_back({shape.interior, static_cast<int>(i), std::move(*planes)});
    }
    check_refs(scene, search);
    if (!search.convex()) search.containers.clear();
    return search;
}

}  // namespace tyndall
