#pragma once
/// Who carries which layer: the choice of techniques for a scene, and why layers are skipped.
#include <vector>

#include "report/report.hpp"
#include "scene/scene_features.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

struct LayerPlan {
    bool media_to_media = false, media_to_surface = false;  ///< by virtual lights
    bool single = false;                                    ///< by equi-angular light sampling
    LayerSet path_traced;                                   ///< by the path tracer
    int sampler = 0;                                        ///< of media_to_media: kernels/shared/samplers.h
    std::vector<LayerReport> reports;                       ///< one per layer, in order

    LayerSet rendered() const;
    bool virtual_lights() const { return media_to_media || media_to_surface; }
};

LayerPlan plan_layers(const Scene& scene, const SceneFeatures& features, const RenderSettings& settings);

}  // namespace tyndall
