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
    return bounds;
}

}  // namespace tyndall
