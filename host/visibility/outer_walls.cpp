#include "visibility/outer_walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyndall {
namespace {

constexpr double tolerance = 1e-7;  ///< of a plane that several triangles lie in, in render space: their corners are rounded to float

using HalfSpace = OuterWalls::HalfSpace;

Vec3 rounded(const Vec3& p) { return Vec3(glm::vec3(p)); }
double above(const HalfSpace& h, const Vec3& p) { return glm::dot(Vec3(h.x, h.y, h.z), p) - h.offset; }

/// Is every corner that the shape lies between accepted? Vertices of its triangles, or the corners of the box around an analytic shape.
template <class Accept>
bool every_corner(const Shape& shape, Accept&& accept)
{
    if (shape.type == Shape::Type::mesh) return std::all_of(shape.mesh.vertices.begin(), shape.mesh.vertices.end(), accept);
    const Bounds b = bounds_of(shape);
    for (int corner = 0; corner < 8; ++corner)
        if (!accept(Vec3{corner & 1 ? b.high.x : b.low.x, corner & 2 ? b.high.y : b.low.y, corner & 4 ? b.high.z : b.low.z})) return false;
    return true;
}

/// The triangle's plane, turned so that the scene is inside of it if it is on one side at all; false if it is on both, or the triangle has no area.
bool bounds_all(const Mesh& mesh, const glm::uvec3& t, std::span<const Shape* const> solids, HalfSpace& found)
{
    const Vec3 a = rounded(mesh.vertices[t.x]), n = glm::cross(rounded(mesh.vertices[t.y]) - a, rounded(mesh.vertices[t.z]) - a);
    const double area = glm::length(n);
    if (!(area > 0)) return false;
    for (const double sign : {1., -1.}) {  // whichever way it is wound
        const glm::vec3 unit(sign / area * n);
        found = {unit.x, unit.y, unit.z, static_cast<float>(glm::dot(Vec3(unit), a))};
        const auto inside = [&](const Vec3& p) { return above(found, p) <= tolerance; };
        if (std::all_of(solids.begin(), solids.end(), [&](const Shape* s) { return every_corner(*s, inside); })) return true;
    }
    return false;
}

double surface(const Bounds& box)
{
    const Vec3 d = glm::max(box.high - box.low, Vec3(0));
    return d.x * d.y + d.y * d.z + d.z * d.x;
}

bool same_plane(const HalfSpace& a, const HalfSpace& b)
{
    return glm::distance(Vec3(a.x, a.y, a.z), Vec3(b.x, b.y, b.z)) < tolerance && std::abs(a.offset - b.offset) < tolerance;
}

}  // namespace

OuterWalls::OuterWalls(std::span<const Shape* const> solids)
{
    for (const Shape* shape : solids) {
        if (shape->type != Shape::Type::mesh || shape->mesh.triangles.size() > most_triangles) continue;
        for (const glm::uvec3& t : shape->mesh.triangles) {
            HalfSpace plane;
            if (half_spaces_.size() == most_planes || !bounds_all(shape->mesh, t, solids, plane)) continue;
            if (std::none_of(half_spaces_.begin(), half_spaces_.end(), [&](const HalfSpace& known) { return same_plane(known, plane); })) half_spaces_.push_back(plane);
        }
    }
    for (HalfSpace& plane : half_spaces_) {  // no corner of a triangle in this plane is inside, exactly
        double least = plane.offset;
        for (const Shape* shape : solids)
            for (const glm::uvec3& t : shape->mesh.triangles)
                if (beyond(plane, shape->mesh, t))
                    for (int i = 0; i < 3; ++i) least = std::min(least, above(plane, rounded(shape->mesh.vertices[t[i]])) + plane.offset);
        plane.offset = std::nextafter(static_cast<float>(least), -std::numeric_limits<float>::infinity());
    }
    if (!pay(solids)) half_spaces_.clear();
}

/// Rays through the box around what is left are what is still traced: walls pay if it is smaller.
bool OuterWalls::pay(std::span<const Shape* const> solids) const
{
    constexpr double share = .9;  // of the surface: the test of a packet costs a few percent of its rays
    Bounds all, left;
    for (const Shape* shape : solids) {
        const Bounds b = bounds_of(*shape);
        all.grow(b.low), all.grow(b.high);
        if (shape->type != Shape::Type::mesh) left.grow(b.low), left.grow(b.high);
        for (const glm::uvec3& t : others(shape->mesh))
            for (int i = 0; i < 3; ++i) left.grow(shape->mesh.vertices[t[i]]);
    }
    return surface(left) < share * surface(all);
}

/// Within the tolerance of the plane; what `half_spaces_` then makes exact.
bool OuterWalls::beyond(const HalfSpace& plane, const Mesh& mesh, const glm::uvec3& t) const
{
    for (int i = 0; i < 3; ++i)
        if (above(plane, rounded(mesh.vertices[t[i]])) < -tolerance) return false;
    return true;
}

std::vector<glm::uvec3> OuterWalls::others(const Mesh& mesh) const
{
    std::vector<glm::uvec3> kept;
    const auto wall = [&](const HalfSpace& plane, const glm::uvec3& t) {
        for (int i = 0; i < 3; ++i)
            if (above(plane, rounded(mesh.vertices[t[i]])) < 0) return false;
        return true;
    };
    for (const glm::uvec3& t : mesh.triangles)
        if (std::none_of(half_spaces_.begin(), half_spaces_.end(), [&](const HalfSpace& plane) { return wall(plane, t); })) kept.push_back(t);
    return kept;
}

bool OuterWalls::hold(const ShadowPacket& p, const int (&valid)[SHADOW_PACKET_SIZE]) const
{
    constexpr int lanes = SHADOW_PACKET_SIZE;
    float to_x[lanes], to_y[lanes], to_z[lanes], slack[lanes];
    for (int i = 0; i < lanes; ++i) {
        to_x[i] = p.origin_x[i] + p.direction_x[i], to_y[i] = p.origin_y[i] + p.direction_y[i], to_z[i] = p.origin_z[i] + p.direction_z[i];
        // Three products, three sums and the rounding of the end itself: at most 4 times 2^-24 of the magnitudes' sum.
        slack[i] = 0x1p-22f * (std::fabs(p.origin_x[i]) + std::fabs(p.origin_y[i]) + std::fabs(p.origin_z[i]) +
                               std::fabs(p.direction_x[i]) + std::fabs(p.direction_y[i]) + std::fabs(p.direction_z[i]));
    }
    int outside = 0;
    for (const HalfSpace& h : half_spaces_)
        for (int i = 0; i < lanes; ++i) {
            const float from = h.x * p.origin_x[i] + h.y * p.origin_y[i] + h.z * p.origin_z[i], to = h.x * to_x[i] + h.y * to_y[i] + h.z * to_z[i];
            const float most = from > to ? from : to;
            outside |= valid[i] & -static_cast<int>(!(most + slack[i] < h.offset));
        }
    return outside == 0;
}

}  // namespace tyndall
