#pragma once
/// Small renders with error bars.
#include "../transport/built_scene.hpp"
#include "../transport/statistics.hpp"
#include "path_tracing/path_tracing.hpp"
#include "path_tracing/single_scattering.hpp"

namespace tyndall::test {

struct Rendered {
    std::vector<Mean> pixels;  ///< of the wanted channel, sum of layers, over passes
    Mean image;                ///< mean over pixels, over passes
};

struct RenderPlan {
    LayerSet layers = LayerSet::all();
    int passes = 256, max_depth = -1, channel = 1, threads = 1;
    bool single_by_light = false;  ///< the layer `single` by trace_single instead
};

inline Rendered render(const Scene& scene, const RenderPlan& plan)
{
    const Visibility visibility(scene, plan.threads);
    Rendered result;
    result.pixels.resize(static_cast<std::size_t>(scene.camera.crop_width) * scene.camera.crop_height);
    for (int pass = 0; pass < plan.passes; ++pass) {
        PassImage image(scene.camera.crop_width, scene.camera.crop_height, plan.layers);
        PathTracingSettings settings{
            .seed = 3, .pass = static_cast<std::uint64_t>(pass), .max_depth = plan.max_depth, .layers = plan.layers};
        if (plan.single_by_light) settings.layers.remove(Layer::single), trace_single(scene, visibility, settings, image);
        trace_paths(scene, visibility, settings, image);
        double total = 0;
        for (std::size_t i = 0; i < result.pixels.size(); ++i) {
            double value = 0;
            for (const auto& layer : image.layers)
                if (!layer.empty()) value += layer[i][plan.channel];
            result.pixels[i].add(value), total += value;
        }
        result.image.add(total / double(result.pixels.size()));
    }
    return result;
}

inline LayerSet only(Layer layer) { return LayerSet().add(layer); }

}  // namespace tyndall::test
