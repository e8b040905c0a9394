#include "pipeline/savings.hpp"

#include "kernels/shared/host_features.hpp"

namespace tyndall {
namespace {

/// Titles of the gathered lights whose kernels read media and lack the feature; what they never have is no saving of the scene's.
std::string gathered_without(std::uint32_t bit, const LayerPlan& plan, const BuildMasks& masks)
{
    constexpr std::uint32_t never = feature_bit::occluders | feature_bit::boundaries | feature_bit::nonconvex_media;
    std::string titles;
    for (const GatherPlan& gather : plan.gathers)
        if (gather.technique->reach == Reach::near_segments && !((never | masks.media_to_media | masks.media_to_surface) & bit)) titles += (titles.empty() ? "" : " and ") + std::string(gather.technique->title);
    return titles;
}

/// Features that the masks of the layers that run do not have, as seconds over the pairs of those layers.
SavingReport saving_of(const Effect& effect, const LayerPlan& plan, const BuildMasks& masks, const PairCounts& counts)
{
    const std::uint32_t bit = effect.row.bit;
    double pairs = 0;
    std::string layers;
    const auto add = [&](const std::string& what) { layers += (layers.empty() || what.empty() ? "" : " and ") + what; };
    for (const Layer layer : connected_layers(plan))
        if (!(masks.of(layer) & bit)) pairs += eyes_of(layer) == EyeKind::segments ? counts.to_segments : counts.to_points, add(std::string(name(layer)));
    add(gathered_without(bit, plan, masks));
    if (layers.empty()) return {};
    const double cost = nominal_pair_seconds(bit);
    return {std::string(effect.row.saving), layers + " without " + std::string(effect.row.name), cost < 0 || pairs == 0 ? -1 : cost * pairs};
}

void add_skipped_layers(const LayerPlan& plan, const PairCounts& counts, std::vector<SavingReport>& savings)
{
    for (const LayerReport& layer : plan.reports) {
        if (!layer.skipped || layer.why == "turned off") continue;
        const bool connected = layer.layer == name(Layer::media_to_media) || layer.layer == name(Layer::media_to_surface) ||
                               (plan.on_surfaces && (layer.layer == name(Layer::surface_to_media) || layer.layer == name(Layer::surface_indirect)));
        const double pairs = counts.pixels * counts.lights_per_pass;
        if (connected && pairs > 0) savings.push_back({"layer " + layer.layer, layer.why, pairs * nominal_plain_pair_seconds});  // the others stand among the layers
    }
}

}  // namespace

double nominal_pair_seconds(std::uint32_t feature)
{
    switch (feature) {
        case feature_bit::anisotropic: return .3e-9;
        case feature_bit::coloured: return .9e-9;
        case feature_bit::occluders: return 10e-9;
        case feature_bit::nonconvex_media: return 156e-9;
        case feature_bit::heterogeneous:
        case feature_bit::coloured_grids: return 46e-9;
        default: return -1;
    }
}

std::vector<SavingReport> savings_of(const SceneFeatures& features, const LayerPlan& plan, const BuildMasks& masks, const PairCounts& counts)
{
    std::vector<SavingReport> savings;
    if (plan.on_device())
        for (const Effect& effect : features.effects) {
            if (effect.row.bit == 0) continue;
            SavingReport saving = saving_of(effect, plan, masks, counts);
            if (!saving.what.empty()) savings.push_back(std::move(saving));
        }
    for (const GatherPlan& gather : plan.gathers)
        savings.push_back({"shadow segments and clipping at boundaries of media", std::string(gather.technique->title) + ": eyes take from light paths that come near, so nothing lies between", -1});
    add_skipped_layers(plan, counts, savings);
    return savings;
}

}  // namespace tyndall
