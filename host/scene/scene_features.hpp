#pragma once
/// What a scene calls for: which effects there are and which element causes each, and what connections between light and camera may meet.
/// Pure functions of the scene.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/containers.hpp"
#include "scene/scene.hpp"
#include "tyndall/layer.hpp"

namespace tyndall {

/// One line of the list of everything that a scene may call for.
struct EffectRow {
    std::string_view name;
    std::uint32_t bit;         ///< of kernels/shared/scene_features.h; 0: a fact of the scene that decides what runs, not how kernels are built
    std::string_view meaning;
    std::string_view saving;   ///< what is not done where the scene does not have it
};

/// The features of kernels/shared/scene_features.h and the facts of the scene, in the order of every report, table and document.
std::vector<EffectRow> effect_list();

/// What the scene says about one line of the list.
struct Effect {
    EffectRow row;
    bool found = false;
    std::string cause;     ///< a sentence, if found
    SourceLocation where;  ///< of the element that causes it; line 0: no element, but a setting
};

/// Why a layer's kernels need a feature.
struct FeatureCause {
    std::uint32_t bit;     ///< one bit
    Layer layer;           ///< media_to_media or media_to_surface
    std::string cause;
    SourceLocation where;
};

struct SceneFeatures {
    bool scattering_media = false;    ///< some medium scatters: without one no virtual light is traced
    bool absorbing_media = false;     ///< some medium has extinction
    bool surfaces_in_reach = false;   ///< some diffuse surface may be lit by a medium: without one virtual lights carry no media_to_surface
    bool receiving_surfaces = false;  ///< some surface scatters light over directions: without one there is nothing between media and surfaces
    bool glossy_surfaces = false;     ///< some surface scatters, but not the same in all directions of one side: virtual lights do not connect to it
    bool specular_surfaces = false;   ///< mirrors or glass
    std::uint32_t media_to_media = 0, media_to_surface = 0;  ///< masks of kernels/shared/scene_features.h for the connections of the two layers
    /// The same for lights on surfaces. What they need besides is a rule: something may always stand between them and an eye, and they may stand outside of every medium.
    std::uint32_t surface_to_media = 0, surface_indirect = 0;
    std::vector<Container> containers;  ///< empty unless every null boundary is a convex polyhedron, disjoint from the others, in vacuum
    std::vector<Effect> effects;        ///< one for every line of effect_list()
    std::vector<FeatureCause> causes;   ///< one for every bit of the two masks
    std::uint32_t mask() const { return media_to_media | media_to_surface; }
};

/// `short_lights` and `max_depth` are settings that switch features on.
SceneFeatures features_of(const Scene& scene, bool short_lights = false, int max_depth = -1);

/// "ANISOTROPIC COLOURED", or "none".
std::string feature_names(std::uint32_t mask);

}  // namespace tyndall
