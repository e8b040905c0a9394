#include "scene/render_space.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "scene/text.hpp"
#include "scene/transforms.hpp"
#include "scene/volume_values.hpp"

namespace tyndall {

namespace {

/// The power of two by which a half diagonal is divided to lie in (1/2, 1].
double unit_for(double radius)
{
    int exponent = 0;
    const double mantissa = std::frexp(radius, &exponent);  // in [1/2, 1)
    return std::ldexp(1.0, mantissa == .5 ? exponent - 1 : exponent);
}

struct Motion {
    Vec3 centre;
    double unit;
    Vec3 point(const Vec3& p) const { return (p - centre) / unit; }
    /// Of a matrix whose axes are lengths.
    Mat4 placed(const Mat4& m) const { return Mat4(m[0] / unit, m[1] / unit, m[2] / unit, glm::dvec4(point(Vec3(m[3])), 1)); }
};

void move_shape(Shape& shape, const Motion& motion)
{
    for (Vec3& vertex : shape.mesh.vertices) vertex = motion.point(vertex);
    if (shape.type != Shape::Type::mesh) shape.to_world = motion.placed(shape.to_world);
}

void move_emitter(Emitter& emitter, const Motion& motion)
{
    if (emitter.type != Emitter::Type::point && emitter.type != Emitter::Type::spot) return;
    emitter.position = motion.point(emitter.position);
    emitter.value = emitter.value / motion.unit / motion.unit;
    for (int c = 0; c < 3; ++c)
        if (!std::isfinite(emitter.value[c]))
            refuse(emitter.where, fmt::format("emitter {}: the intensity is too large for a scene this small", in_quotes(emitter.name)));
}

/// `scene`: for the volumes. The extinction of a grid must stay finite in float, where it is multiplied by voxels.
void move_medium(const Scene& scene, Medium& medium, const Motion& motion)
{
    medium.sigma_t = medium.sigma_t * motion.unit;
    const double most = medium.density == none ? std::numeric_limits<double>::max() : std::numeric_limits<float>::max();
    const Rgb largest = glm::max(medium.sigma_t, largest_extinction(scene, medium));
    for (int c = 0; c < 3; ++c)
        if (!(largest[c] <= most))
            refuse(medium.where, fmt::format("medium {}: sigma_t is too large for a scene this large", in_quotes(medium.name)));
}

}  // namespace

void to_render_space(Scene& scene)
{
    const Bounds bounds = bounds_of(scene);
    const double radius = bounds.radius();
    if (radius > largest_coordinate || (radius > 0 && radius < 1 / largest_coordinate))
        refuse(scene.camera.where, fmt::format("the scene's half diagonal is {:g}; it must lie between {:g} and {:g}", radius,
                                               1 / largest_coordinate, largest_coordinate));
    const Motion motion{.centre = bounds.centre(), .unit = radius > 0 ? unit_for(radius) : 1};
    for (Shape& shape : scene.shapes) move_shape(shape, motion);
    for (Emitter& emitter : scene.emitters) move_emitter(emitter, motion);
    for (Volume& volume : scene.volumes) volume.to_world = motion.placed(volume.to_world);
    for (Medium& medium : scene.media) move_medium(scene, medium, motion);
    scene.camera.to_world[3] = glm::dvec4(motion.point(Vec3(scene.camera.to_world[3])), 1);
    scene.camera.near_clip /= motion.unit;
    scene.camera.far_clip /= motion.unit;
    scene.centre = motion.centre, scene.unit = motion.unit;
}

}  // namespace tyndall
