#include "scene/scene_features.hpp"

#include <algorithm>
#include <optional>

#include "kernels/shared/host_features.hpp"

namespace tyndall {
namespace {

constexpr std::size_t most_planes = 64;  ///< a container with more is walked on the host: the kernel's loop over planes would cost more

bool is_null(const Scene& scene, const Shape& shape) { return scene.bsdfs[static_cast<std::size_t>(shape.bsdf)].type == Bsdf::Type::null; }

bool overlap(const Bounds& a, const Bounds& b, double slack)
{
    for (int axis = 0; axis < 3; ++axis)
        if (a.high[axis] <= b.low[axis] + slack || b.high[axis] <= a.low[axis] + slack) return false;
    return true;
}

/// The distinct planes of a convex mesh; nothing if there are more than a kernel should loop over.
std::optional<std::vector<HalfSpace>> planes_of(const Mesh& mesh)
{
    std::vector<HalfSpace> planes;
    for (const glm::uvec3& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t.x], &b = mesh.vertices[t.y], &c = mesh.vertices[t.z];
        const Vec3 n = glm::cross(b - a, c - a);
        const double area = glm::length(n);
        if (area == 0) continue;
        const HalfSpace plane{n / area, glm::dot(n / area, (a + b + c) / 3.0)};
        const bool known = std::any_of(planes.begin(), planes.end(), [&](const HalfSpace& p) {
            return glm::distance(p.normal, plane.normal) < 1e-7 && std::abs(p.offset - plane.offset) < 1e-9;  // two triangles of one facet, in double
        });
        if (!known) planes.push_back(plane);
        if (planes.size() > most_planes) return std::nullopt;
    }
    // The mesh may be wound inwards: its centre is inside.
    const Bounds bounds = [&] { Bounds b; for (const Vec3& v : mesh.vertices) b.grow(v); return b; }();
    for (HalfSpace& p : planes)
        if (glm::dot(p.normal, bounds.centre()) > p.offset) p.normal = -p.normal, p.offset = -p.offset;
    return planes;
}

/// A surface that cannot stand between two points on the scene's shapes or inside its containers: flat, with all shapes on one side of it.
/// (Not so in a medium without bounds: there, points exist beyond every wall's edge.)
bool flat_and_outermost(const Scene& scene, const Shape& shape)
{
    if (shape.type != Shape::Type::mesh || shape.mesh.triangles.empty()) return false;
    const auto planes = planes_of(shape.mesh);
    if (!planes) return false;
    const HalfSpace plane = planes->front();
    const auto off_plane = [&](const Vec3& v) { return std::abs(glm::dot(plane.normal, v) - plane.offset) > 1e-7; };
    if (std::any_of(shape.mesh.vertices.begin(), shape.mesh.vertices.end(), off_plane)) return false;
    bool above = false, below = false;
    for (const Shape& other : scene.shapes) {
        if (&other == &shape) continue;  // its own corners lie on the plane, those of its box need not
        const Bounds b = bounds_of(other);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 v{corner & 1 ? b.high.x : b.low.x, corner & 2 ? b.high.y : b.low.y, corner & 4 ? b.high.z : b.low.z};
            const double side = glm::dot(plane.normal, v) - plane.offset;
            above |= side > 1e-7, below |= side < -1e-7;
        }
    }
    return !(above && below);
}

/// Null boundaries as containers; nothing if they are not disjoint convex polyhedra in vacuum with the camera's and the emitters' media consistent.
std::optional<std::vector<Container>> containers_of(const Scene& scene)
{
    std::vector<Container> containers;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        if (!shape.medium_boundary || (shape.interior == vacuum && shape.exterior == vacuum)) continue;
        if (!is_null(scene, shape) || shape.exterior != vacuum || shape.type != Shape::Type::mesh || !shape.mesh.closed || !shape.mesh.convex || shape.flip_normals)
            return std::nullopt;
        for (const Container& other : containers)
            if (overlap(bounds_of(shape), bounds_of(scene.shapes[static_cast<std::size_t>(other.shape)]), 0)) return std::nullopt;
        auto planes = planes_of(shape.mesh);
        if (!planes) return std::nullopt;
        containers.push_back({shape.interior, static_cast<int>(i), std::move(*planes)});
    }
    const auto known = [&](int medium) { return medium == vacuum || std::any_of(containers.begin(), containers.end(), [&](const Container& c) { return c.medium == medium; }); };
    const bool consistent = containers.empty() || (known(scene.camera.medium) && std::all_of(scene.emitters.begin(), scene.emitters.end(), [&](const Emitter& e) { return known(e.medium); }));
    return consistent ? std::optional(containers) : std::nullopt;
}

