#include "scene/mesh_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "scene/transforms.hpp"

namespace tyndall {

namespace {

/// A directed edge of a triangle, between welded vertices.
struct Edge {
    std::uint32_t low, high;  ///< its ends, sorted
    bool ascending;           ///< runs from low to high
    std::uint32_t triangle, opposite;
};

std::vector<Edge> sorted_edges(const Mesh& mesh)
{
    const std::vector<std::uint32_t> weld = welded_vertices(mesh);
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3 corner(weld[mesh.triangles[t].x], weld[mesh.triangles[t].y], weld[mesh.triangles[t].z]);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = corner[k], to = corner[(k + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), from < to, static_cast<std::uint32_t>(t), corner[(k + 2) % 3]});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::array<std::uint64_t, 3>{a.low, a.high, a.ascending} < std::array<std::uint64_t, 3>{b.low, b.high, b.ascending};
    });
    return edges;
}

Vec3 unit_normal(const Mesh& mesh, const glm::uvec3& triangle)
{
    const Vec3 &a = mesh.vertices[triangle.x], cross = glm::cross(mesh.vertices[triangle.y] - a, mesh.vertices[triangle.z] - a);
    const double length = glm::length(cross);
    return length > 0 ? cross / length : Vec3(0);  // without area: behind it lies everything
}

bool all_behind_all(const Mesh& mesh, double tolerance)
{
    for (const glm::uvec3& triangle : mesh.triangles) {
        const Vec3 normal = unit_normal(mesh, triangle), corner = mesh.vertices[triangle.x];
        for (const Vec3& vertex : mesh.vertices)
            if (!(glm::dot(normal, vertex - corner) <= tolerance)) return false;
    }
    return true;
}

/// Across every edge the neighbour's far corner lies behind the plane, by the edge's own size when the mesh is fine: a shallow dent must
/// not pass.
bool convex_at_edges(const Mesh& mesh, double tolerance, bool relative_to_edge)
{
    const std::vector<Edge> edges = sorted_edges(mesh);
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        const glm::uvec3& triangle = mesh.triangles[edges[i].triangle];
        const double size = relative_to_edge ? glm::length(mesh.vertices[edges[i].high] - mesh.vertices[edges[i].low]) : 1;
        if (!(glm::dot(unit_normal(mesh, triangle), mesh.vertices[edges[i + 1].opposite] - mesh.vertices[triangle.x]) <= tolerance * size))
            return false;
    }
    return true;
}

/// Every triangle faces away from the mesh's middle, and together they cover the sphere around it once. With convexity at the edges that is
/// convexity: seen from the middle, the surface is a graph over the sphere, and it bends inwards nowhere.
bool star_shaped_once(const Mesh& mesh)
{
    Vec3 middle(0);
    for (const Vec3& vertex : mesh.vertices) middle += vertex / static_cast<double>(mesh.vertices.size());
    double solid_angle = 0;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const Vec3 a = mesh.vertices[triangle.x] - middle, b = mesh.vertices[triangle.y] - middle, c = mesh.vertices[triangle.z] - middle;
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c), volume = glm::dot(a, glm::cross(b, c));
        if (!(volume >= 0)) return false;
        // [Van Oosterom and Strackee 1983]
        solid_angle += 2 * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return std::abs(solid_angle - 4 * std::numbers::pi) < 1e-3;  // a whole number of turns: far from the next
}

template <class T>
void keep(std::vector<T>& values, const std::vector<std::uint32_t>& kept)
{
    if (values.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];
    values.resize(kept.size());
}

/// A vertex of no triangle must not count for bounds or convexity.
void drop_unused_vertices(Mesh& mesh)
{
    std::vector<std::uint32_t> new_index(mesh.vertices.size(), 0), kept;
    for (const glm::uvec3& triangle : mesh.triangles)
        for (int k = 0; k < 3; ++k) new_index[triangle[k]] = 1;
    for (std::uint32_t i = 0; i < new_index.size(); ++i)
        if (std::exchange(new_index[i], static_cast<std::uint32_t>(kept.size())) == 1) kept.push_back(i);
    if (kept.size() == mesh.vertices.size()) return;
    for (glm::uvec3& triangle : mesh.triangles) triangle = {new_index[triangle.x], new_index[triangle.y], new_index[triangle.z]};
    keep(mesh.vertices, kept);
    keep(mesh.normals, kept);
    keep(mesh.uvs, kept);
}

}  // namespace

