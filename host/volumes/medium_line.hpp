#pragma once
/// Extinction along straight lines and at points, in homogeneous media and in density grids: nothing else on the host knows which of them a medium is. Grids
/// are walked cell by cell by the kernels' own text in double precision, so optical depths are exact.
#include "scene/scene.hpp"

namespace tyndall {

/// A stretch of a straight line inside one medium: the points origin + t direction, t0 <= t <= t1, |direction| = 1. t1 may be as large as 1e30.
struct MediumLine {
    const Medium& medium;
    Vec3 origin, direction;
    double t0, t1;
};

/// Per channel. A grid is 0 outside of its box; a homogeneous medium is everywhere the same.
Rgb optical_depth(const Scene& scene, const MediumLine& line);

/// Coefficients at a point.
struct MediumPoint {
    Rgb sigma_t, albedo;
    Rgb sigma_s() const { return albedo * sigma_t; }
};
MediumPoint medium_at(const Scene& scene, const Medium& medium, const Vec3& point);

/// Where the optical depth from the line's beginning reaches a value.
struct DepthReached {
    bool reached = false;
    double t = 0;   ///< if reached
    Rgb depth{0};   ///< per channel, up to there; of the whole line if it is not reached
};
DepthReached reach_depth(const Scene& scene, const MediumLine& line, int channel, double depth);

/// The part of a line that matters: between the first and the last place where the medium is not empty, and no farther than to where the optical depth has
/// reached a limit in every channel (in a grid; all of a line in a homogeneous medium). Nothing is left if t1 <= t0.
struct LineExtent {
    double t0, t1;
    Rgb depth{0};  ///< optical depth of this part
    Rgb whole{0};  ///< of the whole line
};
inline constexpr double no_limit = 1e300;
LineExtent extent_of(const Scene& scene, const MediumLine& line, const Rgb& limit = Rgb(no_limit));

}  // namespace tyndall
