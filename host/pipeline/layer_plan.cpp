#include "pipeline/layer_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "path_tracing/path_tracing.hpp"
#include "pipeline/choose_sampler.hpp"
#include "scene/thin_media.hpp"

namespace tyndall {
namespace {

/// Is it a sub-layer of light that mirrors or glass lead from x2 to x1?
bool goes_over_mirrors(Layer layer) { return static_cast<std::size_t>(layer) > static_cast<std::size_t>(Layer::media_to_surface); }

/// What a layer needs that the scene does not have; empty if it can contribute.
std::string missing_for(Layer layer, const Scene& scene, const SceneFeatures& features)
{
    if (scene.emitters.empty()) return "the scene has no light";
    if (goes_over_mirrors(layer)) {
        if (!features.specular_surfaces) return "the scene has no mirror or glass";
        return missing_for(static_cast<Layer>(static_cast<std::size_t>(layer) - 6), scene, features);
    }
    const bool needs_media = layer == Layer::single || layer == Layer::surface_to_media || layer == Layer::media_to_media || layer == Layer::media_to_surface;
    const bool needs_surfaces = layer == Layer::surface_direct || layer == Layer::surface_indirect || layer == Layer::media_to_surface;
    if (needs_media && !features.scattering_media) return "no medium of the scene scatters";
    if (needs_surfaces && !features.receiving_surfaces) return "no surface of the scene scatters light";
    if (layer == Layer::surface_to_media && !features.receiving_surfaces && !features.specular_surfaces) return "no surface of the scene reflects";
    return {};
}

/// Leaves media_to_media out of a scene whose media are thin enough for the setting.
void skip_if_thin(const Scene& scene, double allowed, LayerReport& report)
{
    const ScatteredAgain again = scattered_again(scene);
    if (again.share > allowed) return;
    report.why = fmt::format("optically thin: at most {:.2g} % of the light that media scatter is scattered by them again (allowed: {:g} %)", 100 * again.share, 100 * allowed);
    report.unbiased = false, report.left_out = again.share;
}

/// How a layer is rendered, and why so.
struct Carrier { std::string name, why; };

/// The technique that gathers the layer; null if none does.
const LightTechnique* gatherer_of(Layer layer, const Recipe& recipe)
{
    const LightTechnique* lights = lights_for(layer, recipe);
    return lights && lights->gathered() ? lights : nullptr;
}

/// The technique whose lights on surfaces carry the layer; null if none does.
const LightTechnique* surface_lights_of(Layer layer, const Recipe& recipe)
{
    const LightTechnique* lights = lights_for(layer, recipe);
    return lights && lights->on_surfaces ? lights : nullptr;
}

/// "photon beams and photons".
std::string titles_of(const Recipe& recipe)
{
    std::string titles = recipe.connected ? std::string(recipe.connected->title) : "";
    for (const Gathered& g : recipe.gathered) titles += (titles.empty() ? "" : " and ") + std::string(g.technique->title);
    return titles;
}

Carrier carrier_of(Layer layer, const Recipe& recipe)
{
    if (const LightTechnique* gathered = gatherer_of(layer, recipe))
        return {std::string(gathered->title), gathered->reach == Reach::near_points ? "light paths that arrive near: density estimation" : "light paths that pass near: density estimation"};
    if (const LightTechnique* lights = surface_lights_of(layer, recipe)) return {std::string(lights->title), "light that surfaces have reflected diffusely, on straight lines"};
    const std::string title = titles_of(recipe);
    if (title.empty()) return {"path tracing", "--method path"};
    switch (layer) {
        case Layer::emitted: return {"camera ray", "the camera's own path meets the light"};
        case Layer::surface_direct: return {"next-event estimation", "straight lines from surfaces to lights"};
        case Layer::surface_indirect: return {"path tracing", title + " lie in media only"};
        case Layer::single: return {"equi-angular light sampling", "straight lines from media to lights"};
        case Layer::surface_to_media: return {"path tracing", title + (recipe.connected ? " carry light that a medium has scattered" : " do not carry it")};
        case Layer::media_to_media:
        case Layer::media_to_surface:
            if (!recipe.connected) return {"path tracing", title + " do not carry it"};
            return {std::string(recipe.connected->title), "light that a medium has scattered, on straight lines"};
        default: return {"path tracing", recipe.connected ? "connections by straight lines do not pass mirrors and glass" : title + " do not carry it"};
    }
}

/// Lights on surfaces stand on diffuse ones, and connect to those: paths carry the light that has a glossy surface at either end.
void share_glossy_ends(Layer layer, const SceneFeatures& features, LayerPlan& plan)
{
    if (!features.glossy_surfaces) return;
    plan.path_traced.add(layer), plan.glossy_lights_by_paths.add(layer);
    if (layer == Layer::surface_indirect) plan.glossy_by_paths.add(layer);
    LayerReport& report = plan.reports.back();
    report.why = report.technique + " from diffuse surfaces" + (layer == Layer::surface_indirect ? " to diffuse surfaces" : "") + "; paths where plastic, rough metal or rough glass reflects, which have no lights";
    report.technique += ", path tracing";
}

constexpr const char* where_no_lobes_are_known = "plastic, rough metal and rough glass, where the kernels know no lobes";

/// Lights of the kernels carry it to diffuse surfaces, paths to all others.
void share_with_paths(Layer layer, const SceneFeatures& features, bool diffuse, LayerPlan& plan)
{
    if (!features.glossy_surfaces) return;
    plan.path_traced.add(layer), plan.glossy_by_paths.add(layer);
    LayerReport& report = plan.reports.back();
    const std::string lights = report.technique;
    report.technique = diffuse ? lights + ", path tracing" : "path tracing";
    report.why = diffuse ? lights + " to diffuse surfaces; paths to " + where_no_lobes_are_known : std::string("the surfaces are ") + where_no_lobes_are_known;
}

std::string radius_text(std::string_view lights, double radius, int dimensions)
{
    return fmt::format("{} have a radius of {:.3g} of the scene's half diagonal in the first pass, which falls as the {} root of the pass", lights, radius, dimensions == 1 ? "cube" : "sixth");
}

/// What makes the connected lights biased, in words, and its numbers in the plan.
std::string plan_bias(const Scene& scene, const RenderSettings& settings, const Recipe& recipe, LayerPlan& plan)
{
    if (!recipe.connected) return {};
    const double size = bounds_of(scene).radius();
    if (recipe.clamped) {
        const double clamp = settings.clamp.value_or(usual_clamp);
        plan.clamp = size > 0 ? clamp / (size * size) : clamp;
        return fmt::format("1/w^2 of a connection is at most {:g} over the square of the scene's half diagonal: light over less than {:.3g} of it is dimmed", clamp, 1 / std::sqrt(clamp));
    }
    if (!plan.technique->is_thick) return {};
    const double radius = settings.beam_radius.value_or(plan.technique->usual_radius);
    plan.radius = size > 0 ? radius * size : radius;
    return radius_text("beams", radius, 1);
}

/// Beside a method of connected lights density estimation is the dear part of a pass: it gets this share of its usual number of lights, and more passes.
constexpr std::uint32_t beside_connected = 16;

/// Density estimation of a layer: its lights are those of the other layers of the technique. usual_lights: where the settings say nothing.
void plan_gathered(Layer layer, const LightTechnique& technique, std::uint32_t usual_lights, const Scene& scene, const RenderSettings& settings, LayerPlan& plan)
{
    const double share = settings.beam_radius.value_or(technique.usual_radius), size = bounds_of(scene).radius();
    auto found = std::find_if(plan.gathers.begin(), plan.gathers.end(), [&](const GatherPlan& g) { return g.technique == &technique; });
    if (found == plan.gathers.end()) found = plan.gathers.insert(found, {&technique, {}, size > 0 ? share * size : share, settings.lights ? settings.lights : usual_lights});
    found->layers.add(layer);
    plan.reports.back().unbiased = false, plan.reports.back().bias = radius_text(technique.title, share, technique.blur_dimensions);
}

/// Who renders the layers: by and large the method.
struct Recipes {
    Recipe method, paths, over_mirrors;
    bool lights_without_size = false;  ///< some, in a scene with mirrors or glass

