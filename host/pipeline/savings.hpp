#pragma once
/// What is not done because a scene does not need it, and what it would have cost.
#include <vector>

#include "pipeline/build_masks.hpp"

namespace tyndall {

/// How much work there is, or was.
struct PairCounts {
    double to_segments = 0, to_points = 0;  ///< pairs of a light and an eye that are connected
    double pixels = 0;                      ///< camera samples
    double lights_per_pass = 0;             ///< of a layer that is skipped: the pairs that it would have had are pixels x lights
};

/// One line for every feature that kernels are built without, and for a layer of virtual lights that the scene lacks. Processor seconds are predicted from the counts and the
/// nominal costs of host/docs/features.md; they are rough, and said to be predictions wherever they are shown.
std::vector<SavingReport> savings_of(const SceneFeatures& features, const LayerPlan& plan, const BuildMasks& masks, const PairCounts& counts);

/// Processor seconds that a pair costs more where kernels are built with the feature, on the machine of host/docs/features.md; negative where it is too little to
/// measure or depends on the scene.
double nominal_pair_seconds(std::uint32_t feature);

/// Processor seconds of a pair that needs no feature, on the same machine.
inline constexpr double nominal_plain_pair_seconds = 9.7e-9;

}  // namespace tyndall
