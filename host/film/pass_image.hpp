#pragma once
/// What one pass adds to the film: radiance per pixel and layer, for the layers that were rendered.
#include <array>
#include <vector>

#include "scene/vector.hpp"
#include "tyndall/layer.hpp"

namespace tyndall {

/// Row-major, top row first, width x height of the crop window. Layers that are not in the set have empty vectors.
struct PassImage {
    int width = 0, height = 0;
    std::array<std::vector<Rgb>, layer_count> layers;

    PassImage() = default;
    PassImage(int w, int h, LayerSet set) : width(w), height(h)
    {
        for (std::size_t l = 0; l < layer_count; ++l)
            if (set.contains(static_cast<Layer>(l))) layers[l].assign(static_cast<std::size_t>(w) * h, Rgb(0));
    }
    std::vector<Rgb>& operator[](Layer layer) { return layers[static_cast<std::size_t>(layer)]; }
    const std::vector<Rgb>& operator[](Layer layer) const { return layers[static_cast<std::size_t>(layer)]; }
};

/// Features of the first camera sample of each pixel, for denoisers; averaged over passes like radiance.
struct PixelFeatures {
    std::vector<Rgb> albedo;  ///< reflectance of the first surface that is not specular, or single scattering albedo of a medium met first;
                              ///< 0 for nothing
    std::vector<Vec3> normal;   ///< shading normal there, world space; 0 for nothing
    std::vector<double> depth;  ///< distance along the view axis to the first surface in scene-file units; 0 for nothing
};

}  // namespace tyndall
