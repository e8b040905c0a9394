#pragma once
/// The unbiased volumetric path tracer, layer by layer: the whole image for --method path, the layers that virtual lights do not carry for
/// the others, and the brute-force twin that every technique is tested against.
#include "film/pass_image.hpp"
#include "scene/scene.hpp"
#include "tyndall/layer.hpp"
#include "tyndall/stop.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

/// At its first vertex a path is connected to every emitter of a scene that has no more than so many, later to one chosen at random: direct light is most
/// of the noise of the first.
inline constexpr std::size_t most_emitters_at_once = 4;

struct PathTracingSettings {
    std::uint64_t seed = 1, pass = 0;
    int max_depth = -1;  ///< at most max_depth - 1 scattering vertices; -1: no limit
    LayerSet layers;     ///< what to compute; paths that cannot reach any of them are ended
    LayerSet glossy_only;  ///< of these: only where x1 is a surface that other techniques do not know (SurfaceParts::lambertian)
    LayerSet glossy_lights;  ///< of these: only where x2 is one, or, in a layer of both, where x1 or x2 is
    const StopFlag* stop = nullptr;  ///< raised: Stopped is thrown
};

/// Adds one camera sample per pixel of the wanted layers to `image`. Parallel over pixels; the result does not depend on the number of
/// threads.
void trace_paths(const Scene& scene, const Visibility& visibility, const PathTracingSettings& settings, PassImage& image);

/// Throws nothing; lists what the path tracer cannot carry in this scene (point, spot or directional light behind smooth glass), one
/// sentence each.
std::vector<std::string> uncarried_light(const Scene& scene);

}  // namespace tyndall
