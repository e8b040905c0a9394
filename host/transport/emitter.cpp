#include "transport/emitter.hpp"

#include <algorithm>

#include "scene/environment_maps.hpp"
#include "transport/frame.hpp"
#include "transport/medium.hpp"
#include "transport/warp.hpp"

namespace tyndall {
namespace {

double mean(const Rgb& c) { return (c.x + c.y + c.z) / 3; }

/// Solid angle of the cone weighted by the falloff: 2 pi times the integral of falloff x sine.
double spot_solid_angle(const Emitter& e)
{
    const double width = e.cutoff - e.beam;
    if (width <= 0) return 2 * pi * one_minus_cos(e.cutoff);
    // integral of sin from 0 to beam, plus by parts of the linear part
    return 2 * pi * (1 - (std::sin(e.cutoff) - std::sin(e.beam)) / width);
}

/// Area of the unit shape.
double unit_area(Shape::Type type)
{
    switch (type) {
        case Shape::Type::sphere:
            return 4 * pi;
        case Shape::Type::cylinder:
            return 2 * pi;
        default:
            return pi;
    }
}

/// How much to_world stretches area where the world normal is `normal`.
double area_stretch(const Shape& shape, const Vec3& normal)
{
    const glm::dmat3 m(shape.to_world);
    return std::abs(glm::determinant(m)) / glm::length(glm::transpose(m) * normal);
}

EmitterPoint sample_quadric(const Shape& shape, const Vec2& xi)
{
    Vec3 local, normal;
    switch (shape.type) {
        case Shape::Type::sphere:
            local = normal = sample_uniform_sphere(xi);
            break;
        case Shape::Type::cylinder:
            normal = {std::cos(2 * pi * xi.x), std::sin(2 * pi * xi.x), 0};
            local = normal + Vec3(0, 0, xi.y);
            break;
        default:
            local = sample_uniform_disk(xi), normal = {0, 0, 1};
    }
    const Vec3 world = glm::normalize(glm::transpose(glm::inverse(glm::dmat3(shape.to_world))) * normal);
    return {.position = Vec3(shape.to_world * glm::dvec4(local, 1)),
            .normal = shape.flip_normals ? -world : world,
            .pdf = 1 / (unit_area(shape.type) * area_stretch(shape, world))};
}

/// Mean over directions of the surface's stretch: exact for spheres under similarities, for disks always; good enough to choose emitters
/// by.
double quadric_area(const Shape& shape)
{
    constexpr int n = 16;
    double area = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) area += 1 / sample_quadric(shape, {(i + .5) / n, (j + .5) / n}).pdf;
    return area / (n * n);
}

const EnvironmentMap& map_of(const Scene& scene, const Emitter& emitter) { return scene.environment_maps[static_cast<std::size_t>(emitter.map)]; }

std::size_t find_interval(const std::vector<double>& cumulative, double value)
{
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end(), value);
    return std::min<std::size_t>(found - cumulative.begin(), cumulative.size() - 1);
}

}  // namespace

EmitterSampler::EmitterSampler(const Scene& scene) : scene_(scene), tables_(scene.emitters.size())
{
    if (const Bounds bounds = bounds_of(scene); !bounds.empty())
        centre_ = bounds.centre(), radius_ = bounds.radius() * (1 + 0x1p-10) + 2 * Visibility::surface_offset;
    for (std::size_t i = 0; i < scene.emitters.size(); ++i) {
        const Emitter& emitter = scene.emitters[i];
        const double area = emitter.type == Emitter::Type::area ? surface_area(scene.shapes[emitter.shape], tables_[i]) : 0;
        powers_.push_back(power(emitter, area));
        total_ += powers_.back();
        cumulative_.push_back(total_);
    }
}

double EmitterSampler::power(const Emitter& emitter, double surface_area) const
{
    const double value = mean(emitter.value), disk = pi * radius_ * radius_;
    switch (emitter.type) {
        case Emitter::Type::point:
            return 4 * pi * value;
        case Emitter::Type::spot:
            return spot_solid_angle(emitter) * value;
        case Emitter::Type::area:
            return pi * surface_area * value;
        case Emitter::Type::directional:
            return disk * value;
        case Emitter::Type::constant:
            return 4 * pi * disk * value;
        case Emitter::Type::envmap:
            return 4 * pi * disk * mean(emitter.value * map_of(scene_, emitter).mean);
    }
    return 0;
}

double EmitterSampler::surface_area(const Shape& shape, AreaTable& table) const
{
    if (shape.type != Shape::Type::mesh) return quadric_area(shape);
    double total = 0;
    for (const glm::uvec3& t : shape.mesh.triangles) {
        const Vec3 v0 = shape.mesh.vertices[t.x];
        total += .5 * glm::length(glm::cross(shape.mesh.vertices[t.y] - v0, shape.mesh.vertices[t.z] - v0));
        table.cumulative.push_back(total);
    }
    return total;
}

EmitterChoice EmitterSampler::choose(double xi) const
{
    std::size_t i = find_interval(cumulative_, xi * total_);
    while (i > 0 && powers_[i] <= 0) --i;  // xi * total_ rounded up to total_ and the last emitters are dark
    return {.emitter = static_cast<int>(i), .probability = probability(static_cast<int>(i))};
}

