#include "transport/lit_stretch.hpp"

#include "transport/opaque_distance.hpp"

namespace tyndall {
namespace {

/// opaque_distance for a grid: the largest of the distances at which the channels that scatter are opaque.
double opaque_t(const Scene& scene, const MediumLine& line, const Rgb& before)
{
    const Rgb sigma_s = line.medium.sigma_s();
    double t = line.t0;
    for (int c = 0; c < 3; ++c) {
        if (!(sigma_s[c] > 0) || before[c] >= opaque_depth) continue;
        const DepthReached opaque = reach_depth(scene, line, c, opaque_depth - before[c]);
        if (!opaque.reached) return line.t1;
        t = std::max(t, opaque.t);
    }
    return t;
}

}  // namespace

LitStretch lit_stretch(const Scene& scene, const MediumLine& line, const Rgb& before)
{
    if (line.medium.density == none) return {line.t0, std::min(line.t1 - line.t0, opaque_distance(line.medium, before))};
    const LineExtent extent = extent_of(scene, line);
    return {extent.t0, std::min(extent.t1, opaque_t(scene, line, before)) - extent.t0};
}

}  // namespace tyndall
