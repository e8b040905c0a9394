#pragma once
/// Where light goes when it meets a surface. As in phase_function.hpp, `in` and `out` are directions of travel before and after.
#include "scene/fresnel.hpp"
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

/// What a surface does with light: each part is sampled by sample_bsdf, and each makes a different vertex of the path.
struct SurfaceParts {
    bool specular = false;    ///< it reflects or refracts in discrete directions: the path goes on as if it had not been scattered
    bool scattering = false;  ///< it scatters over directions: a vertex that can be connected to
    bool lambertian = false;  ///< the scattering part sends the same radiance in all directions of its side, and nothing to the other: virtual lights connect to it
    bool through = false;     ///< the scattering part sends light to both sides
};
SurfaceParts parts_of(const Bsdf& bsdf);
/// Of the side at which the ray arrives; none for a black back.
SurfaceParts parts_at(const Scene& scene, const Arrival& arrival);

/// Reflects or refracts in discrete directions, besides whatever else it does (dielectric, conductor, plastic). Null does not.
bool specular(const Bsdf& bsdf);

/// The scattering part: BSDF x |cosine of out to the shading normal| (for importance: x |in.ns| |out.ng| / |in.ng|); 0 for specular and null surfaces.
/// Radiance is divided by eta^2 where it is refracted, importance is not.
Rgb evaluate_bsdf(const Scene& scene, const Arrival& arrival, const Vec3& out);

/// Density of sample_bsdf's directions of the scattering part per steradian, with the probability that it is chosen; 0 for specular and null surfaces.
double pdf_bsdf(const Scene& scene, const Arrival& arrival, const Vec3& out);

/// Of all parts.
BsdfSample sample_bsdf(const Scene& scene, const Arrival& arrival, const Vec2& xi);

/// Of the specular part alone, with all of its weight: sample_bsdf's for surfaces that have no other.
BsdfSample sample_specular(const Scene& scene, const Arrival& arrival, const Vec2& xi);

/// Fraction of light that the side of the surface at which `in` arrives scatters in all directions: reflectance of a diffuse surface, of what lies below the boundary of
/// a plastic (0 for all others and for black backs).
Rgb diffuse_reflectance(const Scene& scene, const Hit& hit, const Vec3& in);

}  // namespace tyndall
