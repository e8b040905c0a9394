#include "transport/lit_stretch.hpp"

#include "transport/opaque_distance.hpp"

namespace tyndall {

LitStretch lit_stretch(const Scene& scene, const MediumLine& line, const Rgb& before)
{
    if (line.medium.density == none) {
        const double length = std::min(line.t1 - line.t0, opaque_distance(line.medium, before));
        return {line.t0, length, length * line.medium.sigma_t, optical_depth(scene, line)};
    }
    const Rgb sigma_s = line.medium.sigma_s();
    Rgb limit(0);
    for (int c = 0; c < 3; ++c)
        if (sigma_s[c] > 0) limit[c] = opaque_depth - before[c];
    const LineExtent extent = extent_of(scene, line, limit);
    return {extent.t0, extent.t1 - extent.t0, extent.depth, extent.whole};
}

}  // namespace tyndall
