#pragma once
/// Which sampler of kernels/shared/samplers.h a render uses.
#include <string>

#include "scene/scene.hpp"
#include "scene/scene_features.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

struct ChosenSampler {
    int sampler;       ///< of kernels/shared/samplers.h
    std::string why;
};

/// The settings' own, or by rule: the product of phase functions where a medium scatters so unevenly that it wins at equal time, which it does sooner where connections
/// ask shadow segments (host/docs/performance.md). The scene's own features decide, not the mask that kernels are built with.
ChosenSampler choose_sampler(const Scene& scene, const SceneFeatures& features, Sampler wanted);

/// As --sampler calls it.
std::string sampler_name(int sampler);

/// The settings' own, or by rule: scrambled Sobol points where a pair has more than one sample.
int choose_sequence(Sequence wanted, int samples_per_pair);

}  // namespace tyndall
