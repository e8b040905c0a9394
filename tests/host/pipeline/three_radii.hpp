#pragma once
/// Density estimation at three radii, from which its value at radius 0 follows.
#include "whole_renderer.hpp"

namespace tyndall::test {

/// Mean over the pixels of every pass, by layer and channel.
using Passes = std::array<std::vector<Rgb>, layer_count>;

inline Passes passes_of(const Scene& scene, const RenderSettings& settings)
{
    Passes passes;
    std::array<Rgb, layer_count> before{};
    const RenderOutcome outcome = render(scene, settings, [&](const Progress& progress, const Film& film) {
        for (std::size_t l = 0; l < layer_count; ++l) {
            const Rgb sum = mean_over_pixels(film.mean(static_cast<Layer>(l))) * double(progress.passes_done);
            passes[l].push_back(sum - before[l]), before[l] = sum;
        }
        return true;
    });
    EXPECT_EQ(outcome.report.ledger.not_finite_pairs, 0u);
    return passes;
}

/// Renders at four times, twice and once the radius: the same light paths and eyes, so that differences are the radius's alone.
inline std::array<Passes, 3> at_three_radii(const Scene& scene, RenderSettings settings, double radius)
{
    std::array<Passes, 3> all;
    for (int k = 0; k < 3; ++k) {
        settings.beam_radius = radius * (4 >> k);
        all[static_cast<std::size_t>(k)] = passes_of(scene, settings);
    }
    return all;
}

/// At radius 0, taking away what grows as the radius (at boundaries) and as its square.
inline Mean extrapolated(const std::array<Passes, 3>& at, Layer layer, int channel)
{
    Mean mean;
    const auto l = static_cast<std::size_t>(layer);
    for (std::size_t pass = 0; pass < at[0][l].size(); ++pass) mean.add((8 * at[2][l][pass][channel] - 6 * at[1][l][pass][channel] + at[0][l][pass][channel]) / 3);
    return mean;
}
inline Mean mean_of(const Passes& passes, Layer layer, int channel)
{
    Mean mean;
    for (const Rgb& pass : passes[static_cast<std::size_t>(layer)]) mean.add(pass[channel]);
    return mean;
}

}  // namespace tyndall::test
