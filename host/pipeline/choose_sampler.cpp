#include "pipeline/choose_sampler.hpp"

#include <fmt/format.h>

#include <cmath>

#include "kernels/shared/records.hpp"
#include "scene/text.hpp"

namespace tyndall {
namespace {

/// |g|; of a blend the root mean square over its parts, so that forward and backward lobes do not cancel.
double unevenness(const PhaseFunction& phase)
{
    double square = phase.parts.empty() ? phase.g * phase.g : 0;
    for (const PhaseFunction& part : phase.parts) square += part.weight * part.g * part.g;
    return std::sqrt(square);
}

int asked_for(Sampler wanted)
{
    switch (wanted) {
        case Sampler::paper: return SAMPLER_PAPER;
        case Sampler::paper_6: return SAMPLER_PAPER_6;
        case Sampler::table: return SAMPLER_TABLE;
        case Sampler::table_4x4: return SAMPLER_TABLE_4X4;
        case Sampler::table_3x2: return SAMPLER_TABLE_3X2;
        default: return SAMPLER_PAPER_ISOTROPIC;
    }
}

constexpr double product_wins_from = .5;  ///< unevenness

}  // namespace

ChosenSampler choose_sampler(const Scene& scene, Sampler wanted)
{
    if (wanted != Sampler::automatic) return {asked_for(wanted), "asked for"};
    const Medium* most = nullptr;
    for (const Medium& medium : scene.media)
        if (!most || unevenness(medium.phase) > unevenness(most->phase)) most = &medium;
    if (!most || unevenness(most->phase) < product_wins_from)
        return {SAMPLER_PAPER_ISOTROPIC, fmt::format("no medium scatters more unevenly than |g| = {:g}, so the angle alone is drawn", product_wins_from)};
    return {SAMPLER_PAPER, fmt::format("medium {} scatters with |g| = {:.2g}: from {:g} on the product of phase functions pays", in_quotes(most->name), unevenness(most->phase), product_wins_from)};
}

std::string sampler_name(int sampler)
{
    constexpr const char* names[] = {"paper-isotropic", "paper", "paper-6", "table", "table-4x4", "table-3x2"};
    return names[sampler];
}

int choose_sequence(Sequence wanted, int samples_per_pair)
{
    const bool several = samples_per_pair > 1;  // for one sample the gain is what the numbers cost (host/docs/performance.md)
    return wanted == Sequence::sobol || (wanted == Sequence::automatic && several) ? SEQUENCE_SOBOL : SEQUENCE_RANDOM;
}

}  // namespace tyndall
