#include "bench/shadow_scene.hpp"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/mesh_geometry.hpp"

namespace tyndall::bench {
namespace {

/// A sphere of 2 n n triangles around `centre` whose radius swings by 15 %. Its poles are rows of triangles without area.
Mesh bumpy_sphere(const Vec3& centre, double radius, unsigned n)
{
    Mesh mesh;
    for (unsigned row = 0; row <= n; ++row)
        for (unsigned column = 0; column <= n; ++column) {
            const double theta = glm::pi<double>() * row / n, phi = 2 * glm::pi<double>() * column / n;
            const double r = radius * (1 + .15 * std::sin(6 * theta) * std::sin(5 * phi));
            mesh.vertices.push_back(centre + r * Vec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)));
        }
    for (unsigned row = 0; row < n; ++row)
        for (unsigned column = 0; column < n; ++column) {
            const unsigned i = row * (n + 1) + column, below = i + n + 1;
            mesh.triangles.push_back({i, i + 1, below});
            mesh.triangles.push_back({i + 1, below + 1, below});
        }
    return mesh;
}

Mesh tetrahedron(const Vec3& centre, double radius)
{
    const double k = radius / std::sqrt(3.0);
    Mesh mesh;
    mesh.vertices = {centre + k * Vec3(1, 1, 1), centre + k * Vec3(1, -1, -1), centre + k * Vec3(-1, 1, -1), centre + k * Vec3(-1, -1, 1)};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    return mesh;
}

void add(Scene& scene, const Mesh& mesh) { scene.shapes.push_back({.name = "solid", .type = Shape::Type::mesh, .mesh = mesh, .bsdf = 0}); }

}  // namespace

Scene shadow_scene(Solids solids)
{
    Scene scene;
    scene.bsdfs.push_back({.type = Bsdf::Type::diffuse});
    if (solids == Solids::one_ball) {
        add(scene, bumpy_sphere(Vec3(0), .05, 64));
        return scene;
    }
    Mesh room = cube_mesh();
    transform_mesh(room, glm::scale(Mat4(1), Vec3(.575)));
    add(scene, room);
    for (const Vec3& centre : {Vec3(-.16, -.14, .05), Vec3(.15, -.12, -.08), Vec3(-.12, .15, -.04), Vec3(.14, .16, .1)})
        add(scene, solids == Solids::room_of_balls ? bumpy_sphere(centre, .08, 32) : tetrahedron(centre, .13));
    return scene;
}

std::size_t triangle_count(const Scene& scene)
{
    std::size_t count = 0;
    for (const Shape& shape : scene.shapes) count += shape.mesh.triangles.size();
    return count;
}

}  // namespace tyndall::bench
