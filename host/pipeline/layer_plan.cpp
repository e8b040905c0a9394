#include "pipeline/layer_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pipeline/choose_sampler.hpp"
#include "scene/thin_media.hpp"

namespace tyndall {
namespace {

/// What a layer needs that the scene does not have; empty if it can contribute.
std::string missing_for(Layer layer, const Scene& scene, const SceneFeatures& features)
{
    if (scene.emitters.empty()) return "the scene has no light";
    const bool sub_layer = static_cast<std::size_t>(layer) > static_cast<std::size_t>(Layer::media_to_surface);
    if (sub_layer) {
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

Carrier carrier_of(Layer layer, const LightTechnique* lights)
{
    if (!lights) return {"path tracing", "--method path"};
    const std::string title(lights->title);
    switch (layer) {
        case Layer::emitted: return {"camera ray", "the camera's own path meets the light"};
        case Layer::surface_direct: return {"next-event estimation", "straight lines from surfaces to lights"};
        case Layer::surface_indirect: return {"path tracing", title + " lie in media only"};
        case Layer::single: return {"equi-angular light sampling", "straight lines from media to lights"};
        case Layer::surface_to_media: return {"path tracing", title + " carry light that a medium has scattered"};
        case Layer::media_to_media:
        case Layer::media_to_surface: return {title, "light that a medium has scattered, on straight lines"};
        default: return {"path tracing", "connections by straight lines do not pass mirrors and glass"};
    }
}

/// Virtual lights carry media_to_surface to diffuse surfaces, paths to all others.
void plan_media_to_surface(const SceneFeatures& features, LayerPlan& plan)
{
    plan.media_to_surface = features.surfaces_in_reach, plan.glossy_by_paths = features.glossy_surfaces;
    if (!features.glossy_surfaces) return;
    plan.path_traced.add(Layer::media_to_surface);
    LayerReport& report = plan.reports.back();
    const std::string lights(plan.technique->title);
    report.technique = plan.media_to_surface ? lights + ", path tracing" : "path tracing";
    report.why = plan.media_to_surface ? lights + " to diffuse surfaces; paths to plastic, rough metal and rough glass, where the kernels know no lobes"
                                       : "the surfaces are plastic, rough metal or rough glass, where the kernels know no lobes";
}

constexpr double usual_clamp = 100, usual_radius = .05;  ///< connections shorter than a tenth, beams of a twentieth of the scene's half diagonal

/// What makes the lights biased, in words, and its numbers in the plan.
std::string plan_bias(const Scene& scene, const RenderSettings& settings, LayerPlan& plan)
{
    if (!plan.technique) return {};
    const double size = bounds_of(scene).radius();
    if (is_clamped(settings.method)) {
        const double clamp = settings.clamp.value_or(usual_clamp);
        plan.clamp = size > 0 ? clamp / (size * size) : clamp;
        return fmt::format("1/w^2 of a connection is at most {:g} over the square of the scene's half diagonal: light over less than {:.3g} of it is dimmed", clamp, 1 / std::sqrt(clamp));
    }
    if (!plan.technique->is_thick) return {};
    const double radius = settings.beam_radius.value_or(usual_radius);
    plan.radius = size > 0 ? radius * size : radius;
    return fmt::format("beams have a radius of {:.3g} of the scene's half diagonal in the first pass, which falls as the cube root of the pass", radius);
}

/// How places are drawn in a layer of virtual lights.
void name_sampler(Layer layer, const LightTechnique& lights, const ChosenSampler& chosen, LayerReport& report)
{
    if (layer == Layer::media_to_surface) report.sampler = lights.surface_sampler, report.sampler_why = lights.surface_sampler_why;
    if (layer != Layer::media_to_media) return;
    report.sampler = sampler_name(chosen.sampler), report.sampler_why = chosen.why;
}

}  // namespace

LayerSet LayerPlan::rendered() const
{
    LayerSet set = path_traced;
    if (media_to_media) set.add(Layer::media_to_media);
    if (media_to_surface) set.add(Layer::media_to_surface);
    if (single) set.add(Layer::single);
    return set;
}

SceneFeatures features_for(const Scene& scene, const RenderSettings& settings)
{
    const LightTechnique* lights = technique_of(settings.method);
    return features_of(scene, lights && lights->is_line && settings.segment_length == SegmentLength::short_, settings.max_depth.value_or(scene.max_depth));
}

LayerPlan plan_layers(const Scene& scene, const SceneFeatures& features, const RenderSettings& settings)
{
    const ChosenSampler chosen = choose_sampler(scene, features, settings.sampler);
    LayerPlan plan{.technique = technique_of(settings.method), .selection = plan_selection(settings, scene.camera), .sampler = chosen.sampler};
    const std::string bias = plan_bias(scene, settings, plan);
    for (std::size_t l = 0; l < layer_count; ++l) {
        const Layer layer = static_cast<Layer>(l);
        const LightTechnique* lights = settings.path_layers.contains(layer) ? nullptr : plan.technique;
        Carrier carrier = carrier_of(layer, lights);
        if (lights != plan.technique) carrier.why = fmt::format("--layer {}=path", name(layer));
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
        if (lights && (layer != Layer::media_to_surface || features.surfaces_in_reach)) name_sampler(layer, *lights, chosen, plan.reports.back());
        if (lights && (layer == Layer::media_to_media || (layer == Layer::media_to_surface && features.surfaces_in_reach)))
            plan.reports.back().unbiased = bias.empty(), plan.reports.back().bias = bias;
        if (lights && layer == Layer::media_to_media) plan.media_to_media = true;
        else if (lights && layer == Layer::media_to_surface) plan_media_to_surface(features, plan);
        else if (lights && layer == Layer::single) plan.single = true;
        else plan.path_traced.add(layer);
    }
    return plan;
}

}  // namespace tyndall
