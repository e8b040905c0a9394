#include <algorithm>

#include "scene/scene.hpp"
#include "scene/transforms.hpp"

namespace tyndall {

namespace {

/// How far an ellipse with these half axes reaches along x, y and z.
Vec3 reach(const Vec3& u, const Vec3& v) { return glm::sqrt(u * u + v * v); }

void grow_around(Bounds& bounds, const Vec3& centre, const Vec3& by)
{
    bounds.grow(centre - by);
    bounds.grow(centre + by);
}

/// May there be something of the medium where no shape reaches?
bool beyond_shapes(const Scene& scene, int medium)
{
    return scene.camera.medium == medium || std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const Shape& s) { return s.exterior == medium; }) ||
           std::any_of(scene.emitters.begin(), scene.emitters.end(), [&](const Emitter& e) { return e.medium == medium; });
}

}  // namespace

Bounds bounds_of(const Shape& shape)
{
    Bounds bounds;
    const Vec3 x(shape.to_world[0]), y(shape.to_world[1]), z(shape.to_world[2]), origin(shape.to_world[3]);
    switch (shape.type) {
        case Shape::Type::mesh:
            for (const Vec3& vertex : shape.mesh.vertices) bounds.grow(vertex);
            break;
        case Shape::Type::sphere:
            grow_around(bounds, origin, Vec3(glm::length(x)));
            break;
        case Shape::Type::disk:
            grow_around(bounds, origin, reach(x, y));
            break;
        case Shape::Type::cylinder:
            grow_around(bounds, origin, reach(x, y));
            grow_around(bounds, origin + z, reach(x, y));
            break;
    }
    return bounds;
}

Bounds bounds_of(const Volume& volume)
{
    Bounds bounds;
    for (int corner = 0; corner < 8; ++corner) bounds.grow(transform_point(volume.to_world, Vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1)));
    return bounds;
}

Bounds bounds_of(const Scene& scene)
{
    Bounds bounds;
    for (const Shape& shape : scene.shapes) {
        const Bounds own = bounds_of(shape);
        if (own.empty()) continue;
        bounds.grow(own.low);
        bounds.grow(own.high);
    }
    bounds.grow(transform_point(scene.camera.to_world, Vec3(0)));
    for (const Emitter& emitter : scene.emitters)
        if (emitter.type == Emitter::Type::point || emitter.type == Emitter::Type::spot) bounds.grow(emitter.position);
    for (std::size_t i = 0; i < scene.media.size(); ++i) {
        if (scene.media[i].density == none || !beyond_shapes(scene, static_cast<int>(i))) continue;
        const Bounds grid = bounds_of(scene.volumes[static_cast<std::size_t>(scene.media[i].density)]);
        bounds.grow(grid.low), bounds.grow(grid.high);
    }
    return bounds;
}

}  // namespace tyndall
