#pragma once
/// What a render would simulate, what not, and why; and how long it would take.
#include "report/explanation.hpp"
#include "scene/scene_features.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

/// Everything that follows from scene and settings without a device or a clock; settings.lanes 0 stands for 16. Throws UsageError.
Explanation explain(const Scene& scene, const RenderSettings& settings);

/// Renders passes at these settings until `seconds` are spent, but at least three, and predicts from them: seconds per pass as the mean of the passes after
/// the first, the time to an error from the variance, which falls with 1 / passes. If one pass would take more than a quarter of `seconds` (told by a film of
/// 1/64 of the pixels), the film is shrunk, and all stages but the tracing of lights are scaled back by the number of pixels. Throws what `render` throws.
Calibration calibrate(const Scene& scene, const RenderSettings& settings, double seconds);

/// One line for every effect, with "file:line:column: sentence" for those that were found.
std::vector<EffectReport> effect_reports(const SceneFeatures& features);

}  // namespace tyndall
