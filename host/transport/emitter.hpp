#pragma once
/// Light sources: which one, where on it, which way. Everything that a path from the camera or from a light asks of them.
#include <vector>

#include "scene/scene.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

/// A point on a light that has a place (point, spot, area).
struct EmitterPoint {
    Vec3 position;
    Vec3 normal{0};  ///< unit, on the glowing side; 0 for point and spot
    double pdf = 1;  ///< per area; 1 for point and spot, which have one point
};

/// Light that arrives at a reference point along a straight line, before transmittance and visibility.
struct DirectSample {
    Vec3 direction;          ///< unit, from the reference point to the light
    double distance = 1e30;  ///< to the light
    Vec3 position{0};        ///< on the light; meaningless if infinite
    Rgb weight{0};  ///< estimate of the integral of radiance over solid angle, given the emitter: radiance / pdf, or intensity / distance^2
    double pdf = 0;         ///< per steradian at the reference point, given the emitter; 0 if delta
    bool delta = false;     ///< no ray finds this light by chance (point, spot, directional)
    bool infinite = false;  ///< from outside the scene (Emitter::outside)
};

/// Where light begins.
struct EmissionSample {
    Vec3 origin;  ///< already off the emitting surface (Visibility::surface_offset); on the scene's bounding sphere's disk if from outside
    Vec3 direction;       ///< of travel
    Rgb weight{0};        ///< emitted radiance x cosine / density: its mean is the emitter's power
    Vec3 normal{0};       ///< of the emitting surface, 0 if none
    int medium = vacuum;  ///< in which it starts
};

struct EmitterChoice {
    int emitter;
    double probability;
};

/// Chooses emitters in proportion to (an estimate of) their power, and points on them. Built once per scene, which must outlive it.
class EmitterSampler {
public:
    explicit EmitterSampler(const Scene& scene);

    /// No emitter gives any light.
    bool empty() const { return total_ <= 0; }
    EmitterChoice choose(double xi) const;
    double probability(int emitter) const { return powers_[emitter] / total_; }
    const Scene& scene() const { return scene_; }

    /// Radius and centre of a sphere around the scene: light from outside starts on it.
    double scene_radius() const { return radius_; }
    const Vec3& scene_centre() const { return centre_; }

    /// Uniform by area on an area emitter; the position itself of a point or spot. Not for lights from outside.
    EmitterPoint sample_point(int emitter, const Vec2& xi) const;

    /// Density per area with which sample_point finds the point of `hit`, on its emitter.
    double pdf_point(const Hit& hit) const;

private:
    struct AreaTable {
        std::vector<double> cumulative;  ///< of triangle areas
    };
    double power(const Emitter& emitter, double surface_area) const;
    double surface_area(const Shape& shape, AreaTable& table) const;
    EmitterPoint sample_mesh(const Shape& shape, const AreaTable& table, Vec2 xi) const;

    const Scene& scene_;
    Vec3 centre_{0};
    double radius_ = 1, total_ = 0;
    std::vector<double> powers_, cumulative_;
    std::vector<AreaTable> tables_;  ///< per emitter
};

/// Intensity that leaves `point` of the emitter in unit direction `out`: W/sr for point and spot; radiance x cosine (0 behind) for area.
Rgb intensity(const Emitter& emitter, const EmitterPoint& point, const Vec3& out);

/// Falloff of a spot in [0, 1] at the angle of `out` to its axis: 1 within `beam`, linear in the angle to 0 at `cutoff`.
double spot_falloff(const Emitter& emitter, const Vec3& out);

/// Direct light at `reference` from one emitter.
DirectSample sample_direct(const EmitterSampler& emitters, int emitter, const Vec3& reference, const Vec2& xi);

/// Density per steradian, times the choice's probability, with which sample_direct at `reference` finds the area emitter that a ray from
/// there met at `hit`.
double pdf_direct(const EmitterSampler& emitters, const Vec3& reference, const Hit& hit);

/// Does a ray that leaves the scene meet this emitter's light by chance (constant, envmap)?
bool all_around(const Emitter& emitter);

/// Radiance that a ray along unit `direction`, which leaves the scene, meets there; `emitter` is all around.
Rgb radiance_from_outside(const Scene& scene, const Emitter& emitter, const Vec3& direction);

/// As pdf_direct, for a ray along unit `direction` that left the scene and an emitter all around.
double pdf_direct_outside(const EmitterSampler& emitters, int emitter, const Vec3& direction);

/// Radiance that a ray travelling along `direction` meets at `hit`: of the area emitter there, on its front.
Rgb emitted_radiance(const Scene& scene, const Hit& hit, const Vec3& direction);

/// Begins a light path: xi_position chooses where, xi_direction which way.
EmissionSample sample_emission(const EmitterSampler& emitters, int emitter, const Vec2& xi_position, const Vec2& xi_direction);

/// Transmittance from `from` (in `medium`) to the light of `sample`, 0 if blocked. Light from outside crosses whatever lies on its way,
/// without end.
Rgb transmittance_to(const Visibility& visibility, const Scene& scene, const Vec3& from, int medium, const DirectSample& sample);

}  // namespace tyndall
