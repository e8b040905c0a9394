#pragma once
/// Embree and nothing but Embree: what does a ray meet, and can two points see each other?
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include <boost/container/small_vector.hpp>

#include "kernels/shared/records.hpp"
#include "scene/scene.hpp"

namespace tyndall {

/// direction has unit length; only hits with t in (t_min, t_max) count.
struct Ray {
    Vec3 origin, direction;
    double t_min = 0, t_max = 1e30;
};

struct Hit {
    double t;
    Vec3 position;          ///< recomputed on the primitive in double, not origin + t direction
    Vec3 geometric_normal;  ///< unit, outward (flip_normals applied), not turned towards the ray
    Vec3 shading_normal;    ///< unit, same hemisphere as geometric_normal
    int shape;
    unsigned primitive;
};

/// A stretch of a ray inside one medium, by distance along the ray.
struct MediumPiece {
    int medium;
    double t0, t1;
};

/// A ray followed through null boundaries.
struct RayWalk {
    Vec3 origin{0}, direction{0, 0, 1};  ///< the ray's
    /// In order, touching, vacuum included; the last ends at the surface or at the ray's t_max.
    boost::container::small_vector<MediumPiece, 8> pieces;
    bool found = false;   ///< met a surface that is not null
    Hit surface;          ///< that surface, if found
    int medium = vacuum;  ///< the medium in front of it (of the last piece)
};

class Visibility {
public:
    /// Builds the acceleration structures; the scene must outlive it. threads 0: all.
    explicit Visibility(const Scene& scene, int threads = 0);
    ~Visibility();
    Visibility(Visibility&&) noexcept;

    /// Nearest hit with any surface, null ones included. False if none.
    bool intersect(const Ray& ray, Hit& hit) const;

    /// Follows the ray from `medium` through null boundaries (crossing one sets the medium by the side of its normal) to the first surface
    /// that is not null or to t_max. Coincident boundaries of adjacent or nested media are crossed in the order in which their media match.
    RayWalk walk(const Ray& ray, int medium) const;

    /// The medium that a ray leaving `hit` in `direction` is in, when it came from `medium` (unchanged unless the shape bounds a medium).
    int medium_behind(const Hit& hit, const Vec3& direction, int medium) const;

    /// Origin for a ray that leaves the surface at `hit` in `direction`: moved off the surface along the geometric normal by
    /// `surface_offset`.
    Vec3 leave(const Hit& hit, const Vec3& direction) const;

    /// True if a surface that is not null (opaque, mirror, glass) lies strictly between the points. Both ends are pulled back by
    /// `endpoint_rounding`.
    bool occluded(const Vec3& from, const Vec3& to) const;

    /// Transmittance per channel of the straight segment between the points, from medium `medium` at `from`, through null boundaries; 0 if
    /// anything else blocks it.
    Rgb transmittance(const Vec3& from, int medium, const Vec3& to) const;

    /// The same as optical depth: +infinity in every channel where blocked.
    Rgb optical_depth(const Vec3& from, int medium, const Vec3& to) const;

    /// Sets tfar to -infinity in every lane whose segment is blocked by a surface that is not null; null surfaces are not there.
    /// Lanes with tfar < tnear on entry are left alone. Parallel over packets.
    void occluded(std::span<ShadowPacket> packets) const;
    /// The same on the calling thread alone, whoever's it is.
    void occluded_here(std::span<ShadowPacket> packets) const;

    /// Runs `work` where TBB's parallel loops use at most the `threads` of the constructor.
    void in_arena(const std::function<void()>& work) const;

    /// Rays that met more than `max_crossings` null boundaries; their walk ended at the last one that was followed.
    std::uint64_t runaway_walks() const;
    /// Rays and packet lanes whose numbers were not finite. A ray then meets nothing; a lane is answered as blocked.
    std::uint64_t invalid_rays() const;

    static constexpr std::size_t max_crossings = 4096;
    /// Rounding of a point in render space (|x| <= 1, a few float roundings): 2^-21. Segment ends are shortened by it.
    static constexpr double endpoint_rounding = 0x1p-21;
    /// How far `leave` moves an origin, in render space: more than the float rounding of any hit.
    static constexpr double surface_offset = 0x1p-20;

    struct State;  ///< visibility/embree_scene.hpp

private:
    std::unique_ptr<State> state_;
};

}  // namespace tyndall
