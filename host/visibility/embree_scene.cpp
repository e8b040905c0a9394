#include "visibility/embree_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tyndall/error.hpp"
#include "visibility/exact_hit.hpp"

namespace tyndall {
namespace {

constexpr float blocked = -std::numeric_limits<float>::infinity();

Vec3 transform_point(const Mat4& m, const Vec3& p) { return Vec3(m * glm::dvec4(p, 1)); }
Vec3 transform_direction(const Mat4& m, const Vec3& d) { return Vec3(m * glm::dvec4(d, 0)); }

Crossing crossing_of(const ExactQuery& query, int shape, double t, Vec3 normal)
{
    const Shape& s = *query.state->shapes[shape].shape;
    if (s.flip_normals) normal = -normal;
    const double cosine = glm::dot(query.ray.direction, normal);
    const bool entering = cosine <= 0;
    return {.t = t,
            .cosine = std::abs(cosine),
            .shape = shape,
            .from = entering ? s.exterior : s.interior,
            .to = entering ? s.interior : s.exterior};
}

/// Offers a hit to the query; true if it is the nearest surface so far. Boundaries that are collected never stop the ray.
template <class Normal>
bool offer(ExactQuery& query, int shape, const TriangleHit& hit, unsigned primitive, Normal normal)
{
    if (!(hit.t > query.ray.t_min && hit.t < query.limit)) return false;
    if (query.crossings) {
        if (!query.state->shapes[shape].shape->medium_boundary) return false;
        if (query.crossings->size() < Visibility::max_crossings)
            query.crossings->push_back(crossing_of(query, shape, hit.t, normal()));
        else
            query.too_many = true;
        return false;
    }
    query.found = true, query.shape = shape, query.primitive = primitive;
    query.limit = query.t = hit.t, query.u = hit.u, query.v = hit.v;
    return true;
}

/// Embree found a triangle in float: decide in double whether it counts.
void filter_triangle(const RTCFilterFunctionNArguments* arguments)
{
    auto& query = *reinterpret_cast<ExactQuery*>(arguments->context);
    const unsigned shape = RTCHitN_geomID(arguments->hit, 1, 0), triangle = RTCHitN_primID(arguments->hit, 1, 0);
    const Mesh& mesh = query.state->shapes[shape].shape->mesh;
    TriangleHit hit;
    if (!meet_plane(mesh, triangle, query.ray, hit) ||
        !offer(query, static_cast<int>(shape), hit, triangle, [&] { return triangle_normal(mesh, triangle); }))
        arguments->valid[0] = 0;
}

/// All hits of the query's ray with an analytic shape; the nearest accepted one in Embree's float distance, or a negative number.
float offer_quadric(ExactQuery& query, unsigned shape)
{
    const TracedShape& traced = query.state->shapes[shape];
    const Shape::Type type = traced.shape->type;
    const Vec3 origin = transform_point(traced.to_local, query.ray.origin),
               direction = transform_direction(traced.to_local, query.ray.direction);
    const QuadricHits hits = meet_quadric(type, origin, direction);
    float accepted = -1;
    for (int i = 0; i < hits.count; ++i) {
        const auto normal = [&] {
            const Vec3 local = quadric_normal(type, onto_quadric(type, origin + hits.t[i] * direction));
            return glm::normalize(glm::transpose(glm::dmat3(traced.to_local)) * local);
        };
        if (offer(query, static_cast<int>(shape), {.t = hits.t[i], .u = 0, .v = 0}, 0, normal))
            accepted = static_cast<float>(hits.t[i] + query.shift);
    }
    return accepted;
}

/// Only exact queries ask for the nearest hit.
void intersect_quadric(const RTCIntersectFunctionNArguments* arguments)
{
    if (!arguments->valid[0]) return;
    auto& query = *reinterpret_cast<ExactQuery*>(arguments->context);
    const float t = offer_quadric(query, arguments->geomID);
    if (t < 0) return;
    RTCRayN_tfar(RTCRayHitN_RayN(arguments->rayhit, 1), 1, 0) = t;
    RTCHitN_geomID(RTCRayHitN_HitN(arguments->rayhit, 1), 1, 0) = arguments->geomID;
}

/// Exact queries carry a filter in their context, shadow packets do not.
void occlude_quadric(const RTCOccludedFunctionNArguments* arguments)
{
    RTCRayN* rays = arguments->ray;
    const unsigned n = arguments->N;
    if (arguments->context->filter) {
        auto& query = *reinterpret_cast<ExactQuery*>(arguments->context);
        if (arguments->valid[0] && offer_quadric(query, arguments->geomID) >= 0) RTCRayN_tfar(rays, n, 0) = blocked;
        return;
    }
    const TracedShape& traced = *static_cast<const TracedShape*>(arguments->geometryUserPtr);
    for (unsigned i = 0; i < n; ++i) {
        if (!arguments->valid[i]) continue;
        const Vec3 o(RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i));
        const Vec3 d(RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i));
        const QuadricHits hits =
            meet_quadric(traced.shape->type, transform_point(traced.to_local, o), transform_direction(traced.to_local, d));
        for (int k = 0; k < hits.count; ++k)
            if (hits.t[k] > RTCRayN_tnear(rays, n, i) && hits.t[k] < RTCRayN_tfar(rays, n, i)) RTCRayN_tfar(rays, n, i) = blocked;
    }
}

