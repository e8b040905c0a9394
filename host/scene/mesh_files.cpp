#include "scene/mesh_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scene/transforms.hpp"

namespace tyndall {

namespace {

bool usable(const Vec3& v)
{
    return std::abs(v.x) <= largest_coordinate && std::abs(v.y) <= largest_coordinate &&
           std::abs(v.z) <= largest_coordinate;  // false for NaN
}

Vec3 doubled_area_normal(const Mesh& mesh, const glm::uvec3& triangle)
{
    const Vec3& a = mesh.vertices[triangle.x];
    return glm::cross(mesh.vertices[triangle.y] - a, mesh.vertices[triangle.z] - a);
}

void complete_normals(Mesh& mesh)
{
    std::vector<Vec3> sums;
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        Vec3& normal = mesh.normals[i];
        if (normal != Vec3(0)) {
            normal = glm::normalize(normal / glm::max(glm::abs(normal.x), glm::max(glm::abs(normal.y), glm::abs(normal.z))));
            continue;
        }
        if (sums.empty()) {
            sums.assign(mesh.vertices.size(), Vec3(0));
            for (const glm::uvec3& triangle : mesh.triangles)
                for (int k = 0; k < 3; ++k) sums[triangle[k]] += doubled_area_normal(mesh, triangle);
        }
        const double length = glm::length(sums[i]);
        normal = length > 0 ? sums[i] / length : Vec3(0, 0, 1);  // the last: of no triangle with an area, so nobody looks at it
    }
}

}  // namespace

bool add_polygon(Mesh& mesh, std::span<const std::uint32_t> corners)
{
    Vec3 whole(0);
    const std::size_t first = mesh.triangles.size();
    for (std::size_t i = 2; i < corners.size(); ++i) {
        mesh.triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
        whole += doubled_area_normal(mesh, mesh.triangles.back());
    }
    for (std::size_t i = first; corners.size() > 3 && i < mesh.triangles.size(); ++i) {
        const double against = glm::dot(doubled_area_normal(mesh, mesh.triangles[i]), whole);
        // A polygon that is flat within 1e-6 of its size has no triangle that turns back by more.
        if (against < -1e-6 * glm::dot(whole, whole)) return true;
    }
    return false;
}

void finish_mesh(MeshFile& file, std::size_t concave_polygons)
{
    Mesh& mesh = file.mesh;
    if (mesh.triangles.empty()) throw MeshFault("there is no triangle in it");
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (!usable(mesh.vertices[i]))
            throw MeshFault(fmt::format("vertex {} has a coordinate that is not a number or beyond {:g}", i, largest_coordinate));
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        if (!usable(mesh.normals[i])) throw MeshFault(fmt::format("normal {} is not a finite vector", i));
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i)
        if (!std::isfinite(mesh.uvs[i].x) || !std::isfinite(mesh.uvs[i].y))
            throw MeshFault(fmt::format("texture coordinate {} is not finite", i));
    complete_normals(mesh);
    if (concave_polygons > 0)
        file.remarks.push_back(
            fmt::format("{} polygons are concave and were cut into triangles that overlap; triangulate the mesh first", concave_polygons));
}

}  // namespace tyndall
