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
    if (!wanted) return {features.media_to_media, features.media_to_surface, features.surface_to_media, features.surface_indirect};
    if ((*wanted & feature_bit::nonconvex_media) && !(*wanted & feature_bit::occluders))
        throw UsageError("--features: NONCONVEX_MEDIA needs OCCLUDERS, because the host's walk answers both questions; add it");
    if (plan.media_to_media) check_layer(features, Layer::media_to_media, *wanted);
    if (plan.media_to_surface) check_layer(features, Layer::media_to_surface, *wanted);
    return {*wanted, *wanted, *wanted | features.surface_to_media, *wanted | features.surface_indirect};  // what these need besides is theirs by rule
}

std::uint32_t BuildMasks::of(Layer layer) const
{
    switch (layer) {
        case Layer::media_to_media: return media_to_media;
        case Layer::media_to_surface: return media_to_surface;
        case Layer::surface_to_media: return surface_to_media;
        default: return surface_indirect;
    }
}

std::vector<Layer> connected_layers(const LayerPlan& plan)
{
    std::vector<Layer> layers;
    for (const auto& [wanted, layer] : {std::pair(plan.media_to_media, Layer::media_to_media), std::pair(plan.media_to_surface, Layer::media_to_surface),
                                        std::pair(plan.surface_to_media, Layer::surface_to_media), std::pair(plan.surface_indirect, Layer::surface_indirect)})
        if (wanted) layers.push_back(layer);
    return layers;
}

const LightTechnique& lights_of(const LayerPlan& plan, Layer layer) { return layer == Layer::surface_to_media || layer == Layer::surface_indirect ? *plan.on_surfaces : *plan.technique; }

EyeKind eyes_of(Layer layer) { return layer == Layer::media_to_media || layer == Layer::surface_to_media ? EyeKind::segments : EyeKind::points; }

std::string grid_transmittance(const RenderSettings& settings, const LayerPlan& plan, const BuildMasks& masks)
{
    std::uint32_t built = 0;
    for (const Layer layer : connected_layers(plan)) built |= masks.of(layer);
    if (!(built & feature_bit::heterogeneous)) return {};
    if (settings.transmittance == GridTransmittance::exact) return "exact: cell by cell for every pair; unbiased";
    return "march: tables and a jittered march, with an exact correction for one pair in 64; unbiased, and a pass can hold negative values";
}

std::string doubt_about_math(const RenderSettings& settings)
{
    if (settings.math == KernelMath::strict) return {};
    return "--math fast: compilers may reorder and approximate what was proved to be stable, and the selftest does not cover it; compare the image with one of --math strict";
}

PairProgram pair_program(const LayerPlan& plan, const RenderSettings& settings, Layer layer, const BuildMasks& masks, int lanes)
{
    const EyeKind kind = eyes_of(layer);
    const std::uint32_t features = masks.of(layer);
    int sampler = kind == EyeKind::segments ? plan.sampler : SAMPLER_PAPER_ISOTROPIC;  // points are the same program for every sampler
    if (sampler == SAMPLER_PAPER && !(features & feature_bit::anisotropic)) sampler = SAMPLER_PAPER_ISOTROPIC;    // and so are these two
    const LightTechnique& technique = lights_of(plan, layer);
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
    for (const Layer layer : connected_layers(plan)) {
        built |= masks.of(layer);
        const int sampler = pair_program(plan, settings, layer, masks, 1).sampler;
        if (sampler != SAMPLER_PAPER_ISOTROPIC) families |= products;
        if (sampler >= SAMPLER_TABLE) families |= marginals;
    }
    if (built & feature_bit::phase_lobes) families |= lobes;
    if (built & feature_bit::heterogeneous) families |= grids;
    return families;
}

}  // namespace tyndall
