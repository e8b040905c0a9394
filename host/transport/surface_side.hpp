#pragma once
/// A surface as one arriving ray meets it: what bsdf.cpp and its parts work on.
#include "transport/bsdf.hpp"
#include "transport/frame.hpp"

namespace tyndall {

/// Normals are turned towards where the ray comes from.
struct Side {
    const Bsdf* bsdf;  ///< of that side; null: it is black
    Vec3 shading, geometric;
    bool front;

    Rgb reflectance, transmittance, diffuse;  ///< of the Bsdf, here
    /// Index behind the surface over index before it.
    double eta() const { return front ? bsdf->eta : 1 / bsdf->eta; }
};

Side side_of(const Scene& scene, const Arrival& arrival);

/// The frame in which a rough surface's facets are told: its normal, and the direction of dp/du where that matters.
Frame facet_frame(const Scene& scene, const Side& side, const Hit& hit);

/// Both normals agree on which side `in` and `out` are; otherwise light would leak through the surface.
inline bool reflects_consistently(const Side& side, const Vec3& in, const Vec3& out)
{
    return glm::dot(in, side.shading) < 0 && glm::dot(out, side.shading) > 0 && glm::dot(out, side.geometric) > 0;
}
inline bool transmits_consistently(const Side& side, const Vec3& in, const Vec3& out)
{
    return glm::dot(in, side.shading) < 0 && glm::dot(out, side.shading) < 0 && glm::dot(out, side.geometric) < 0;
}

/// What light that leaves along `out` is multiplied by for the arrival's mode: 1 for reflected radiance, 1 / eta^2 for refracted radiance, and what the cosine of `out`
/// becomes for flux that is carried over a shading normal, relative to |out . shading|.
double mode_factor(const Side& side, const Arrival& arrival, const Vec3& out);

}  // namespace tyndall
