#pragma once
/// Scenes built in memory, for tests of what reads scenes.
#include <glm/gtc/matrix_transform.hpp>

#include "scene/mesh_geometry.hpp"
#include "scene/scene.hpp"

namespace tyndall::test {

struct Sides {
    int interior = vacuum, exterior = vacuum;
};

class BuiltScene {
public:
    Scene scene;

    BuiltScene() { camera(Vec3(0), {0, 0, 1}, 1); }

    int medium(const Rgb& sigma_t, const Rgb& albedo, double g = 0)
    {
        const auto type = g == 0 ? PhaseFunction::Type::isotropic : PhaseFunction::Type::henyey_greenstein;
        scene.media.push_back({.name = "medium", .sigma_t = sigma_t, .albedo = albedo, .phase = {.type = type, .g = g}});
        return static_cast<int>(scene.media.size()) - 1;
    }
    int bsdf(const Bsdf& b)
    {
        scene.bsdfs.push_back(b);
        return static_cast<int>(scene.bsdfs.size()) - 1;
    }
    int diffuse(const Rgb& reflectance) { return bsdf({.type = Bsdf::Type::diffuse, .reflectance = reflectance}); }
    int null() { return bsdf({.type = Bsdf::Type::null}); }

    int shape(const Shape& s)
    {
        scene.shapes.push_back(s);
        return static_cast<int>(scene.shapes.size()) - 1;
    }
    int mesh(Mesh mesh, const Mat4& to_world, int bsdf)
    {
        transform_mesh(mesh, to_world);
        return shape({.name = "mesh", .type = Shape::Type::mesh, .mesh = mesh, .bsdf = bsdf});
    }
    /// An axis-aligned box, facing outwards.
    int box(const Vec3& low, const Vec3& high, int bsdf)
    {
        return mesh(cube_mesh(), glm::translate(Mat4(1), .5 * (low + high)) * glm::scale(Mat4(1), .5 * (high - low)), bsdf);
    }
    int container(const Vec3& low, const Vec3& high, const Sides& sides) { return bound(box(low, high, null()), sides); }
    int bound(int shape, const Sides& sides)
    {
        scene.shapes[shape].medium_boundary = true;
        scene.shapes[shape].interior = sides.interior, scene.shapes[shape].exterior = sides.exterior;
        return shape;
    }
    /// A square of the given half side around `centre`, facing `normal`.
    int square(const Vec3& centre, const Vec3& normal, double half, int bsdf)
    {
        const Vec3 helper = std::abs(normal.x) < .5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0), s = glm::normalize(glm::cross(helper, normal)),
                   t = glm::cross(normal, s);
        return mesh(rectangle_mesh(), Mat4(glm::dvec4(half * s, 0), glm::dvec4(half * t, 0), glm::dvec4(normal, 0), glm::dvec4(centre, 1)),
                    bsdf);
    }
    int sphere(const Vec3& centre, double radius, int bsdf)
    {
        return shape({.name = "sphere",
                      .type = Shape::Type::sphere,
                      .to_world = glm::translate(Mat4(1), centre) * glm::scale(Mat4(1), Vec3(radius)),
                      .bsdf = bsdf});
    }

    int emitter(const Emitter& e)
    {
        scene.emitters.push_back(e);
        return static_cast<int>(scene.emitters.size()) - 1;
    }
    int glow(int shape, const Rgb& radiance, int medium = vacuum)
    {
        const int index = emitter({.name = "area", .type = Emitter::Type::area, .value = radiance, .shape = shape, .medium = medium});
        scene.shapes[shape].emitter = index;
        return index;
    }
    int point(const Vec3& position, const Rgb& intensity, int medium = vacuum)
    {
        return emitter({.name = "point", .type = Emitter::Type::point, .value = intensity, .position = position, .medium = medium});
    }
    int constant(const Rgb& radiance) { return emitter({.name = "constant", .type = Emitter::Type::constant, .value = radiance}); }

    /// Looks from `position` along unit `forward`; the film is square, `pixels` wide, seen under `fov` radians.
    void camera(const Vec3& position, const Vec3& forward, int pixels, double fov = .5, int medium = vacuum)
    {
        const Vec3 helper = std::abs(forward.y) < .9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0), left = glm::normalize(glm::cross(helper, forward)),
                   up = glm::cross(forward, left);
        scene.camera = {.to_world = Mat4(glm::dvec4(left, 0), glm::dvec4(up, 0), glm::dvec4(forward, 0), glm::dvec4(position, 1)),
                        .fov_x = fov,
                        .near_clip = 1e-6,
                        .far_clip = 1e4,
                        .width = pixels,
                        .height = pixels,
                        .crop_width = pixels,
                        .crop_height = pixels,
                        .filter = {.type = Filter::Type::box},
                        .medium = medium};
    }
};

}  // namespace tyndall::test
