#pragma once
/// Fresnel's equations for unpolarised light.

namespace tyndall {

/// Reflectance of a smooth boundary; cosine >= 0 on the side of arrival, eta = index behind / index before. 1 at total reflection.
double fresnel_dielectric(double cosine, double eta);

/// The same for a conductor with complex index eta + i k relative to the outside.
double fresnel_conductor(double cosine, double eta, double k);

/// Cosine to the normal behind the boundary, by Snell's law; -1 at total reflection.
double refracted_cosine(double cosine, double eta);

/// Reflectance of a smooth boundary for light that arrives from all directions alike: 2 times the integral of fresnel_dielectric(mu, eta) mu over mu.
double diffuse_fresnel(double eta);

}  // namespace tyndall
