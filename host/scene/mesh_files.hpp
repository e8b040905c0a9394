#pragma once
/// Meshes out of the bytes of OBJ and PLY files. Every count is checked against the bytes that are there before memory is asked for; every
/// number is finite, every index in range.
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall {

/// What is wrong with a mesh file: "line 17: ...". The loader adds the file and the place in the scene.
struct MeshFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct MeshFile {
    Mesh mesh;
    std::vector<std::string> remarks;  ///< what was read otherwise than one might think; become warnings
};

/// Wavefront OBJ: v, vt, vn, f (negative indices too). Groups, materials, lines and points are passed over; free-form surfaces are refused.
/// Normals and texture coordinates are taken if every corner has them.
MeshFile read_obj(std::string_view bytes);

/// PLY 1.0, ascii, binary_little_endian or binary_big_endian: element vertex with x y z, optional nx ny nz and u v (or s t), element face
/// with a list of vertex indices. Other properties and elements are passed over.
MeshFile read_ply(std::string_view bytes);

/// Adds a polygon as a fan from its first corner. True if the fan is not the polygon, because a corner points inwards.
bool add_polygon(Mesh& mesh, std::span<const std::uint32_t> corners);

/// Checks what both formats share (not empty, finite) and gives vertices whose normal is zero the mean normal of their triangles.
void finish_mesh(MeshFile& file, std::size_t concave_polygons);

}  // namespace tyndall
