#pragma once
/// Camera paths through null and specular interactions: the eye segments and eye points that virtual lights are connected to.
#include <cstdint>
#include <vector>

#include "film/pass_image.hpp"
#include "kernels/shared/records.hpp"
#include "scene/scene.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

struct EyeTracingSettings {
    std::uint64_t seed = 1, pass = 0;
    int max_depth = -1;
    bool segments = true, points = true;  ///< which of them are wanted
};

struct EyeRecords {
    std::vector<EyeSegment> segments;  ///< in pixel order; in media that scatter
    std::vector<EyePoint> points;      ///< in pixel order; at most one per pixel, on surfaces that reflect diffusely
    PixelFeatures features;
};

/// One camera sample per pixel of the crop window. The result does not depend on the number of threads.
EyeRecords trace_eyes(const Scene& scene, const Visibility& visibility, const EyeTracingSettings& settings);

}  // namespace tyndall
