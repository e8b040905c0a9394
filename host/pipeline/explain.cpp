#include "pipeline/explain.hpp"

#include <algorithm>

#include "kernels/shared/host_features.hpp"
#include "path_tracing/path_tracing.hpp"
#include "pipeline/build_masks.hpp"
#include "pipeline/check_settings.hpp"
#include "pipeline/memory_estimate.hpp"
#include "pipeline/savings.hpp"
#include "pipeline/scene_doubts.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

/// One line for every kernel; some serve all layers.
void add_kernels(const std::string& layer, const PairProgram& program, std::vector<KernelReport>& kernels)
{
    for (const KernelBuild& build : kernel_builds(program)) {
        const auto shared = std::find_if(kernels.begin(), kernels.end(), [&](const KernelReport& k) { return build.serves_all() && k.kernel == build.name; });
        if (shared != kernels.end()) shared->layer = "all layers";
        else kernels.push_back({layer, build.name, feature_names(build.features), build.options});
    }
}

/// Counts of one pass, with one eye segment and one eye point per pixel.
PairCounts expected_pairs(const Explanation& e, const RenderSettings& settings, std::uint32_t lights)
{
    const double pixels = double(e.width) * e.height, pairs = pixels * lights * settings.samples_per_pair;
    return {.to_segments = pairs, .to_points = pairs, .pixels = pixels, .lights_per_pass = double(lights)};
}

void add_warnings(const Scene& scene, const RenderSettings& settings, const LayerPlan& plan, Explanation& e)
{
    e.warnings = scene.warnings;
    const auto add = [&](const std::vector<std::string>& more) { e.warnings.insert(e.warnings.end(), more.begin(), more.end()); };
    if (plan.paths_seek_lights()) add(uncarried_light(scene));
    if (const auto doubt = doubt_about_math(settings); !doubt.empty()) add({doubt});
    add(doubts_about(scene, settings, Visibility(scene, settings.threads)));
}

}  // namespace

std::vector<EffectReport> effect_reports(const SceneFeatures& features)
{
    std::vector<EffectReport> reports;
    for (const Effect& effect : features.effects)
        reports.push_back({std::string(effect.row.name), effect.found, effect.where.line > 0 ? to_string(effect.where) + ": " + effect.cause : effect.cause});
    return reports;
}

Explanation explain(const Scene& scene, const RenderSettings& settings)
{
    check_settings(settings);
    const SceneFeatures features = features_for(scene, settings);
    const LayerPlan plan = plan_layers(scene, features, settings);
    const BuildMasks masks = build_masks(features, plan, settings.features);
    const SelectionPlan& selection = plan.selection;
    const std::uint32_t lights = selection.lights;
    Explanation e{.scene = scene.file, .method = std::string(name(settings.method))};
    e.width = scene.camera.crop_width, e.height = scene.camera.crop_height, e.passes = settings.passes, e.seconds = settings.seconds;
    e.lanes = plan.on_device() ? settings.lanes ? settings.lanes : 16 : 0, e.lights = plan.virtual_lights() ? lights : plan.gathers.empty() ? 0 : plan.gathers.front().lights;
    e.lanes_from = lanes_from(settings);
    e.effects = effect_reports(features), e.layers = plan.reports;
    for (const Layer layer : connected_layers(plan)) add_kernels(std::string(name(layer)), pair_program(plan, settings, layer, masks, e.lanes), e.kernels);
    for (const GatherPlan& gather : plan.gathers) add_kernels(std::string(gather.technique->title), gather_program(gather, settings, masks, e.lanes), e.kernels);
    if (plan.virtual_lights()) e.selection = to_text(selection);
    e.grids = grid_transmittance(settings, plan, masks);
    e.memory = estimate_memory(scene, settings, plan, masks);
    e.savings = savings_of(features, plan, masks, expected_pairs(e, settings, plan.technique ? selection.slots : 0));
    add_warnings(scene, settings, plan, e);
    return e;
}

}  // namespace tyndall
