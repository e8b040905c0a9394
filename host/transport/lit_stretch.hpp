#pragma once
/// Which part of a line through a medium can matter at all.
#include "volumes/medium_line.hpp"

namespace tyndall {

/// From t = start, over `length`; <= 0: none of it.
struct LitStretch {
    double start, length;
    Rgb depth;  ///< its optical depth
    Rgb whole;  ///< that of the whole line
};

/// The part of the line where the medium is not empty, up to where it is opaque (opaque_distance.hpp). `before`: optical depth already behind the light.
LitStretch lit_stretch(const Scene& scene, const MediumLine& line, const Rgb& before = Rgb(0));

}  // namespace tyndall
