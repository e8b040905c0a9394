#pragma once
/// Where light goes when it meets a surface. As in phase_function.hpp, `in` and `out` are directions of travel before and after.
#include "scene/scene.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

/// What a path carries: radiance on paths from the camera, importance's adjoint (flux) on paths from a light. They differ in refraction
/// (radiance is divided by eta^2 on the way in) and at shading normals [Veach 1997, 5.2, 5.3].
enum class TransportMode { radiance, importance };

struct BsdfSample {
    Vec3 direction{0};
    Rgb weight{0};             ///< BSDF x cosine / density; 0: absorbed
    double pdf = 0;            ///< per steradian; 0 if delta
    bool delta = false;        ///< the direction has a discrete probability
    bool transmitted = false;  ///< it goes on at the other side
};

/// A ray arriving at a hit.
struct Arrival {
    const Hit& hit;
    Vec3 in;
    TransportMode mode = TransportMode::radiance;
};

const Bsdf& bsdf_of(const Scene& scene, const Hit& hit);

/// Reflects and refracts in discrete directions only (dielectric, conductor). Null counts as neither specular nor scattering.
bool specular(const Bsdf& bsdf);

/// BSDF x |cosine of out to the shading normal| (for importance: x |in.ns| |out.ng| / |in.ng|), 0 for specular and null surfaces.
Rgb evaluate_bsdf(const Scene& scene, const Arrival& arrival, const Vec3& out);

/// Density of sample_bsdf's directions per steradian, 0 for specular and null surfaces.
double pdf_bsdf(const Scene& scene, const Arrival& arrival, const Vec3& out);

BsdfSample sample_bsdf(const Scene& scene, const Arrival& arrival, const Vec2& xi);

/// Fraction of light that the side of the surface at which `in` arrives scatters in all directions (0 for specular and null surfaces and
/// for black backs).
Rgb diffuse_reflectance(const Scene& scene, const Hit& hit, const Vec3& in);

/// Unpolarised Fresnel reflectance of a smooth boundary; cosine >= 0 on the side of arrival, eta = index behind / index before. 1 at total
/// reflection.
double fresnel_dielectric(double cosine, double eta);

/// The same for a conductor with complex index eta + i k relative to the outside.
double fresnel_conductor(double cosine, double eta, double k);

}  // namespace tyndall
