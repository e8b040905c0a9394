#pragma once
/// Light that is scattered once in a medium on its way from a light to the camera.
#include "path_tracing/path_tracing.hpp"

namespace tyndall {

/// Adds one estimate per camera sample and stretch of medium to the layer `single`: a point on a light, then the distance on the stretch in
/// proportion to 1 / distance^2 to it [Kulla and Fajardo 2012], mixed with distances by extinction x transmittance (scatter_distances.hpp) as the stretch gets
/// thick; by these alone for light from outside. Unbiased. Where log T < -104 in every channel that scatters (zero in float), the stretch ends.
/// settings.layers is not looked at.
void trace_single(const Scene& scene, const Visibility& visibility, const PathTracingSettings& settings, PassImage& image);

}  // namespace tyndall
