#include "pipeline/choose_sampler.hpp"

#include <fmt/format.h>

#include <cmath>

#include "kernels/shared/host_features.hpp"
#include "kernels/shared/records.hpp"
#include "scene/text.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

/// g^2; of a blend the mean over its parts, so that forward and backward lobes do not cancel.
double squared_unevenness(const PhaseFunction& phase)
{
    double square = phase.parts.empty() ? phase.g * phase.g : 0;
    for (const PhaseFunction& part : phase.parts) square += part.weight * part.g * part.g;
    return square;
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

/// Least |g| from which the product wins at equal time: measured crossings, with a shadow segment for every connection and without.
constexpr double wins_with_shadow_segments = .35, wins_without = .55;

}  // namespace

ChosenSampler choose_sampler(const Scene& scene, const SceneFeatures& features, Sampler wanted)
{
    if (wanted != Sampler::automatic) return {asked_for(wanted), "asked for"};
    const bool shadowed = features.media_to_media & feature_bit::occluders;
    const double from = shadowed ? wins_with_shadow_segments : wins_without;
    const char* reason = shadowed ? "connections ask shadow segments" : "nothing stands between media";
    const Medium* most = nullptr;
    for (const Medium& medium : scene.media)
        if (!most || squared_unevenness(medium.phase) > squared_unevenness(most->phase)) most = &medium;
    if (!most || squared_unevenness(most->phase) < from * from)
        return {SAMPLER_PAPER_ISOTROPIC, fmt::format("no medium scatters as unevenly as |g| = {:g}, from where on the product of phase functions pays if {}, so the angle alone is drawn", from, reason)};
    return {SAMPLER_PAPER, fmt::format("medium {} scatters with |g| = {:.2g}: from {:g} on the product of phase functions pays if {}", in_quotes(most->name),
                                       std::sqrt(squared_unevenness(most->phase)), from, reason)};
}

std::string sampler_name(int sampler)
{
    for (const auto& named : sampler_names)
        if (named.value != Sampler::automatic && asked_for(named.value) == sampler) return std::string(named.name);
    return {};
}

int choose_sequence(Sequence wanted, int samples_per_pair)
{
    const bool several = samples_per_pair > 1;  // for one sample the gain is what the numbers cost (host/docs/performance.md)
    return wanted == Sequence::sobol || (wanted == Sequence::automatic && several) ? SEQUENCE_SOBOL : SEQUENCE_RANDOM;
}

}  // namespace tyndall