/// Bounds of the unit shape's box after to_world.
Bounds quadric_box(const Shape& shape)
{
    const double bottom = shape.type == Shape::Type::sphere ? -1 : 0, top = shape.type == Shape::Type::disk ? 0 : 1;
    Bounds bounds;
    for (int corner = 0; corner < 8; ++corner)
        bounds.grow(transform_point(shape.to_world, {corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? top : bottom}));
    return bounds;
}

void quadric_bounds(const RTCBoundsFunctionArguments* arguments)
{
    const Bounds bounds = quadric_box(*static_cast<const TracedShape*>(arguments->geometryUserPtr)->shape);
    // 2^-20 of the coordinates and of the box covers the rounding to float with room to spare.
    const Vec3 margin = 0x1p-20 * (glm::max(glm::abs(bounds.low), glm::abs(bounds.high)) + (bounds.high - bounds.low));
    const Vec3 low = bounds.low - margin, high = bounds.high + margin;
    RTCBounds& out = *arguments->bounds_o;
    out.lower_x = static_cast<float>(low.x), out.lower_y = static_cast<float>(low.y), out.lower_z = static_cast<float>(low.z);
    out.upper_x = static_cast<float>(high.x), out.upper_y = static_cast<float>(high.y), out.upper_z = static_cast<float>(high.z);
}

void fill_triangles(RTCGeometry geometry, const Mesh& mesh, std::span<const glm::uvec3> chosen)
{
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
    auto* triangles = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), chosen.size()));
    if (!vertices || !triangles)
        throw Error("visibility: not enough memory for a mesh of " + std::to_string(chosen.size()) +
                    " triangles; use a coarser mesh");
    for (const Vec3& p : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(p[axis]);
    for (const glm::uvec3& t : chosen)
        for (int corner = 0; corner < 3; ++corner) *triangles++ = t[corner];
}

/// `chosen`: the triangles of a mesh.
void attach(const Visibility::State& state, RTCScene scene, unsigned index, std::span<const glm::uvec3> chosen)
{
    const TracedShape& traced = state.shapes[index];
    const bool mesh = traced.shape->type == Shape::Type::mesh;
    if (mesh && chosen.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(state.device.get(), mesh ? RTC_GEOMETRY_TYPE_TRIANGLE : RTC_GEOMETRY_TYPE_USER);
    if (mesh) {
        fill_triangles(geometry, traced.shape->mesh, chosen);
    } else {
        rtcSetGeometryUserPrimitiveCount(geometry, 1);
        rtcSetGeometryUserData(geometry, const_cast<TracedShape*>(&traced));
        rtcSetGeometryBoundsFunction(geometry, quadric_bounds, nullptr);
        rtcSetGeometryIntersectFunction(geometry, intersect_quadric);
        rtcSetGeometryOccludedFunction(geometry, occlude_quadric);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, index);
    rtcReleaseGeometry(geometry);
}

RTCScene new_scene(RTCDevice device)
{
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    return scene;
}

}  // namespace

Visibility::State::State(const Scene& traced_scene, int threads)
    : scene(traced_scene),
      device(rtcNewDevice(threads > 0 ? ("threads=" + std::to_string(threads)).c_str() : nullptr)),
      arena(threads > 0 ? threads : tbb::task_arena::automatic)
{
    if (!device)
        throw Error("visibility: Embree does not start on this processor (error " + std::to_string(rtcGetDeviceError(nullptr)) + ")");
    solid.reset(new_scene(device.get())), null.reset(new_scene(device.get()));
    for (const Shape& shape : scene.shapes)
        shapes.push_back(
            {.shape = &shape, .null = scene.bsdfs[shape.bsdf].type == Bsdf::Type::null, .to_local = glm::inverse(shape.to_world)});
    for (unsigned i = 0; i < shapes.size(); ++i) {
        attach(*this, shapes[i].null ? null.get() : solid.get(), i, shapes[i].shape->mesh.triangles);
        (shapes[i].null ? has_nulls : has_solids) = true;
        has_null_boundaries |= shapes[i].null && shapes[i].shape->medium_boundary;
    }
    rtcCommitScene(solid.get()), rtcCommitScene(null.get());
    leave_out_walls();
    if (rtcGetDeviceError(device.get()) != RTC_ERROR_NONE)
        throw Error("visibility: Embree could not build the scene; is there enough memory?");
}

void Visibility::State::leave_out_walls()
{
    std::vector<const Shape*> solids;
    for (const TracedShape& s : shapes)
        if (!s.null) solids.push_back(s.shape);
    walls = OuterWalls(solids);
    if (walls.empty()) return;
    between.reset(new_scene(device.get()));
    for (unsigned i = 0; i < shapes.size(); ++i)
        if (!shapes[i].null) attach(*this, between.get(), i, walls.others(shapes[i].shape->mesh));
    rtcCommitScene(between.get());
}

ExactQuery::ExactQuery(const Visibility::State& s, const Ray& r) : state(&s), ray(r), limit(r.t_max)
{
    rtcInitIntersectContext(&context);
    context.filter = filter_triangle;
    const Vec3 size = glm::abs(r.origin);
    shift = Visibility::surface_offset * std::max({1.0, size.x, size.y, size.z});
}

}  // namespace tyndall
