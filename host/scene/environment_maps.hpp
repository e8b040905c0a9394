#pragma once
/// Light from far away, by direction: which radiance comes from where, and directions in proportion to it. Directions are unit vectors in the map's own space.
#include "scene/scene.hpp"

namespace tyndall {

/// Fills rows, columns and mean from width, height and texels.
void prepare_environment(EnvironmentMap& map);

/// Radiance that arrives from `towards` (a direction away from the scene). As Mitsuba 3 has it: the azimuth from local -z towards +x, of 2 pi, crosses the columns, whose
/// centres lie at (x + 1/2) / width of it; the angle to local +y crosses the rows, from the first to the last; bilinear between.
Rgb radiance_from(const EnvironmentMap& map, const Vec3& towards);

struct EnvironmentSample {
    Vec3 towards;
    double pdf;  ///< per steradian
};

/// A direction in proportion to the mean luminance of the cell between four texels, uniform over the cell's solid angle.
EnvironmentSample sample_environment(const EnvironmentMap& map, const Vec2& xi);

/// Density of sample_environment.
double pdf_environment(const EnvironmentMap& map, const Vec3& towards);

}  // namespace tyndall
