#pragma once
/// Plastics: a boundary of dielectric over something diffuse. What depends on the boundary alone is computed once.
#include "scene/scene.hpp"

namespace tyndall {

/// Fills internal_reflectance and boundary_transmittance of a plastic from its eta and roughness.
void prepare_plastic(Bsdf& bsdf);

/// Share of light at this cosine to the normal that passes the boundary of a prepared plastic.
double plastic_transmittance(const Bsdf& bsdf, double cosine);

}  // namespace tyndall
