#pragma once
/// Who carries which layer: the choice of techniques for a scene, and why layers are skipped.
#include <cstdint>
#include <vector>

#include "lights/light_technique.hpp"
#include "pipeline/light_selection_plan.hpp"
#include "report/report.hpp"
#include "scene/scene_features.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

/// Of connections where no other clamp is given: those shorter than a tenth of the scene's half diagonal are dimmed.
inline constexpr double usual_clamp = 100;

/// Layers by density estimation, with one kind of light.
struct GatherPlan {
    const LightTechnique* technique = nullptr;
    LayerSet layers;
    double radius = 0;         ///< in the first pass, in render space
    std::uint32_t lights = 0;  ///< per pass, aimed at, over all its layers
};

struct LayerPlan {
    const LightTechnique* technique = nullptr;              ///< of the virtual lights in media that eyes are connected to; null: there are none
    const LightTechnique* on_surfaces = nullptr;            ///< of those on surfaces
    double clamp = 0;                                       ///< bound of a connection's 1 / w^2 in render space; 0: none
    double radius = 0;                                      ///< of thick lights in the first pass, in render space
    bool media_to_media = false, media_to_surface = false;  ///< by virtual lights in media
    bool surface_to_media = false, surface_indirect = false;  ///< by virtual lights on surfaces
    bool single = false;                                    ///< by equi-angular light sampling
    LayerSet path_traced;                                   ///< by the path tracer
    LayerSet glossy_by_paths;                               ///< those are in path_traced only where other techniques know no lobes: where x1 is a glossy surface
    LayerSet glossy_lights_by_paths;                        ///< those (also) where x2 is one
    std::vector<GatherPlan> gathers;                        ///< by density estimation; each has a layer
    SelectionPlan selection;                                ///< how many virtual lights, and which of them eyes connect to
    int sampler = 0;                                        ///< of media_to_media: kernels/shared/samplers.h
    std::vector<LayerReport> reports;                       ///< one per layer, in order

    LayerSet rendered() const;
    bool lights_in_media() const { return media_to_media || media_to_surface; }
    bool lights_on_surfaces() const { return surface_to_media || surface_indirect; }
    bool virtual_lights() const { return lights_in_media() || lights_on_surfaces(); }
    /// Are eyes of that kind connected to virtual lights?
    bool connects_segments() const { return media_to_media || surface_to_media; }
    bool connects_points() const { return media_to_surface || surface_indirect; }
    bool on_device() const { return virtual_lights() || !gathers.empty(); }
    /// Do eyes of that kind take from lights that come near?
    bool gathers_at(Reach reach) const;
    /// Is some light, after scattering or mirrors, left to path tracing, whose paths do not find lights without size behind mirrors and glass?
    bool paths_seek_lights() const;
};

/// Of the scene with the settings' depth and length of lights.
SceneFeatures features_for(const Scene& scene, const RenderSettings& settings);

LayerPlan plan_layers(const Scene& scene, const SceneFeatures& features, const RenderSettings& settings);

}  // namespace tyndall
