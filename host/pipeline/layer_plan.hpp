#pragma once
/// Who carries which layer: the choice of techniques for a scene, and why layers are skipped.
#include <vector>

#include "lights/light_technique.hpp"
#include "pipeline/light_selection_plan.hpp"
#include "report/report.hpp"
#include "scene/scene_features.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

struct LayerPlan {
    const LightTechnique* technique = nullptr;              ///< of the virtual lights; null: path tracing
    double clamp = 0;                                       ///< bound of a connection's 1 / w^2 in render space; 0: none
    double radius = 0;                                      ///< of thick lights in the first pass, in render space
    bool media_to_media = false, media_to_surface = false;  ///< by virtual lights
    bool single = false;                                    ///< by equi-angular light sampling
    LayerSet path_traced;                                   ///< by the path tracer
    bool glossy_by_paths = false;                           ///< media_to_surface is in path_traced only where virtual lights do not connect: at glossy surfaces
    SelectionPlan selection;                                ///< how many virtual lights, and which of them eyes connect to
    int sampler = 0;                                        ///< of media_to_media: kernels/shared/samplers.h
    std::vector<LayerReport> reports;                       ///< one per layer, in order

    LayerSet rendered() const;
    bool virtual_lights() const { return media_to_media || media_to_surface; }
};

/// Of the scene with the settings' depth and length of lights.
SceneFeatures features_for(const Scene& scene, const RenderSettings& settings);

LayerPlan plan_layers(const Scene& scene, const SceneFeatures& features, const RenderSettings& settings);

}  // namespace tyndall