Mesh rectangle_mesh()
{
    return {.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
            .uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
            .triangles = {{0, 1, 2}, {0, 2, 3}}};
}

Mesh cube_mesh()
{
    // One axis of the cube for each of u and v, forwards (+) or backwards, is Mitsuba's map of the face.
    struct Face {
        std::array<int, 4> corners;  ///< bits: x, y, z
        Vec3 u, v;
    };
    constexpr int x = 1, y = 2, z = 4;
    const std::array<Face, 6> faces{{{{0, z, y + z, y}, {0, 1, 0}, {0, 0, 1}},
                                     {{x, x + y, x + y + z, x + z}, {0, 1, 0}, {0, 0, -1}},
                                     {{0, x, x + z, z}, {0, 0, 1}, {1, 0, 0}},
                                     {{y, y + z, x + y + z, x + y}, {-1, 0, 0}, {0, 0, -1}},
                                     {{0, y, x + y, x}, {0, -1, 0}, {1, 0, 0}},
                                     {{z, x + z, x + y + z, y + z}, {0, 1, 0}, {1, 0, 0}}}};
    Mesh mesh;
    for (const Face& face : faces) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const int corner : face.corners) {
            const Vec3 vertex(corner & x ? 1 : -1, corner & y ? 1 : -1, corner & z ? 1 : -1);
            mesh.vertices.push_back(vertex);
            mesh.uvs.emplace_back((1 + glm::dot(vertex, face.u)) / 2, (1 + glm::dot(vertex, face.v)) / 2);
        }
        mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
    }
    return mesh;
}

void transform_mesh(Mesh& mesh, const Mat4& to_world)
{
    const glm::dmat3 linear(to_world), for_normals = glm::transpose(glm::inverse(linear));
    for (Vec3& vertex : mesh.vertices) vertex = transform_point(to_world, vertex);
    for (Vec3& normal : mesh.normals) normal = glm::normalize(for_normals * normal);
    if (glm::determinant(linear) < 0)
        for (glm::uvec3& triangle : mesh.triangles) std::swap(triangle.y, triangle.z);
}

std::vector<std::uint32_t> welded_vertices(const Mesh& mesh)
{
    std::vector<std::uint32_t> order(mesh.vertices.size()), weld(mesh.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b];
        if (p.x != q.x) return p.x < q.x;
        if (p.y != q.y) return p.y < q.y;
        return p.z != q.z ? p.z < q.z : a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
        weld[order[i]] = same ? weld[order[i - 1]] : order[i];
    }
    return weld;
}

bool is_closed(const Mesh& mesh)
{
    const std::vector<Edge> edges = sorted_edges(mesh);
    if (edges.empty() || edges.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < edges.size(); i += 2) {
        const Edge &a = edges[i], &b = edges[i + 1];
        const bool pair = a.low == b.low && a.high == b.high && a.ascending != b.ascending;
        const bool third = i + 2 < edges.size() && edges[i + 2].low == a.low && edges[i + 2].high == a.high;
        if (!pair || third) return false;
    }
    return true;
}

bool is_convex(const Mesh& mesh)
{
    Bounds bounds;
    for (const Vec3& vertex : mesh.vertices) bounds.grow(vertex);
    const double tolerance = convexity_tolerance * 2 * bounds.radius();
    // Up to a tenth of a second the definition itself is asked.
    constexpr double few = 1e8;
    const bool small = static_cast<double>(mesh.vertices.size()) * static_cast<double>(mesh.triangles.size()) <= few;
    if (!convex_at_edges(mesh, small ? tolerance : convexity_tolerance, !small)) return false;
    return small ? all_behind_all(mesh, tolerance) : star_shaped_once(mesh);
}

void classify_mesh(Mesh& mesh)
{
    const std::vector<std::uint32_t> weld = welded_vertices(mesh);
    std::erase_if(mesh.triangles,
                  [&](const glm::uvec3& t) { return weld[t.x] == weld[t.y] || weld[t.y] == weld[t.z] || weld[t.z] == weld[t.x]; });
    drop_unused_vertices(mesh);
    mesh.closed = is_closed(mesh);
    mesh.convex = mesh.closed && is_convex(mesh);
}

}  // namespace tyndall
