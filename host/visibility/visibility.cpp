#include "visibility/visibility.hpp"

#include <cmath>
#include <limits>

#include "parallel/parallel_for.hpp"
#include "visibility/embree_scene.hpp"
#include "visibility/exact_hit.hpp"
#include "volumes/medium_line.hpp"

namespace tyndall {
namespace {

bool finite(const RTCRay& ray)
{
    return std::isfinite(ray.org_x) && std::isfinite(ray.org_y) && std::isfinite(ray.org_z) && std::isfinite(ray.dir_x) &&
           std::isfinite(ray.dir_y) && std::isfinite(ray.dir_z) && ray.tnear >= 0 && ray.tfar >= ray.tnear;
}

/// The query's ray as Embree sees it: in float, and from a little before its origin.
RTCRay float_ray(const ExactQuery& query)
{
    const Vec3 o = query.ray.origin - query.shift * query.ray.direction, d = query.ray.direction;
    RTCRay ray{};
    ray.org_x = static_cast<float>(o.x), ray.org_y = static_cast<float>(o.y), ray.org_z = static_cast<float>(o.z);
    ray.dir_x = static_cast<float>(d.x), ray.dir_y = static_cast<float>(d.y), ray.dir_z = static_cast<float>(d.z);
    ray.tnear = static_cast<float>(std::max(0.0, query.ray.t_min) * (1 - 0x1p-20));
    ray.tfar = static_cast<float>(std::min(query.limit * (1 + 0x1p-20) + 2 * query.shift, 1e30));
    ray.mask = ~0u;
    return ray;
}

void find_nearest(ExactQuery& query, RTCScene scene)
{
    RTCRayHit ray_hit{};
    ray_hit.ray = float_ray(query);
    ray_hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    if (!finite(ray_hit.ray)) {
        query.state->invalid_rays.fetch_add(1, std::memory_order_relaxed);
        return;
    }
    rtcIntersect1(scene, &query.context, &ray_hit);
}

bool finds_any(ExactQuery& query, RTCScene scene)
{
    RTCRay ray = float_ray(query);
    if (!finite(ray)) {
        query.state->invalid_rays.fetch_add(1, std::memory_order_relaxed);
        return false;
    }
    rtcOccluded1(scene, &query.context, &ray);
    return query.found;
}

void collect_boundaries(const Visibility::State& state, const Ray& ray, double limit, Crossings& crossings)
{
    ExactQuery query(state, ray);
    query.limit = limit, query.crossings = &crossings;
    find_nearest(query, state.null.get());
    if (query.too_many) state.runaway_walks.fetch_add(1, std::memory_order_relaxed);
}

Vec3 interpolated_normal(const Mesh& mesh, const ExactQuery& query)
{
    const glm::uvec3 index = mesh.triangles[query.primitive];
    return (1 - query.u - query.v) * mesh.normals[index.x] + query.u * mesh.normals[index.y] + query.v * mesh.normals[index.z];
}

Hit mesh_hit(const Mesh& mesh, const ExactQuery& query)
{
    const glm::uvec3 index = mesh.triangles[query.primitive];
    const Vec3 v0 = mesh.vertices[index.x], e1 = mesh.vertices[index.y] - v0, e2 = mesh.vertices[index.z] - v0;
    const Vec3 normal = triangle_normal(mesh, query.primitive);
    Vec3 shading = normal;
    if (!mesh.normals.empty()) {
        const Vec3 smooth = interpolated_normal(mesh, query);
        const double length = glm::length(smooth);
        if (length > 0) shading = smooth / (glm::dot(smooth, normal) < 0 ? -length : length);
    }
    return {.t = query.t,
            .position = v0 + query.u * e1 + query.v * e2,
            .geometric_normal = normal,
            .shading_normal = shading,
            .shape = query.shape,
            .primitive = query.primitive};
}

Hit quadric_hit(const TracedShape& traced, const ExactQuery& query)
{
    const Vec3 along = query.ray.origin + query.t * query.ray.direction;
    const Vec3 local = onto_quadric(traced.shape->type, Vec3(traced.to_local * glm::dvec4(along, 1)));
    const Vec3 normal = glm::normalize(glm::transpose(glm::dmat3(traced.to_local)) * quadric_normal(traced.shape->type, local));
    return {.t = query.t,
            .position = Vec3(traced.shape->to_world * glm::dvec4(local, 1)),
            .geometric_normal = normal,
            .shading_normal = normal,
            .shape = query.shape,
            .primitive = 0};
}

Hit hit_of(const ExactQuery& query)
{
    const TracedShape& traced = query.state->shapes[query.shape];
    Hit hit = traced.shape->type == Shape::Type::mesh ? mesh_hit(traced.shape->mesh, query) : quadric_hit(traced, query);
    if (traced.shape->flip_normals) hit.geometric_normal = -hit.geometric_normal, hit.shading_normal = -hit.shading_normal;
    return hit;
}

Ray segment(const Vec3& from, const Vec3& to)
{
    const double length = glm::length(to - from);
    return {.origin = from, .direction = (to - from) / length, .t_max = length};
}

bool blocked(const Visibility::State& state, const Ray& ray)
{
    if (!state.has_solids) return false;
    Ray shortened = ray;
    shortened.t_min += Visibility::endpoint_rounding, shortened.t_max -= Visibility::endpoint_rounding;
    if (!(shortened.t_min < shortened.t_max)) return false;
    ExactQuery query(state, shortened);
    return finds_any(query, state.solid.get());
}

}  // namespace

Visibility::Visibility(const Scene& scene, int threads) : state_(std::make_unique<State>(scene, threads)) {}
Visibility::~Visibility() = default;
Visibility::Visibility(Visibility&&) noexcept = default;

bool Visibility::intersect(const Ray& ray, Hit& hit) const
{
    ExactQuery solid(*state_, ray);
    if (state_->has_solids) find_nearest(solid, state_->solid.get());
    ExactQuery null(*state_, ray);
    null.limit = solid.limit;
    if (state_->has_nulls) find_nearest(null, state_->null.get());
    if (!null.found && !solid.found) return false;
    hit = hit_of(null.found ? null : solid);
    return true;
}

RayWalk Visibility::walk(const Ray& ray, int medium) const
{
    RayWalk walk{.origin = ray.origin, .direction = ray.direction};
    ExactQuery query(*state_, ray);
    if (state_->has_solids) find_nearest(query, state_->solid.get());
    walk.found = query.found;
    if (query.found) walk.surface = hit_of(query);
    Crossings crossings;
    if (state_->has_null_boundaries) collect_boundaries(*state_, ray, query.limit, crossings);
    walk.medium = cut_at_boundaries(crossings, {.t0 = ray.t_min, .t1 = query.limit, .at_surface = query.found}, medium, walk.pieces);
    return walk;
}

int Visibility::medium_behind(const Hit& hit, const Vec3& direction, int medium) const
{
    const Shape& shape = state_->scene.shapes[hit.shape];
    if (!shape.medium_boundary) return medium;
    return glm::dot(direction, hit.geometric_normal) > 0 ? shape.exterior : shape.interior;
}

Vec3 Visibility::leave(const Hit& hit, const Vec3& direction) const
{
    return hit.position + (glm::dot(direction, hit.geometric_normal) < 0 ? -surface_offset : surface_offset) * hit.geometric_normal;
}

bool Visibility::occluded(const Vec3& from, const Vec3& to) const { return from != to && blocked(*state_, segment(from, to)); }

Rgb Visibility::transmittance(const Vec3& from, int medium, const Vec3& to) const { return glm::exp(-optical_depth(from, medium, to)); }

Rgb Visibility::optical_depth(const Vec3& from, int medium, const Vec3& to) const
{
    if (from == to) return Rgb(0);
    const Ray ray = segment(from, to);
    if (blocked(*state_, ray)) return Rgb(std::numeric_limits<double>::infinity());
    Crossings crossings;
    if (state_->has_null_boundaries) collect_boundaries(*state_, ray, ray.t_max, crossings);
    MediumPieces pieces;
    cut_at_boundaries(crossings, {.t0 = 0, .t1 = ray.t_max, .at_surface = false}, medium, pieces);
    Rgb depth(0);
    for (const MediumPiece& piece : pieces)
        if (piece.medium != vacuum)
            depth += tyndall::optical_depth(state_->scene, {.medium = state_->scene.media[piece.medium], .origin = ray.origin, .direction = ray.direction, .t0 = piece.t0, .t1 = piece.t1});
    return depth;
}

void Visibility::in_arena(const std::function<void()>& work) const { run_in(state_->arena, work); }
std::uint64_t Visibility::runaway_walks() const { return state_->runaway_walks; }
std::uint64_t Visibility::invalid_rays() const { return state_->invalid_rays; }

}  // namespace tyndall
