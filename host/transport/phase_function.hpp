#pragma once
/// Where light goes when it scatters in a medium. `in` and `out` are directions of travel before and after, unit length; mu = in . out, g >
/// 0 forward.
#include "scene/scene.hpp"

namespace tyndall {

struct PhaseSample {
    Vec3 direction;
    double pdf;  ///< per steradian; equals the phase function, so the weight is 1
};

/// Per steradian; integrates to 1 over `out`. Henyey-Greenstein as (1-g)(1+g) / (4 pi ((1-|g|)^2 + |g| |in -+ out|^2)^(3/2)), which keeps
/// its digits at the peak.
double evaluate_phase(const PhaseFunction& phase, const Vec3& in, const Vec3& out);

/// Proportional to the phase function: the exact inverse of its distribution of mu, after the choice of a part of a blend.
PhaseSample sample_phase(const PhaseFunction& phase, const Vec3& in, const Vec2& xi);

}  // namespace tyndall
