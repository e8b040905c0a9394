#pragma once
/// Which features kernels are built with: the scene's own, or a mask that was asked for by hand.
#include <optional>
#include <string>

#include "device/pair_stage.hpp"
#include "pipeline/layer_plan.hpp"

namespace tyndall {

struct BuildMasks {
    std::uint32_t media_to_media = 0, media_to_surface = 0, surface_to_media = 0, surface_indirect = 0;
    /// Of a layer that virtual lights carry.
    std::uint32_t of(Layer layer) const;
};

/// The scene's own masks, or `wanted` for all layers. A mask with more than the scene needs gives the same image within rounding and costs time; one that lacks
/// what a layer of the plan needs throws UsageError, which names the element that needs it.
BuildMasks build_masks(const SceneFeatures& features, const LayerPlan& plan, const std::optional<std::uint32_t>& wanted);

/// How transmittance through density grids is found, as a sentence for the report; empty if no kernel asks.
std::string grid_transmittance(const RenderSettings& settings, const LayerPlan& plan, const BuildMasks& masks);

/// What to know about kernels that are not strict, as a sentence for report and explain; empty if they are.
std::string doubt_about_math(const RenderSettings& settings);

/// The program for the connections of a layer.
PairProgram pair_program(const LayerPlan& plan, const RenderSettings& settings, Layer layer, const BuildMasks& masks, int lanes);

/// The layers that eyes are connected to virtual lights for, in the order of their rendering.
std::vector<Layer> connected_layers(const LayerPlan& plan);

/// The lights that the layer's eyes are connected to.
const LightTechnique& lights_of(const LayerPlan& plan, Layer layer);

/// What is connected in a layer that virtual lights carry.
EyeKind eyes_of(Layer layer);

/// The program for the lights of `gather` and the eyes that they come near.
PairProgram gather_program(const GatherPlan& gather, const RenderSettings& settings, const BuildMasks& masks, int lanes);

/// The families of golden cases (kernels/selftest/evaluate.h) whose mathematics the render's kernels hold.
std::uint32_t case_families(const LayerPlan& plan, const RenderSettings& settings, const BuildMasks& masks);

}  // namespace tyndall
