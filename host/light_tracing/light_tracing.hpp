#pragma once
/// Light paths from every emitter through surfaces and media, and the virtual lights that they leave.
#include <cstdint>
#include <vector>

#include "lights/light_technique.hpp"
#include "scene/scene.hpp"
#include "tyndall/settings.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

struct LightTracingSettings {
    std::uint64_t seed = 1, pass = 0;
    std::uint64_t paths = 0;           ///< light paths in this pass; fixed before the first is traced, so that their mean is unbiased
    int max_depth = -1;                ///< of whole paths: lights that no camera path could use are not left
    LightSegments light_segments = LightSegments::all;
    SegmentLength segment_length = SegmentLength::long_;
    bool even = true;                  ///< their first numbers are scrambled Sobol points; false: independent
    bool pilot = false;                ///< count only, from numbers of its own
    double radius = 0;                 ///< of thick lights in this pass, in render space
    int vertices_to_come = 2;          ///< that a path has at least beyond those before the light: at the light and at the eye; where light is gathered they are one
    const StopFlag* stop = nullptr;    ///< raised: Stopped is thrown
};

struct VirtualLights {
    std::vector<std::byte> records;    ///< of technique.record_bytes each, in the order of the paths
    std::uint32_t count = 0;
};

/// Traces the paths and deposits their segments. The result does not depend on the number of threads.
VirtualLights trace_lights(const Scene& scene, const Visibility& visibility, const LightTechnique& technique, const LightTracingSettings& settings);

/// What eyes take from when it comes near, by the layer that it adds to.
struct GatheredLights {
    Layer layer;
    VirtualLights lights;
};

/// The same for density estimation: records for each of `layers`, in order. Which of them a piece of a path or an arrival belongs to follows from what the path met before.
std::vector<GatheredLights> trace_gathered_lights(const Scene& scene, const Visibility& visibility, const LightTechnique& technique, const LightTracingSettings& settings, const LayerSet& layers);

/// How many paths leave about `lights` virtual lights in a pass, of `layers` if they are gathered: from a pilot of its own, the same for every pass. At least 1.
std::uint64_t paths_for(const Scene& scene, const Visibility& visibility, const LightTechnique& technique, LightTracingSettings settings, std::uint32_t lights,
                        const LayerSet& layers = LayerSet::all());

}  // namespace tyndall
