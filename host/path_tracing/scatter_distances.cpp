#include "path_tracing/scatter_distances.hpp"

#include <cmath>

namespace tyndall {
namespace {

/// Extinction x transmittance over its integral, 1 - exp(-total). A grid's value is anything from 0.
double pdf_tracking(double sigma, double depth, double total) { return sigma * std::exp(-depth) / -std::expm1(-total); }

}  // namespace

ScatterDistances::ScatterDistances(const Scene& scene, const MediumLine& line, const Rgb& throughput, const Rgb& depth)
    : scene_(scene), line_(line), mixture_{.sigma = line.medium.sigma_t, .share = throughput * line.medium.sigma_s(), .length = line.t1}, total_(depth)
{
    if (line.medium.density != none)
        for (int c = 0; c < 3; ++c)
            if (!(total_[c] > 0)) mixture_.share[c] = 0;
    if (const double strength = sum(mixture_.share); strength > 0) mixture_.share = mixture_.share / strength;
}

PointOnStretch ScatterDistances::at(double u) const
{
    if (line_.medium.density == none) return {.depth = u * line_.medium.sigma_t, .sigma_t = line_.medium.sigma_t, .sigma_s = line_.medium.sigma_s()};
    MediumLine before = line_;
    before.t1 = u;
    const MediumPoint point = medium_at(scene_, line_.medium, line_.origin + u * line_.direction);
    return {.depth = optical_depth(scene_, before), .sigma_t = point.sigma_t, .sigma_s = point.sigma_s()};
}

double ScatterDistances::sample(const Vec2& xi) const
{
    if (line_.medium.density == none) return sample_mixture(mixture_, xi);
    const int channel = choose_channel(mixture_, xi.x);
    const double depth = -std::log1p(xi.y * std::expm1(-total_[channel]));
    const DepthReached reached = reach_depth(scene_, line_, channel, depth);
    return reached.reached ? reached.t : line_.t1;  // not reached: by rounding, for the last of the random numbers
}

double ScatterDistances::pdf(double u, const PointOnStretch& at) const
{
    if (line_.medium.density == none) return pdf_mixture(mixture_, u);
    double pdf = 0;
    for (int c = 0; c < 3; ++c)
        if (mixture_.share[c] > 0) pdf += mixture_.share[c] * pdf_tracking(at.sigma_t[c], at.depth[c], total_[c]);
    return pdf;
}

}  // namespace tyndall
