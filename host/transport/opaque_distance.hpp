#pragma once
/// Where a stretch of a medium stops to matter.
#include <algorithm>
#include <limits>

#include "scene/scene.hpp"

namespace tyndall {

inline constexpr double opaque_depth = 104;

/// The distance at which transmittance is zero in float in every channel that scatters: exp(-104) < 2^-149, the smallest positive float, so what lies beyond
/// adds exactly 0. `before`: optical depth already behind the light; nothing is left (<= 0) if that is enough. Infinity for a medium that does not scatter.
/// For homogeneous media; lit_stretch.hpp for all.
inline double opaque_distance(const Medium& medium, const Rgb& before = Rgb(0))
{
    const Rgb sigma_s = medium.sigma_s();
    double distance = -std::numeric_limits<double>::infinity();
    for (int c = 0; c < 3; ++c)
        if (sigma_s[c] > 0) distance = std::max(distance, (opaque_depth - before[c]) / medium.sigma_t[c]);
    return sigma_s == Rgb(0) ? std::numeric_limits<double>::infinity() : distance;
}

}  // namespace tyndall