bool has_null_boundary(const Scene& scene)
{
    return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const Shape& s) { return s.medium_boundary && is_null(scene, s) && s.interior != s.exterior; });
}

/// True if some surface may block a connection between two points of the containers (of all space without containers).
bool occluders_within(const Scene& scene, const std::vector<Container>& containers)
{
    return std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const Shape& shape) {
        if (is_null(scene, shape)) return false;
        if (containers.empty()) return true;
        if (flat_and_outermost(scene, shape)) return false;
        if (containers.size() > 1) return true;
        return overlap(bounds_of(shape), bounds_of(scene.shapes[static_cast<std::size_t>(containers.front().shape)]), 1e-7);  // touching does not block
    });
}

bool occluders_anywhere(const Scene& scene, const std::vector<Container>& containers)
{
    return std::any_of(scene.shapes.begin(), scene.shapes.end(),
                       [&](const Shape& shape) { return !is_null(scene, shape) && (containers.empty() || !flat_and_outermost(scene, shape)); });
}

std::uint32_t medium_bits(const Scene& scene)
{
    std::uint32_t mask = scene.media.size() > 1 ? feature_bit::many_media : 0u;
    for (const Medium& m : scene.media) {
        if (m.phase.type != PhaseFunction::Type::isotropic && m.phase.g != 0) mask |= feature_bit::anisotropic;
        if (m.sigma_t.r != m.sigma_t.g || m.sigma_t.r != m.sigma_t.b) mask |= feature_bit::coloured;
    }
    return mask;
}

}  // namespace

SceneFeatures features_of(const Scene& scene, bool short_lights, int max_depth)
{
    SceneFeatures f;
    for (const Medium& m : scene.media) {
        f.scattering_media |= glm::any(glm::greaterThan(m.sigma_s(), Rgb(0)));
        f.absorbing_media |= glm::any(glm::greaterThan(m.sigma_t, Rgb(0)));
    }
    for (const Shape& shape : scene.shapes) {
        const Bsdf& front = scene.bsdfs[static_cast<std::size_t>(shape.bsdf)];
        for (const Bsdf* bsdf : {&front, front.back == none ? &front : &scene.bsdfs[static_cast<std::size_t>(front.back)]}) {
            f.receiving_surfaces |= bsdf->type == Bsdf::Type::diffuse && glm::any(glm::greaterThan(bsdf->reflectance, Rgb(0)));
            f.specular_surfaces |= bsdf->type == Bsdf::Type::dielectric || bsdf->type == Bsdf::Type::conductor;
        }
    }
    const bool boundaries = has_null_boundary(scene);
    const auto containers = containers_of(scene);
    if (boundaries && containers) f.containers = *containers;
    std::uint32_t common = medium_bits(scene);
    if (short_lights) common |= feature_bit::short_lights;
    if (max_depth >= 0) common |= feature_bit::depth_limit;
    f.media_to_media = f.media_to_surface = common;
    if (boundaries && !containers) {
        f.media_to_media |= feature_bit::boundaries | feature_bit::nonconvex_media;
        f.media_to_surface |= feature_bit::boundaries | feature_bit::nonconvex_media;
    } else if (boundaries) {
        if (f.containers.size() > 1) f.media_to_media |= feature_bit::boundaries;
        f.media_to_surface |= feature_bit::boundaries;
    }
    if (occluders_within(scene, f.containers)) f.media_to_media |= feature_bit::occluders;
    if (occluders_anywhere(scene, f.containers)) f.media_to_surface |= feature_bit::occluders;
    if (f.media_to_media & feature_bit::nonconvex_media) f.media_to_media |= feature_bit::occluders;      // the host's walk answers both questions
    if (f.media_to_surface & feature_bit::nonconvex_media) f.media_to_surface |= feature_bit::occluders;
    return f;
}

}  // namespace tyndall
