#include "volumes/medium_line.hpp"

#include <algorithm>

#include "kernels/shared/records.hpp"
#include "volumes/grid_record.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall {
namespace maths_double {
#include "kernels/volumes/grid_walk.h"
}
namespace {

using maths_double::GridCell;
using maths_double::GridWalk;

const Volume& density_of(const Scene& scene, const Medium& medium) { return scene.volumes[static_cast<std::size_t>(medium.density)]; }

maths_double::real3 real3_of(const Vec3& v) { return {v.x, v.y, v.z}; }

/// The corners are not negative.
bool is_empty(const GridCell& c) { return c.v000 + c.v100 + c.v010 + c.v110 + c.v001 + c.v101 + c.v011 + c.v111 == 0; }

/// A line on its way through the cells of a density grid. Shares of the line run from 0 at t0 to 1 at t1.
class DensityWalk {
public:
    DensityWalk(const Scene& scene, const MediumLine& line) : line_(line), volume_(density_of(scene, line.medium)), grid_(grid_record(volume_, 0)), left_(maths_double::most_grid_pieces(grid_))
    {
        walk_ = maths_double::begin_grid_walk(grid_, real3_of(line.origin + line.t0 * line.direction), real3_of(line.origin + line.t1 * line.direction));
        load();
    }

    bool in_grid() const { return maths_double::walks_grid(walk_) && left_ > 0; }
    void next() { walk_ = maths_double::next_cell(walk_), --left_, load(); }

    double beginning() const { return walk_.t; }
    double end() const { return maths_double::piece_end(walk_); }
    double t_of(double share) const { return std::min(line_.t0 + share * (line_.t1 - line_.t0), line_.t1); }

    /// Optical depth per channel from the beginning of the present piece to `share` in it.
    Rgb depth_to(double share) const
    {
        Rgb depth(integral(0, share));
        for (int c = 1; c < volume_.channels; ++c) depth[c] = integral(c, share);
        return (line_.t1 - line_.t0) * depth * line_.medium.sigma_t;
    }

    /// The share in the present piece at which the depth of a channel from the piece's beginning is `depth`, less than that of the whole piece: Newton's method
    /// for an integral that increases, kept between the ends of the part where the solution lies.
    double share_at(int channel, double depth) const
    {
        const int c = std::min(channel, volume_.channels - 1);
        const double scale = (line_.t1 - line_.t0) * line_.medium.sigma_t[channel];
        double low = beginning(), high = end(), whole = scale * integral(c, high), share = low + depth / whole * (high - low);
        for (int i = 0; i < 100; ++i) {  // halving alone would take 53
            const double over = scale * integral(c, share) - depth;
            (over > 0 ? high : low) = share;
            const double slope = scale * maths_double::walk_value(walk_, cells_[c], share), next = share - over / slope;
            const double better = next > low && next < high ? next : .5 * (low + high);  // also where the slope is 0
            if (better == share || std::abs(over) <= 0x1p-52 * whole) break;
            share = better;
        }
        return share;
    }

    /// Where the last of the channels gets to what is left of its limit; the piece's end if one does not. `through`: depth of the whole piece.
    double share_of_last(const Rgb& left, const Rgb& through) const
    {
        double share = beginning();
        for (int c = 0; c < 3; ++c) {
            if (!(left[c] > 0)) continue;
            if (!(left[c] < through[c])) return end();
            share = std::max(share, share_at(c, left[c]));
        }
        return share;
    }

private:
    void load()
    {
        if (!in_grid()) return;
        for (int c = 0; c < volume_.channels; ++c)
            cells_[c] = maths_double::load_cell(maths_double::grid_channel(grid_, static_cast<uint>(c)), volume_.values.data(), walk_.cell);
    }
    double integral(int c, double share) const { return is_empty(cells_[c]) ? 0 : maths_double::walk_integral(walk_, cells_[c], walk_.t, share); }

    const MediumLine& line_;
    const Volume& volume_;
    GridRecord grid_;
    GridWalk walk_{};
    unsigned left_;
    GridCell cells_[3]{};
};

/// No limit is looked at: opaque_distance.hpp knows it in closed form.
LineExtent extent_in_constant(const MediumLine& line)
{
    const Rgb depth = (line.t1 - line.t0) * line.medium.sigma_t;
    return {line.t0, line.t1, depth, depth};
}

Rgb value_at(const Volume& volume, const Vec3& point, bool clamped)
{
    const GridRecord grid = grid_record(volume, 0);
    const auto in_channel = [&](int c) {
        const GridRecord g = maths_double::grid_channel(grid, static_cast<uint>(c));
        return clamped ? maths_double::grid_value_clamped(g, volume.values.data(), real3_of(point)) : maths_double::grid_value(g, volume.values.data(), real3_of(point));
    };
    Rgb value(in_channel(0));
    for (int c = 1; c < volume.channels; ++c) value[c] = in_channel(c);
    return value;
}

}  // namespace

Rgb optical_depth(const Scene& scene, const MediumLine& line)
{
    if (line.medium.density == none) return (line.t1 - line.t0) * line.medium.sigma_t;
    Rgb depth(0);
    for (DensityWalk walk(scene, line); walk.in_grid(); walk.next()) depth += walk.depth_to(walk.end());
    return depth;
}

MediumPoint medium_at(const Scene& scene, const Medium& medium, const Vec3& point)
{
    MediumPoint at{.sigma_t = medium.sigma_t, .albedo = medium.albedo};
    if (medium.density != none) at.sigma_t *= value_at(density_of(scene, medium), point, false);
    if (medium.albedo_volume != none) at.albedo = value_at(scene.volumes[static_cast<std::size_t>(medium.albedo_volume)], point, true);
    return at;
}

DepthReached reach_depth(const Scene& scene, const MediumLine& line, int channel, double depth)
{
    if (line.medium.density == none) {
        const Rgb whole = optical_depth(scene, line);
        if (!(depth < whole[channel])) return {.depth = whole};
        const double t = std::min(line.t0 + depth / line.medium.sigma_t[channel], line.t1);
        return {.reached = true, .t = t, .depth = (t - line.t0) * line.medium.sigma_t};
    }
    DepthReached result;
    for (DensityWalk walk(scene, line); walk.in_grid(); walk.next()) {
        const Rgb through = walk.depth_to(walk.end());
        if (const double left = depth - result.depth[channel]; left < through[channel]) {
            const double share = walk.share_at(channel, left);
            return {.reached = true, .t = walk.t_of(share), .depth = result.depth + walk.depth_to(share)};
        }
        result.depth += through;
    }
    return result;
}

LineExtent extent_of(const Scene& scene, const MediumLine& line, const Rgb& limit)
{
    if (line.medium.density == none) return extent_in_constant(line);
    LineExtent extent{line.t1, line.t0};
    bool cut = !(largest(limit) > 0);
    for (DensityWalk walk(scene, line); walk.in_grid(); walk.next()) {
        const Rgb through = walk.depth_to(walk.end());
        if (!(largest(through) > 0)) continue;
        if (!cut) {
            if (extent.whole == Rgb(0)) extent.t0 = walk.t_of(walk.beginning());
            const double end = walk.share_of_last(limit - extent.whole, through);
            cut = end < walk.end();
            extent.t1 = walk.t_of(end), extent.depth = extent.whole + (cut ? walk.depth_to(end) : through);
        }
        extent.whole += through;
    }
    return extent;
}

}  // namespace tyndall
