#pragma once
/// What a virtual ray light sends to an eye segment or a surface point, by plain quadrature of the talk's integral: an oracle that shares no code with
/// kernels/. Phase functions and transmittances are the textbook's.
#include <glm/glm.hpp>

#include <functional>
#include <random>

namespace tyndall::plain {

struct Pair {
    glm::dvec3 o, a, p, b;                   ///< eye origin and direction, light origin and direction
    double eye_length, light_length, g = 0;
    glm::dvec3 sigma_t, sigma_s, flux{1}, share{0};
    bool is_short = false;
    std::function<double(double)> phase{};   ///< of the cosine, per steradian; empty: Henyey and Greenstein's for g
};
struct SurfacePair {
    Pair light;
    glm::dvec3 x, n;
};

/// Segments inside a box of side 2, apart from each other by at least .15, chromatic medium.
Pair random_pair(std::mt19937& engine, double g, bool is_short);
SurfacePair random_surface_pair(std::mt19937& engine, double g, bool is_short);
/// Inputs rounded to float, so that both precisions see the same pair.
Pair as_float(Pair pair);
/// Eye and light exchange their roles.
Pair swapped(const Pair& pair);

/// What stands for 1 / w^2; empty: that.
using Geometry = std::function<double(double)>;

/// Integral over both segments of flux sigma_s^2 f f T / w^2, composite Gauss-Legendre.
glm::dvec3 transport(const Pair& pair, const Geometry& geometry = {});
/// Integral over the light of flux sigma_s f T max(n . omega, 0) / w^2.
glm::dvec3 transport(const SurfacePair& pair, const Geometry& geometry = {});

/// The same for a point light at the pair's `p` that scatters the power `flux`, lit along `b`: one integral over the eye segment of flux sigma_s f f T / w^2, and flux f T
/// max(n . omega, 0) / w^2.
glm::dvec3 transport_from_point(const Pair& pair);
glm::dvec3 transport_from_point(const SurfacePair& pair);

/// The same for a light on a surface at the pair's `p` that faces `b`, flux being its power per steradian and cosine: flux sigma_s f T max(b . omega, 0) / w^2 over the eye segment, and flux T
/// max(n . omega, 0) max(-b . omega, 0) / w^2.
glm::dvec3 transport_from_surface(const Pair& pair);
glm::dvec3 transport_from_surface(const SurfacePair& pair);

}  // namespace tyndall::plain
