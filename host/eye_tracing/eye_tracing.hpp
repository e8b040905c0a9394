#pragma once
/// Camera paths through null and specular interactions: the eye segments and eye points that virtual lights are connected to.
#include <cstdint>
#include <vector>

#include "film/pass_image.hpp"
#include "kernels/shared/records.hpp"
#include "scene/scene.hpp"
#include "tyndall/stop.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

struct EyeTracingSettings {
    std::uint64_t seed = 1, pass = 0;
    int samples = 1;  ///< camera samples per pixel; features are those of the first
    int max_depth = -1;
    int vertices_to_come = 2;  ///< scattering vertices that a path has at least beyond those before the eye: x1 and x2; where light is gathered x1 alone
    bool segments = true, points = true;  ///< which of them are wanted
    const StopFlag* stop = nullptr;  ///< raised: Stopped is thrown
};

struct EyeRecords {
    std::vector<EyeSegment> segments;  ///< camera sample by camera sample, each in pixel order; in media that scatter
    std::vector<EyePoint> points;      ///< the same; at most one per pixel and camera sample, on surfaces that reflect diffusely
    std::vector<std::size_t> segment_ends, point_ends;  ///< number of segments and points after each camera sample
    PixelFeatures features;
};

/// Camera samples of the pixels of the crop window; a pixel is the mean of its own. The result does not depend on the number of threads.
EyeRecords trace_eyes(const Scene& scene, const Visibility& visibility, const EyeTracingSettings& settings);

}  // namespace tyndall
