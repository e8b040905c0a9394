#pragma once
/// Rough conductors, dielectrics and plastics by facets, in the frame of facet_frame: light arrives from `from` and leaves along `out`, both pointing away from the surface,
/// from.z > 0.
#include "transport/surface_side.hpp"

namespace tyndall {

struct Scattering {
    Rgb value{0};    ///< BSDF x |out.z| as importance sees it
    double pdf = 0;  ///< of sample_rough, per steradian
};

/// [Walter et al. 2007, eq. 20, 21], with Smith's shadowing of each direction by itself, as Mitsuba has it. Light that would meet a second facet is lost.
Scattering scatter_rough(const Side& side, const Vec3& from, const Vec3& out);

/// A direction with the density above; 0 where the facet that was drawn sends light nowhere.
Vec3 sample_rough(const Side& side, const Vec3& from, const Vec2& xi);

}  // namespace tyndall
