#pragma once
/// How little a scene's media scatter: a bound that needs nothing traced.
#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall {

/// Of the light that media have scattered, at most this share is scattered by media again before it meets a surface or leaves: the power that reaches
/// media_to_media's second vertex, over all directions and pixels, relative to what media scatter in all. It bounds energy, not single pixels: one that sees no
/// light scattered once may see light scattered twice.
struct ScatteredAgain {
    double share = 1;       ///< 1 - exp(-depth), in [0, 1]
    double depth = 0;       ///< largest scattering optical depth of a straight line through the media; infinite where one has no end
    std::string why;        ///< a sentence: which medium decides
    SourceLocation where;   ///< of that medium; line 0: no medium scatters
};

/// The line is bounded by the sum over media of the largest scattering coefficient (of all channels, and of all voxels) times the diagonal of the box around the
/// closed shapes that the medium fills. A medium that is not inside closed shapes has no bound: share 1.
ScatteredAgain scattered_again(const Scene& scene);

/// The boxes around the closed shapes that the scattering media fill; nothing where such a medium is not inside closed shapes: it may be anywhere.
std::optional<std::vector<Bounds>> scattering_regions(const Scene& scene);

}  // namespace tyndall
