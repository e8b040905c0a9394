#pragma once
/// Which features kernels are built with: the scene's own, or a mask that was asked for by hand.
#include <optional>
#include <string>

#include "device/pair_stage.hpp"
#include "pipeline/layer_plan.hpp"

namespace tyndall {

struct BuildMasks {
    std::uint32_t media_to_media = 0, media_to_surface = 0;
};

/// The scene's own masks, or `wanted` for both layers. A mask with more than the scene needs gives the same image within rounding and costs time; one that lacks
/// what a layer of the plan needs throws UsageError, which names the element that needs it.
BuildMasks build_masks(const SceneFeatures& features, const LayerPlan& plan, const std::optional<std::uint32_t>& wanted);

/// How transmittance through density grids is found, as a sentence for the report; empty if no kernel asks.
std::string grid_transmittance(const RenderSettings& settings, const LayerPlan& plan, const BuildMasks& masks);

/// What to know about kernels that are not strict, as a sentence for report and explain; empty if they are.
std::string doubt_about_math(const RenderSettings& settings);

/// The program for the connections of one kind of eye.
PairProgram pair_program(const LayerPlan& plan, const RenderSettings& settings, EyeKind kind, const BuildMasks& masks, int lanes);

/// The program for the lights of `gather` and the eyes that they come near.
PairProgram gather_program(const GatherPlan& gather, const RenderSettings& settings, const BuildMasks& masks, int lanes);

/// The families of golden cases (kernels/selftest/evaluate.h) whose mathematics the render's kernels hold.
std::uint32_t case_families(const LayerPlan& plan, const RenderSettings& settings, const BuildMasks& masks);

}  // namespace tyndall
