#pragma once
/// Facts of a scene that decide which layers and passes run; kernels do not ask for them. Together with kernels/shared/scene_features.h this is the list
/// of everything that a scene may call for.
#include <optional>
#include <string>

#include "scene/scene_features.hpp"

namespace tyndall {

/// The first element that makes a statement true, and how.
struct Cause {
    std::string sentence;
    SourceLocation where;
};

/// A line of the list and the question whether a scene has it.
struct SceneFact {
    EffectRow row;
    std::optional<Cause> (*cause_of)(const Scene& scene);
};

const std::vector<SceneFact>& scene_facts();

}  // namespace tyndall
