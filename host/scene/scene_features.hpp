#pragma once
/// What a scene calls for: which effects there are, and what connections between light and camera may meet. Pure functions of the scene.
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall {

/// The half-space dot(normal, x) <= offset; normal has unit length and points outwards.
struct HalfSpace {
    Vec3 normal;
    double offset;
};

/// A convex polyhedron filled with a medium, vacuum outside.
struct Container {
    int medium, shape;
    std::vector<HalfSpace> planes;
};

struct SceneFeatures {
    bool scattering_media = false;    ///< some medium scatters: without one no virtual light is traced
    bool absorbing_media = false;     ///< some medium has extinction
    bool receiving_surfaces = false;  ///< some surface reflects diffusely: without one there is nothing between media and surfaces
    bool specular_surfaces = false;   ///< mirrors or glass
    std::uint32_t media_to_media = 0, media_to_surface = 0;  ///< masks of kernels/shared/scene_features.h for the connections of the two layers
    std::vector<Container> containers;  ///< empty unless every null boundary is a convex polyhedron, disjoint from the others, in vacuum
    std::uint32_t mask() const { return media_to_media | media_to_surface; }
};

/// `short_lights` and `max_depth` are settings that switch features on.
SceneFeatures features_of(const Scene& scene, bool short_lights = false, int max_depth = -1);

}  // namespace tyndall
