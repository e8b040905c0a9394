#pragma once
/// What readers promise about what they return, asked again by plain loops.
#include <algorithm>
#include <cmath>

#include "scene/scene.hpp"
#include "targets.hpp"

namespace tyndall::fuzz {

inline bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

inline void check_mesh(const Mesh& mesh)
{
    require(!mesh.triangles.empty(), "a mesh has a triangle");
    require(mesh.normals.empty() || mesh.normals.size() == mesh.vertices.size(), "normals are all there or none is");
    require(mesh.uvs.empty() || mesh.uvs.size() == mesh.vertices.size(), "texture coordinates are all there or none is");
    for (const auto& t : mesh.triangles) require(std::max({t.x, t.y, t.z}) < mesh.vertices.size(), "indices of corners are in range");
    require(std::all_of(mesh.vertices.begin(), mesh.vertices.end(), finite), "corners are finite");
    require(std::all_of(mesh.normals.begin(), mesh.normals.end(), finite), "normals are finite");
}

}  // namespace tyndall::fuzz
