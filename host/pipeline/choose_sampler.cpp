#include "pipeline/choose_sampler.hpp"

#include <algorithm>
#include <cmath>

#include "kernels/shared/records.hpp"

namespace tyndall {
namespace {

/// |g|; of a blend the root mean square over its parts, so that forward and backward lobes do not cancel.
double unevenness(const PhaseFunction& phase)
{
    double square = phase.parts.empty() ? phase.g * phase.g : 0;
    for (const PhaseFunction& part : phase.parts) square += part.weight * part.g * part.g;
    return std::sqrt(square);
}

}  // namespace

int choose_sampler(const Scene& scene, Sampler wanted)
{
    constexpr double product_wins_from = .5;  // unevenness
    if (wanted == Sampler::paper_isotropic) return SAMPLER_PAPER_ISOTROPIC;
    if (wanted == Sampler::paper) return SAMPLER_PAPER;
    if (wanted == Sampler::paper_6) return SAMPLER_PAPER_6;
    if (wanted == Sampler::table) return SAMPLER_TABLE;
    if (wanted == Sampler::table_4x4) return SAMPLER_TABLE_4X4;
    if (wanted == Sampler::table_3x2) return SAMPLER_TABLE_3X2;
    const bool uneven = std::any_of(scene.media.begin(), scene.media.end(), [](const Medium& m) { return unevenness(m.phase) >= product_wins_from; });
    return uneven ? SAMPLER_PAPER : SAMPLER_PAPER_ISOTROPIC;
}

int choose_sequence(Sequence wanted, int samples_per_pair)
{
    const bool several = samples_per_pair > 1;  // for one sample the gain is what the numbers cost (host/docs/performance.md)
    return wanted == Sequence::sobol || (wanted == Sequence::automatic && several) ? SEQUENCE_SOBOL : SEQUENCE_RANDOM;
}

}  // namespace tyndall
