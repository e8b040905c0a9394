#include "pipeline/build_masks.hpp"

#include "kernels/shared/host_features.hpp"
#include "kernels/shared/records.hpp"
#include "pipeline/choose_sampler.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

std::string place(const SourceLocation& where) { return where.line > 0 ? to_string(where) + ": " : ""; }

void check_layer(const SceneFeatures& features, Layer layer, std::uint32_t wanted)
{
    for (const FeatureCause& cause : features.causes)
        if (cause.layer == layer && (cause.bit & ~wanted))
            throw UsageError("--features \"" + feature_names(wanted) + "\" lacks " + feature_names(cause.bit) + ", which " + std::string(name(layer)) + " needs: " + place(cause.where) +
                             cause.cause + "; add it, or leave --features out");
}

}  // namespace

BuildMasks build_masks(const SceneFeatures& features, const LayerPlan& plan, const std::optional<std::uint32_t>& wanted)
{
    if (!wanted) return {features.media_to_media, features.media_to_surface};
    if ((*wanted & feature_bit::nonconvex_media) && !(*wanted & feature_bit::occluders))
        throw UsageError("--features: NONCONVEX_MEDIA needs OCCLUDERS, because the host's walk answers both questions; add it");
    if (plan.media_to_media) check_layer(features, Layer::media_to_media, *wanted);
    if (plan.media_to_surface) check_layer(features, Layer::media_to_surface, *wanted);
    return {*wanted, *wanted};
}

std::string grid_transmittance(const RenderSettings& settings, const LayerPlan& plan, const BuildMasks& masks)
{
    const std::uint32_t built = (plan.media_to_media ? masks.media_to_media : 0u) | (plan.media_to_surface ? masks.media_to_surface : 0u);
    if (!(built & feature_bit::heterogeneous)) return {};
    if (settings.transmittance == GridTransmittance::exact) return "exact: cell by cell for every pair; unbiased";
    return "march: tables and a jittered march, with an exact correction for one pair in 64; unbiased, and a pass can hold negative values";
}

std::string doubt_about_math(const RenderSettings& settings)
{
    if (settings.math == KernelMath::strict) return {};
    return "--math fast: compilers may reorder and approximate what was proved to be stable, and the selftest does not cover it; compare the image with one of --math strict";
}

PairProgram pair_program(const LayerPlan& plan, const RenderSettings& settings, EyeKind kind, const BuildMasks& masks, int lanes)
{
    const std::uint32_t features = kind == EyeKind::segments ? masks.media_to_media : masks.media_to_surface;
    int sampler = kind == EyeKind::segments ? plan.sampler : SAMPLER_PAPER_ISOTROPIC;  // points are the same program for every sampler
    if (sampler == SAMPLER_PAPER && !(features & feature_bit::anisotropic)) sampler = SAMPLER_PAPER_ISOTROPIC;    // and so are these two
    const LightTechnique& technique = *plan.technique;
    return {.light = std::string(technique.name),
            .light_bytes = static_cast<std::uint32_t>(technique.record_bytes),
            .light_is_line = technique.is_line,
            .eyes = kind,
            .features = features,
            .lanes = lanes,
            .sampler = sampler,
            .sequence = choose_sequence(settings.sequence, settings.samples_per_pair),
            .samples = static_cast<std::uint32_t>(settings.samples_per_pair),
            .selection = plan.selection.chosen,
            .transmittance = settings.transmittance == GridTransmittance::exact ? TRANSMITTANCE_EXACT : TRANSMITTANCE_MARCH,
            .clamp = static_cast<float>(plan.clamp),
            .precision = settings.precision == Precision::f64 ? 64 : 32,
            .fast_math = settings.math == KernelMath::fast};
}

PairProgram gather_program(const GatherPlan& gather, const RenderSettings& settings, const BuildMasks& masks, int lanes)
{
    const LightTechnique& technique = *gather.technique;
    const bool segments = technique.reach == Reach::near_segments;
    // Nothing stands between and no boundary is crossed; at surfaces no medium is asked.
    const std::uint32_t never = feature_bit::occluders | feature_bit::boundaries | feature_bit::nonconvex_media, all = masks.media_to_media | masks.media_to_surface;
    return {.light = std::string(technique.name),
            .light_bytes = static_cast<std::uint32_t>(technique.record_bytes),
            .light_is_line = technique.is_line,
            .eyes = segments ? EyeKind::segments : EyeKind::points,
            .features = segments ? all & ~never : all & feature_bit::depth_limit,
            .lanes = lanes,
            .precision = settings.precision == Precision::f64 ? 64 : 32,
            .fast_math = settings.math == KernelMath::fast,
            .gathers = true};
}

std::uint32_t case_families(const LayerPlan& plan, const RenderSettings& settings, const BuildMasks& masks)
{
    constexpr std::uint32_t plain = 1, products = 2, marginals = 4, lobes = 8, grids = 16;
    std::uint32_t families = plain, built = 0;
    if (plan.media_to_media) {
        built |= masks.media_to_media;
        const int sampler = pair_program(plan, settings, EyeKind::segments, masks, 1).sampler;
        if (sampler != SAMPLER_PAPER_ISOTROPIC) families |= products;
        if (sampler >= SAMPLER_TABLE) families |= marginals;
    }
    if (plan.media_to_surface) built |= masks.media_to_surface;
    if (built & feature_bit::phase_lobes) families |= lobes;
    if (built & feature_bit::heterogeneous) families |= grids;
    return families;
}

}  // namespace tyndall
