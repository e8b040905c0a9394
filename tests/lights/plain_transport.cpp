#include "tests/lights/plain_transport.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace tyndall::plain {
namespace {

double henyey_greenstein(double mu, double g) { return (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * mu, 1.5)); }

double phase(const Pair& p, double mu) { return p.phase ? p.phase(mu) : henyey_greenstein(mu, p.g); }

glm::dvec3 random_direction(std::mt19937& engine)
{
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
}

glm::dvec3 random_position(std::mt19937& engine)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    return {uniform(engine), uniform(engine), uniform(engine)};
}

double nearest(const Pair& p)
{
    double least = 1e9;
    for (int i = 0; i <= 64; ++i)
        for (int j = 0; j <= 64; ++j) least = std::min(least, glm::distance(p.o + p.a * (p.eye_length * i / 64), p.p + p.b * (p.light_length * j / 64)));
    return least;
}

/// Integral of f over [0, length] with 24 panels of 5-point Gauss-Legendre.
template <typename F>
glm::dvec3 integrate(double length, const F& f)
{
    constexpr std::array nodes{0.0, -0.5384693101056831, 0.5384693101056831, -0.9061798459386640, 0.9061798459386640};
    constexpr std::array weights{0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891, 0.2369268850561891};
    constexpr int panels = 24;
    glm::dvec3 sum(0);
    for (int panel = 0; panel < panels; ++panel)
        for (std::size_t k = 0; k < nodes.size(); ++k) sum += weights[k] * f(length * (panel + .5 + .5 * nodes[k]) / panels);
    return sum * (.5 * length / panels);
}

/// Transmittance along the light up to v, as its flux is defined.
glm::dvec3 along_light(const Pair& p, double v)
{
    const glm::dvec3 t = glm::exp(-p.sigma_t * v);
    return p.is_short ? t / glm::dot(p.share, t) : t;
}

}  // namespace

Pair random_pair(std::mt19937& engine, double g, bool is_short)
{
    std::uniform_real_distribution<double> length(.3, 1.5);
    Pair p{.o = {}, .a = {}, .p = {}, .b = {}, .eye_length = 0, .light_length = 0, .g = g, .sigma_t = {.4, 1, 2.2}, .sigma_s = {.35, .8, 1.1}, .flux = {1, 2, .5},
           .share = is_short ? glm::dvec3(.5, .3, .2) : glm::dvec3(0), .is_short = is_short};
    do {
        p.o = random_position(engine), p.p = random_position(engine), p.a = random_direction(engine), p.b = random_direction(engine);
        p.eye_length = length(engine), p.light_length = length(engine);
    } while (nearest(p) < .15);
    return p;
}

SurfacePair random_surface_pair(std::mt19937& engine, double g, bool is_short)
{
    SurfacePair s{random_pair(engine, g, is_short), {}, {}};
    do {
        s.light = random_pair(engine, g, is_short);
        s.x = s.light.o, s.n = random_direction(engine);  // whole light above the horizon: the oracle's integrand is smooth
    } while (glm::dot(s.n, s.light.p - s.x) < .1 || glm::dot(s.n, s.light.p + s.light.light_length * s.light.b - s.x) < .1);
    return s;
}

Pair as_float(Pair p)
{
    for (glm::dvec3* v : {&p.o, &p.a, &p.p, &p.b, &p.sigma_t, &p.sigma_s, &p.flux, &p.share}) *v = glm::dvec3(glm::vec3(*v));
    p.eye_length = float(p.eye_length), p.light_length = float(p.light_length), p.g = float(p.g);
    return p;
}

Pair swapped(const Pair& p)
{
    // An eye path that starts at o and looks along a is a light path that starts at o and travels along a.
    Pair q = p;
    q.o = p.p, q.a = p.b, q.eye_length = p.light_length, q.p = p.o, q.b = p.a, q.light_length = p.eye_length;
    return q;
}

glm::dvec3 transport(const Pair& p, const Geometry& geometry)
{
    return p.flux * p.sigma_s * p.sigma_s * integrate(p.light_length, [&](double v) {
        return along_light(p, v) * integrate(p.eye_length, [&](double u) {
            const glm::dvec3 d = p.o + u * p.a - (p.p + v * p.b);  // from the light to the eye segment
            const double w = glm::length(d);
            const double both = phase(p, glm::dot(p.b, d / w)) * phase(p, glm::dot(d / w, -p.a));
            return glm::exp(-p.sigma_t * (u + w)) * (both * (geometry ? geometry(w) : 1 / (w * w)));
        });
    });
}

glm::dvec3 transport(const SurfacePair& s, const Geometry& geometry)
{
    const Pair& p = s.light;
    return p.flux * p.sigma_s * integrate(p.light_length, [&](double v) {
        const glm::dvec3 d = s.x - (p.p + v * p.b);
        const double w = glm::length(d), cosine = std::max(glm::dot(s.n, -d / w), 0.0);
        return along_light(p, v) * glm::exp(-p.sigma_t * w) * (phase(p, glm::dot(p.b, d / w)) * cosine * (geometry ? geometry(w) : 1 / (w * w)));
    });
}

glm::dvec3 transport_from_point(const Pair& p)
{
    return p.flux * p.sigma_s * integrate(p.eye_length, [&](double u) {
        const glm::dvec3 d = p.o + u * p.a - p.p;
        const double w = glm::length(d);
        return glm::exp(-p.sigma_t * (u + w)) * (phase(p, glm::dot(p.b, d / w)) * phase(p, glm::dot(d / w, -p.a)) / (w * w));
    });
}

glm::dvec3 transport_from_point(const SurfacePair& s)
{
    const Pair& p = s.light;
    const glm::dvec3 d = s.x - p.p;
    const double w = glm::length(d);
    return p.flux * glm::exp(-p.sigma_t * w) * (phase(p, glm::dot(p.b, d / w)) * std::max(glm::dot(s.n, -d / w), 0.0) / (w * w));
}

glm::dvec3 transport_from_surface(const Pair& p)
{
    return p.flux * p.sigma_s * integrate(p.eye_length, [&](double u) {
        const glm::dvec3 d = p.o + u * p.a - p.p;
        const double w = glm::length(d);
        return glm::exp(-p.sigma_t * (u + w)) * (std::max(glm::dot(p.b, d / w), 0.0) * phase(p, glm::dot(d / w, -p.a)) / (w * w));
    });
}

glm::dvec3 transport_from_surface(const SurfacePair& s)
{
    const Pair& p = s.light;
    const glm::dvec3 d = s.x - p.p;
    const double w = glm::length(d);
    return p.flux * glm::exp(-p.sigma_t * w) * (std::max(glm::dot(p.b, d / w), 0.0) * std::max(glm::dot(s.n, -d / w), 0.0) / (w * w));
}

}  // namespace tyndall::plain