EmitterPoint EmitterSampler::sample_mesh(const Shape& shape, const AreaTable& table, Vec2 xi) const
{
    const double total = table.cumulative.back();
    const std::size_t triangle = find_interval(table.cumulative, xi.x * total);
    const double low = triangle == 0 ? 0 : table.cumulative[triangle - 1];
    xi.x = rescale(xi.x * total, low, table.cumulative[triangle]);
    const glm::uvec3 index = shape.mesh.triangles[triangle];
    const Vec3 v0 = shape.mesh.vertices[index.x], e1 = shape.mesh.vertices[index.y] - v0, e2 = shape.mesh.vertices[index.z] - v0;
    const Vec2 b = sample_uniform_triangle(xi);
    const Vec3 normal = glm::normalize(glm::cross(e1, e2));
    return {.position = v0 + b.x * e1 + b.y * e2, .normal = shape.flip_normals ? -normal : normal, .pdf = 1 / total};
}

EmitterPoint EmitterSampler::sample_point(int emitter, const Vec2& xi) const
{
    const Emitter& e = scene_.emitters[emitter];
    if (e.type != Emitter::Type::area) return {.position = e.position};
    const Shape& shape = scene_.shapes[e.shape];
    return shape.type == Shape::Type::mesh ? sample_mesh(shape, tables_[emitter], xi) : sample_quadric(shape, xi);
}

double EmitterSampler::pdf_point(const Hit& hit) const
{
    const Shape& shape = scene_.shapes[hit.shape];
    if (shape.type == Shape::Type::mesh) return 1 / tables_[shape.emitter].cumulative.back();
    return 1 / (unit_area(shape.type) * area_stretch(shape, hit.geometric_normal));
}

double spot_falloff(const Emitter& emitter, const Vec3& out)
{
    const double angle = std::atan2(glm::length(glm::cross(emitter.direction, out)), glm::dot(emitter.direction, out));
    if (angle <= emitter.beam) return 1;
    return angle >= emitter.cutoff ? 0 : (emitter.cutoff - angle) / (emitter.cutoff - emitter.beam);
}

Rgb intensity(const Emitter& emitter, const EmitterPoint& point, const Vec3& out)
{
    switch (emitter.type) {
        case Emitter::Type::point:
            return emitter.value;
        case Emitter::Type::spot:
            return emitter.value * spot_falloff(emitter, out);
        case Emitter::Type::area:
            return emitter.value * std::max(0.0, glm::dot(point.normal, out));
        default:
            return Rgb(0);
    }
}

DirectSample sample_direct(const EmitterSampler& emitters, int emitter, const Vec3& reference, const Vec2& xi)
{
    const Emitter& e = emitters.scene().emitters[emitter];
    if (e.type == Emitter::Type::directional) return {.direction = -e.direction, .weight = e.value, .delta = true, .infinite = true};
    if (e.type == Emitter::Type::constant)
        return {
            .direction = sample_uniform_sphere(xi), .weight = e.value / pdf_uniform_sphere, .pdf = pdf_uniform_sphere, .infinite = true};
    if (e.type == Emitter::Type::envmap) {
        const EnvironmentSample sample = sample_environment(map_of(emitters.scene(), e), xi);
        const Vec3 direction = glm::normalize(e.map_to_world * sample.towards);
        return {.direction = direction, .weight = radiance_from_outside(emitters.scene(), e, direction) / sample.pdf, .pdf = sample.pdf, .infinite = true};
    }
    const EmitterPoint point = emitters.sample_point(emitter, xi);
    const Vec3 to_light = point.position - reference;
    const double distance = glm::length(to_light);
    if (distance == 0) return {.direction = {0, 0, 1}, .distance = 0, .position = point.position};
    const Vec3 direction = to_light / distance;
    DirectSample sample{.direction = direction, .distance = distance, .position = point.position, .delta = e.type != Emitter::Type::area};
    sample.weight = intensity(e, point, -direction) / point.pdf / distance / distance;
    const double cosine = -glm::dot(point.normal, direction);
    if (!sample.delta) sample.pdf = cosine > 0 ? point.pdf * distance * distance / cosine : 0;
    return sample;
}

double pdf_direct(const EmitterSampler& emitters, const Vec3& reference, const Hit& hit)
{
    const Vec3 to_light = hit.position - reference;
    const double square = glm::dot(to_light, to_light), cosine = std::abs(glm::dot(to_light, hit.geometric_normal)) / std::sqrt(square);
    return emitters.probability(emitters.scene().shapes[hit.shape].emitter) * emitters.pdf_point(hit) * square / cosine;
}

bool all_around(const Emitter& emitter) { return emitter.type == Emitter::Type::constant || emitter.type == Emitter::Type::envmap; }

Rgb radiance_from_outside(const Scene& scene, const Emitter& emitter, const Vec3& direction)
{
    if (emitter.type != Emitter::Type::envmap) return emitter.value;
    return emitter.value * radiance_from(map_of(scene, emitter), glm::transpose(emitter.map_to_world) * direction);
}

double pdf_direct_outside(const EmitterSampler& emitters, int emitter, const Vec3& direction)
{
    const Emitter& e = emitters.scene().emitters[emitter];
    const bool mapped = e.type == Emitter::Type::envmap;
    return emitters.probability(emitter) * (mapped ? pdf_environment(map_of(emitters.scene(), e), glm::transpose(e.map_to_world) * direction) : pdf_uniform_sphere);
}

Rgb emitted_radiance(const Scene& scene, const Hit& hit, const Vec3& direction)
{
    const int emitter = scene.shapes[hit.shape].emitter;
    return emitter != none && glm::dot(direction, hit.geometric_normal) < 0 ? scene.emitters[emitter].value : Rgb(0);
}

Rgb transmittance_to(const Visibility& visibility, const Scene& scene, const Vec3& from, int medium, const DirectSample& sample)
{
    if (!sample.infinite) return visibility.transmittance(from, medium, sample.position);
    const RayWalk walk = visibility.walk({.origin = from, .direction = sample.direction}, medium);
    return walk.found ? Rgb(0) : transmittance_of(scene, walk);
}

}  // namespace tyndall
