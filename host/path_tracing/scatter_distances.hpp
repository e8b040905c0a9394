#pragma once
/// Distances on a straight stretch of a medium in proportion to extinction x transmittance: exponential ones in homogeneous media, by regular tracking in grids.
#include "path_tracing/segment_sampling.hpp"
#include "volumes/medium_line.hpp"

namespace tyndall {

/// What a medium is like at a point of a stretch.
struct PointOnStretch {
    Rgb depth;             ///< optical depth from the stretch's beginning
    Rgb sigma_t, sigma_s;
};

class ScatterDistances {
public:
    /// The stretch is origin + u direction, 0 <= u <= line.t1 (line.t0 is 0), `depth` its optical depth. Channels are chosen in proportion to throughput x
    /// scattering.
    ScatterDistances(const Scene& scene, const MediumLine& line, const Rgb& throughput, const Rgb& depth);

    /// Nothing on the stretch scatters light that reaches the camera: there is nothing to sample.
    bool empty() const { return !(sum(mixture_.share) > 0); }
    /// Largest optical depth of the stretch, over channels.
    double thickness() const { return largest(total_); }
    PointOnStretch at(double u) const;
    double sample(const Vec2& xi) const;
    /// Density of sample per length, at the point at u; finite, and 0 only where no channel that scatters has extinction.
    double pdf(double u, const PointOnStretch& at) const;

private:
    const Scene& scene_;
    MediumLine line_;
    ExponentialMixture mixture_;
    Rgb total_;  ///< optical depth of the stretch
};

}  // namespace tyndall