    /// Methods of connected lights leave light over mirrors and glass to paths, which do not find lights without size there: then beams and photons carry it, as in the talk.
    bool lost_to_paths(Layer layer) const { return lights_without_size && method.connected && method.gathered.empty() && goes_over_mirrors(layer); }

    const Recipe& of(Layer layer, bool asked_for_paths) const { return asked_for_paths ? paths : lost_to_paths(layer) ? over_mirrors : method; }
};

/// How places are drawn in a layer of virtual lights.
void name_sampler(Layer layer, const LightTechnique& lights, const ChosenSampler& chosen, LayerReport& report)
{
    if (layer == Layer::media_to_surface || layer == Layer::surface_indirect) report.sampler = lights.surface_sampler, report.sampler_why = lights.surface_sampler_why;
    if (layer != Layer::media_to_media && layer != Layer::surface_to_media) return;
    report.sampler = sampler_name(chosen.sampler), report.sampler_why = chosen.why;
}

}  // namespace

LayerSet LayerPlan::rendered() const
{
    LayerSet set = path_traced;
    if (media_to_media) set.add(Layer::media_to_media);
    if (media_to_surface) set.add(Layer::media_to_surface);
    if (surface_to_media) set.add(Layer::surface_to_media);
    if (surface_indirect) set.add(Layer::surface_indirect);
    if (single) set.add(Layer::single);
    for (const GatherPlan& gather : gathers) set = set | gather.layers;
    return set;
}

bool LayerPlan::gathers_at(Reach reach) const
{
    return std::any_of(gathers.begin(), gathers.end(), [&](const GatherPlan& g) { return g.technique->reach == reach; });
}

bool LayerPlan::paths_seek_lights() const { return !path_traced.without(LayerSet().add(Layer::emitted).add(Layer::surface_direct)).empty(); }

SceneFeatures features_for(const Scene& scene, const RenderSettings& settings)
{
    const Recipe recipe = recipe_of(settings.method);
    const bool gathered_lines = std::any_of(recipe.gathered.begin(), recipe.gathered.end(), [](const Gathered& g) { return g.technique->is_line; });
    return features_of(scene, ((recipe.connected && recipe.connected->is_line) || gathered_lines) && settings.segment_length == SegmentLength::short_, settings.max_depth.value_or(scene.max_depth));
}

/// Who renders a layer that the scene has.
static void plan_layer(Layer layer, const Recipe& recipe, const Scene& scene, const SceneFeatures& features, const RenderSettings& settings, LayerPlan& plan)
{
    if (const LightTechnique* gathered = gatherer_of(layer, recipe)) {
        const bool beside = recipe_of(settings.method).gathered.empty();
        plan_gathered(layer, *gathered, gathered->usual_lights / (beside ? beside_connected : 1), scene, settings, plan);
        if (gathered->reach == Reach::near_points) share_with_paths(layer, features, true, plan);
    } else if (surface_lights_of(layer, recipe)) {
        (layer == Layer::surface_to_media ? plan.surface_to_media : plan.surface_indirect) = true;
        share_glossy_ends(layer, features, plan);
    } else if (recipe.connected && layer == Layer::media_to_media) {
        plan.media_to_media = true;
    } else if (recipe.connected && layer == Layer::media_to_surface) {
        plan.media_to_surface = features.surfaces_in_reach;
        share_with_paths(layer, features, features.surfaces_in_reach, plan);
    } else if (layer == Layer::single && !titles_of(recipe).empty()) {
        plan.single = true;
    } else {
        plan.path_traced.add(layer);
    }
}

LayerPlan plan_layers(const Scene& scene, const SceneFeatures& features, const RenderSettings& settings)
{
    const ChosenSampler chosen = choose_sampler(scene, features, settings.sampler);
    const Recipes recipes{recipe_of(settings.method), recipe_of(Method::path), recipe_of(Method("talk")), !uncarried_light(scene).empty()};
    const Recipe& recipe = recipes.method;
    LayerPlan plan{.technique = recipe.connected, .on_surfaces = recipe.on_surfaces, .selection = plan_selection(settings, scene.camera), .sampler = chosen.sampler};
    const std::string bias = plan_bias(scene, settings, recipe, plan);
    for (std::size_t l = 0; l < layer_count; ++l) {
        const Layer layer = static_cast<Layer>(l);
        const bool asked_for_paths = settings.path_layers.contains(layer);
        const Recipe& used = recipes.of(layer, asked_for_paths);
        Carrier carrier = carrier_of(layer, used);
        if (!asked_for_paths && recipes.lost_to_paths(layer)) carrier.why += ", because paths do not find lights without size over mirrors and glass";
        if (asked_for_paths && settings.method != Method::path) carrier.why = fmt::format("--layer {}=path", name(layer));
        LayerReport report{.layer = std::string(name(layer)), .technique = carrier.name};
        report.why = settings.layers.contains(layer) ? missing_for(layer, scene, features) : "turned off";
        if (report.why.empty() && layer == Layer::media_to_surface && !features.surfaces_in_reach && !features.glossy_surfaces)  // by straight lines; the sub-layer's go round by mirrors
            report.why = "no surface that reflects diffusely faces a medium that scatters";
        if (report.why.empty() && layer == Layer::media_to_media && settings.skip_thin > 0) skip_if_thin(scene, settings.skip_thin, report);
        report.skipped = !report.why.empty();
        if (report.skipped) report.technique = "skipped";
        else report.why = carrier.why;
        plan.reports.push_back(report);
        if (report.skipped) continue;
        const LightTechnique* lights = lights_for(layer, used);
        const bool connected = lights && !lights->gathered() && (layer != Layer::media_to_surface || features.surfaces_in_reach);
        if (connected) name_sampler(layer, *lights, chosen, plan.reports.back());
        if (connected) plan.reports.back().unbiased = bias.empty(), plan.reports.back().bias = bias;
        plan_layer(layer, used, scene, features, settings, plan);
    }
    return plan;
}

}  // namespace tyndall
