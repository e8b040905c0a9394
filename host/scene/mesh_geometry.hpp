#pragma once
/// What the renderer wants to know of a mesh, and the meshes that need no file.
#include "scene/scene.hpp"

namespace tyndall {

Mesh rectangle_mesh();  ///< [-1, 1]^2 in the plane z = 0, facing +z
Mesh cube_mesh();       ///< [-1, 1]^3, facing outwards

/// Moves vertices and normals. A mirroring transform also reverses the triangles, so that what faced outwards still does.
void transform_mesh(Mesh& mesh, const Mat4& to_world);

/// Drops triangles two of whose corners are the same position and vertices of no triangle, then sets `closed` and `convex`.
void classify_mesh(Mesh& mesh);

/// For every vertex the lowest vertex at exactly the same position.
std::vector<std::uint32_t> welded_vertices(const Mesh& mesh);

/// Every edge, after welding, is shared by exactly two triangles, oppositely directed.
bool is_closed(const Mesh& mesh);

/// For a closed mesh: every vertex lies behind the plane of every triangle, within `convexity_tolerance` times the mesh's size.
/// Meshes too large for that comparison (1e8 pairs) are judged edge by edge, each against its own length, and err on the side of "not convex":
/// a ball of a million triangles rounded to float is not convex by that measure.
bool is_convex(const Mesh& mesh);

/// Vertices of convex meshes come out of files as floats: 1e-6 of the mesh's diagonal covers their rounding.
inline constexpr double convexity_tolerance = 1e-6;

}  // namespace tyndall
