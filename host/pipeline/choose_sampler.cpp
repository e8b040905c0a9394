#include "pipeline/choose_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/shared/records.hpp"

namespace tyndall {

int choose_sampler(const Scene& scene, Sampler wanted)
{
    constexpr double product_wins_from = .5;  // |g|
    if (wanted == Sampler::paper_isotropic) return SAMPLER_PAPER_ISOTROPIC;
    if (wanted == Sampler::paper) return SAMPLER_PAPER;
    const bool uneven = std::any_of(scene.media.begin(), scene.media.end(), [](const Medium& m) { return std::abs(m.phase.g) >= product_wins_from; });
    return uneven ? SAMPLER_PAPER : SAMPLER_PAPER_ISOTROPIC;
}

}  // namespace tyndall
