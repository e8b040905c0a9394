#include "scene/scene_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/mesh_geometry.hpp"
#include "scene/text.hpp"
#include "scene/transforms.hpp"

namespace tyndall {

namespace {

/// The last boundary that a segment crosses, by its parameter in (0, 1), and whether it leaves through it along the outward normal.
struct Crossing {
    double t = -1;
    bool outwards = false;
    void take(double at, bool out)
    {
        if (at > 0 && at < 1 && at > t) t = at, outwards = out;
    }
};

void cross_mesh(const Mesh& mesh, const Vec3& from, const Vec3& along, Crossing& last)
{
    for (const glm::uvec3& triangle : mesh.triangles) {
        const Vec3 a = mesh.vertices[triangle.x], e1 = mesh.vertices[triangle.y] - a, e2 = mesh.vertices[triangle.z] - a;
        const Vec3 p = glm::cross(along, e2), s = from - a, q = glm::cross(s, e1);
        const double volume = glm::dot(e1, p), u = glm::dot(s, p) / volume, v = glm::dot(along, q) / volume;
        if (volume != 0 && u >= 0 && v >= 0 && u + v <= 1) last.take(glm::dot(e2, q) / volume, volume < 0);
    }
}

/// x^2 + y^2 (+ z^2) = 1 in local space; the cylinder only where 0 <= z <= 1.
void cross_round(const Shape& shape, const Vec3& from, const Vec3& along, Crossing& last)
{
    const Mat4 to_local = glm::inverse(shape.to_world);
    const bool is_cylinder = shape.type == Shape::Type::cylinder;
    const Vec3 mask(1, 1, is_cylinder ? 0 : 1), o = transform_point(to_local, from), d = transform_direction(to_local, along);
    const double a = glm::dot(mask * d, d), b = glm::dot(mask * o, d), c = glm::dot(mask * o, o) - 1, root = b * b - a * c;
    if (!(root > 0) || !(a > 0)) return;
    for (const double sign : {-1., 1.}) {
        const double t = (-b + sign * std::sqrt(root)) / a, z = o.z + t * d.z;
        if (!is_cylinder || (z >= 0 && z <= 1)) last.take(t, sign > 0);
    }
}

void cross_disk(const Shape& shape, const Vec3& from, const Vec3& along, Crossing& last)
{
    const Mat4 to_local = glm::inverse(shape.to_world);
    const Vec3 o = transform_point(to_local, from), d = transform_direction(to_local, along);
    const double t = -o.z / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
    if (d.z != 0 && x * x + y * y <= 1) last.take(t, d.z > 0);
}

Crossing last_crossing(const Shape& shape, const Vec3& from, const Vec3& along)
{
    Crossing last;
    switch (shape.type) {
        case Shape::Type::mesh:
            cross_mesh(shape.mesh, from, along, last);
            break;
        case Shape::Type::disk:
            cross_disk(shape, from, along, last);
            break;
        case Shape::Type::sphere:
        case Shape::Type::cylinder:
            cross_round(shape, from, along, last);
            break;
    }
    if (shape.flip_normals) last.outwards = !last.outwards;
    return last;
}

/// A place next to the shape, off the side of its normal, or, `inside`, off the other.
Vec3 place_at(const Shape& shape, bool inside)
{
    Vec3 place(shape.to_world[3]), normal(shape.to_world[2]);
    if (shape.type == Shape::Type::mesh) {
        const glm::uvec3& corner = shape.mesh.triangles[0];
        const Vec3 &a = shape.mesh.vertices[corner.x], &b = shape.mesh.vertices[corner.y], &c = shape.mesh.vertices[corner.z];
        place = (a + b + c) / 3., normal = glm::cross(b - a, c - a);
    } else if (shape.type == Shape::Type::sphere) {
        place += normal;
    } else if (shape.type == Shape::Type::cylinder) {
        place += .5 * normal + Vec3(shape.to_world[0]), normal = Vec3(shape.to_world[0]);
    }
    return place + (shape.flip_normals != inside ? -1e-6 : 1e-6) * glm::normalize(normal);
}

/// A place just off the glowing side.
Vec3 place_of(const Scene& scene, const Emitter& emitter)
{
    return emitter.type == Emitter::Type::area ? place_at(scene.shapes[static_cast<std::size_t>(emitter.shape)], false) : emitter.position;
}

void warn_of_unused_media(SceneBuilder& builder)
{
    const Scene& scene = builder.scene;
    for (std::size_t i = 0; i < scene.media.size(); ++i) {
        const int medium = static_cast<int>(i);
        const bool used = scene.camera.medium == medium ||
                          std::any_of(scene.shapes.begin(), scene.shapes.end(),
                                      [&](const Shape& s) { return s.interior == medium || s.exterior == medium; }) ||
                          std::any_of(scene.emitters.begin(), scene.emitters.end(), [&](const Emitter& e) { return e.medium == medium; });
        if (!used)
            builder.warn(scene.media[i].where,
                         fmt::format("medium {}: nothing refers to it, so it is nowhere; give a shape <ref name=\"interior\" id={}/>",
                                     in_quotes(scene.media[i].name), in_quotes(scene.media[i].name)));
    }
}

/// Do the meshes that bound the same two media as `shape` close each other? A glass of juice is bounded by its wall and by its surface, which differ in what they do to light.
bool closed_by_others(const Scene& scene, const Shape& shape)
{
    Mesh whole;
    for (const Shape& other : scene.shapes) {
        const bool same = other.medium_boundary && other.type == Shape::Type::mesh && other.interior == shape.interior && other.exterior == shape.exterior && other.flip_normals == shape.flip_normals;
        if (!same) continue;
        const auto first = static_cast<unsigned>(whole.vertices.size());
        whole.vertices.insert(whole.vertices.end(), other.mesh.vertices.begin(), other.mesh.vertices.end());
        for (const glm::uvec3& triangle : other.mesh.triangles) whole.triangles.push_back(triangle + first);
    }
    return is_closed(whole);
}

void warn_of_leaks(SceneBuilder& builder)
{
    for (const Shape& shape : builder.scene.shapes) {
        if (!shape.medium_boundary || shape.interior == shape.exterior) continue;
        const bool open = shape.type == Shape::Type::mesh ? !shape.mesh.closed : shape.type != Shape::Type::sphere;
        if (open && !(shape.type == Shape::Type::mesh && closed_by_others(builder.scene, shape)))
            builder.warn(
                shape.where,
                fmt::format("shape {}: bounds a medium but is not closed: unless other shapes close it, the medium leaks; close its edges",
                            in_quotes(shape.name)));
    }
}

/// A solid of glass that names no media does not end the medium around it.
void warn_of_media_inside_glass(SceneBuilder& builder)
{
    const Scene& scene = builder.scene;
    for (const Shape& shape : scene.shapes) {
        const Bsdf::Type type = scene.bsdfs[static_cast<std::size_t>(shape.bsdf)].type;
        const bool glass = type == Bsdf::Type::dielectric || type == Bsdf::Type::rough_dielectric;
        const bool closed = shape.type == Shape::Type::mesh ? shape.mesh.closed : shape.type == Shape::Type::sphere;
        if (!glass || !closed || shape.medium_boundary) continue;
        const int medium = medium_at(scene, Vec3(scene.camera.to_world[3]), scene.camera.medium, place_at(shape, true));
        if (medium != vacuum)
            builder.warn(shape.where, fmt::format("shape {0}: lets light through and names no interior medium, so medium {1} goes on inside of it; give it <ref name=\"exterior\" id={1}/> if it is "
                                                  "to be empty, or <ref name=\"interior\" .../>",
                                                  in_quotes(shape.name), in_quotes(scene.media[static_cast<std::size_t>(medium)].name)));
    }
}

void warn_of_missing_refs(SceneBuilder& builder)
{
    const Scene& scene = builder.scene;
    const Vec3 camera(scene.camera.to_world[3]);
    const auto name = [&](int medium) { return in_quotes(scene.media[static_cast<std::size_t>(medium)].name); };
    // From far outside, in a direction along no likely edge. 3: beyond every point of render space.
    const int around_camera = medium_at(scene, glm::normalize(Vec3(.5377, .6121, .5801)) * 3., vacuum, camera);
    if (scene.camera.medium == vacuum && around_camera != vacuum)
        builder.warn(scene.camera.where, fmt::format("the sensor seems to stand inside medium {0} without saying so; give it <ref id={0}/>",
                                                     name(around_camera)));
    for (const Emitter& emitter : scene.emitters) {
        if (emitter.outside() || emitter.medium != vacuum) continue;
        const int medium = medium_at(scene, camera, scene.camera.medium, place_of(scene, emitter));
        if (medium != vacuum)
            builder.warn(
                emitter.where,
                fmt::format(
                    "emitter {0} seems to stand inside medium {1} without saying so, and would light it as if it stood in a vacuum; "
                    "give it <ref id={1}/>",
                    in_quotes(emitter.name), name(medium)));
    }
}

}  // namespace

int medium_at(const Scene& scene, const Vec3& from, int medium, const Vec3& to)
{
    Crossing last;
    for (const Shape& shape : scene.shapes) {
        if (!shape.medium_boundary) continue;
        const Crossing crossing = last_crossing(shape, from, to - from);
        if (crossing.t > last.t) last = crossing, medium = crossing.outwards ? shape.exterior : shape.interior;
    }
    return medium;
}

int outermost_medium(const Scene& scene)
{
    const Vec3 far_away = glm::normalize(Vec3(.5377, .6121, .5801)) * 4.;  // along no likely edge; render space has radius 1
    return medium_at(scene, Vec3(scene.camera.to_world[3]), scene.camera.medium, far_away);
}

void add_warnings(SceneBuilder& builder)
{
    warn_of_unused_media(builder);
    warn_of_leaks(builder);
    warn_of_media_inside_glass(builder);
    warn_of_missing_refs(builder);
    warn_of_grids(builder);
    if (builder.scene.emitters.empty()) builder.warn(builder.document.root().where, "the scene has no emitter: its image is black");
}

}  // namespace tyndall
