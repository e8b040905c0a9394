// closed and convex.
#include "scene/mesh_geometry.hpp"

#include <cmath>
#include <numbers>

#include "scene/transforms.hpp"
#include "scene_text.hpp"

namespace tyndall::test {

/// A sphere of `rings` x 2 `rings` quads, with the seam's and the poles' vertices doubled; `bump` displaces one vertex inwards; rounded to
/// float as files are.
Mesh ball(unsigned rings, double bump = 0)
{
    Mesh mesh;
    const unsigned around = 2 * rings;
    for (unsigned i = 0; i <= rings; ++i)
        for (unsigned j = 0; j <= around; ++j) {
            const double theta = std::numbers::pi * i / rings, phi = 2 * std::numbers::pi * (j % around) / around;
            const double r = i == rings / 2 && j == 3 ? 1 - bump : 1, s = i == 0 || i == rings ? 0 : std::sin(theta);
            mesh.vertices.emplace_back(static_cast<float>(r * s * std::cos(phi)), static_cast<float>(r * s * std::sin(phi)),
                                       static_cast<float>(r * std::cos(theta)));
        }
    for (unsigned i = 0; i < rings; ++i)
        for (unsigned j = 0; j < around; ++j) {
            const unsigned a = i * (around + 1) + j, b = a + around + 1;
            mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
        }
    return mesh;
}

Mesh classified(Mesh mesh)
{
    classify_mesh(mesh);
    return mesh;
}

TEST(MeshGeometry, CubeIsClosedAndConvexEvenAfterRotation)
{
    Mesh cube = cube_mesh();
    transform_mesh(cube, rotation(Vec3(1, 2, 3), 37) * scaling(Vec3(.6, 20, 1e-3)));
    classify_mesh(cube);
    EXPECT_TRUE(cube.closed);
    EXPECT_TRUE(cube.convex);
}

TEST(MeshGeometry, SeamsAreWelded)
{
    const Mesh mesh = classified(ball(16));
    EXPECT_TRUE(mesh.closed);
    EXPECT_TRUE(mesh.convex);
    EXPECT_EQ(mesh.triangles.size(), 2u * 16 * 32 - 2 * 32) << "the poles' triangles without area are dropped";
}

TEST(MeshGeometry, AHoleOpens)
{
    Mesh mesh = cube_mesh();
    mesh.triangles.pop_back();
    EXPECT_FALSE(classified(mesh).closed);
    EXPECT_FALSE(classified(mesh).convex);
    EXPECT_FALSE(classified(rectangle_mesh()).closed);
}

TEST(MeshGeometry, AnInvertedTriangleIsNotClosed)
{
    Mesh mesh = cube_mesh();
    std::swap(mesh.triangles[5].x, mesh.triangles[5].y);
    EXPECT_FALSE(classified(mesh).closed);
}

TEST(MeshGeometry, AThirdTriangleOnAnEdgeIsNotClosed)
{
    Mesh mesh = cube_mesh();
    mesh.vertices.emplace_back(3, 3, 3);
    const auto t = mesh.triangles[0];
    mesh.triangles.push_back({t.x, t.y, static_cast<unsigned>(mesh.vertices.size()) - 1});
    EXPECT_FALSE(classified(mesh).closed);
}

TEST(MeshGeometry, ADoubledMeshIsNotClosed)
{
    Mesh mesh = cube_mesh();
    const auto once = mesh.triangles;
    mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
    EXPECT_FALSE(classified(mesh).closed);
}

TEST(MeshGeometry, InsideOutIsClosedAndNotConvex)
{
    Mesh mesh = cube_mesh();
    for (auto& t : mesh.triangles) std::swap(t.x, t.y);
    EXPECT_TRUE(classified(mesh).closed);
    EXPECT_FALSE(classified(mesh).convex);
}

TEST(MeshGeometry, TwoCubesAreClosedAndNotConvex)
{
    Mesh mesh = cube_mesh(), other = cube_mesh();
    transform_mesh(other, translation(Vec3(5, 0, 0)));
    for (const auto& t : other.triangles) mesh.triangles.push_back(t + static_cast<unsigned>(mesh.vertices.size()));
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    EXPECT_TRUE(classified(mesh).closed);
    EXPECT_FALSE(classified(mesh).convex);
}

TEST(MeshGeometry, DentsAreFoundInCoarseAndFineMeshes)
{
    // 16 rings: the definition is asked; 128 rings (16 K vertices x 64 K triangles) go by edges and the solid angle
    for (const unsigned rings : {16u, 128u}) {
        EXPECT_TRUE(classified(ball(rings, .05)).closed) << rings;
        EXPECT_FALSE(classified(ball(rings, .05)).convex) << rings;
    }
    EXPECT_FALSE(classified(ball(128, .002)).convex);  // .2 % of the radius
}

TEST(MeshGeometry, FloatRoundingDoesNotMakeABoxConcave)
{
    // Two coplanar triangles per face, rotated and rounded to float: a bend of 1e-7 of the size.
    for (int turn = 1; turn < 40; ++turn) {
        Mesh mesh = cube_mesh();
        transform_mesh(mesh, rotation(Vec3(1, .3 * turn, -.2), 9. * turn + 1) * scaling(Vec3(1, 2, 3)));
        for (Vec3& v : mesh.vertices) v = Vec3(glm::vec3(v));
        EXPECT_TRUE(classified(mesh).convex) << turn;
    }
}

TEST(MeshGeometry, UnusedVerticesDoNotCount)
{
    Mesh mesh = cube_mesh();
    const std::size_t used = mesh.vertices.size();
    mesh.vertices.insert(mesh.vertices.begin(), Vec3(100));
    mesh.uvs.insert(mesh.uvs.begin(), Vec2(7));
    for (auto& t : mesh.triangles) t += 1u;
    mesh = classified(mesh);
    EXPECT_EQ(mesh.vertices.size(), used);
    EXPECT_EQ(mesh.uvs, cube_mesh().uvs);
    EXPECT_TRUE(mesh.convex);
}

}  // namespace tyndall::test
