#pragma once
/// A light's kernel functions in both precisions under one name, for the pairs of plain_transport.hpp. Before it come host_maths.hpp, the light's header in both
/// namespaces, and `template <typename Light> Light light_of(const plain::Pair&)`: the light of a pair.
#include "tests/lights/host_maths.hpp"

namespace tyndall {
namespace {

using plain::all_lobes;
using plain::Lobes;
using plain::Pair;
using plain::SurfacePair;

MediumRecord medium_of(const Pair& p, const Lobes& lobes = {})
{
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(p.sigma_t.x), f(p.sigma_t.y), f(p.sigma_t.z), f(p.g), f(p.sigma_s.x), f(p.sigma_s.y), f(p.sigma_s.z), 0, uint(lobes.records.size()), NO_GRID, NO_GRID, 0};
}

/// Both precisions under one name.
struct Double {
    using real = double;
    static glm::dvec3 segment(const Pair& p, double xi0, double xi1, const Lobes& lobes = {})
    {
        using namespace maths_double;
        const MediumRecord medium = medium_of(p, lobes);
        const real3 t{p.sigma_t.x, p.sigma_t.y, p.sigma_t.z}, s{p.sigma_s.x, p.sigma_s.y, p.sigma_s.z};
        const Connection c = connect_segment({{p.o.x, p.o.y, p.o.z}, {p.a.x, p.a.y, p.a.z}, {1, 1, 1}, p.eye_length}, {t, s, p.g, {1, !lobes.records.empty(), 0, {phase_range(medium)}}},
                                             light_of<Light>(p), medium, {lobes.records.data(), lobes.values.data()}, {xi0, xi1});
        return glm::dvec3(c.radiance.x, c.radiance.y, c.radiance.z) * glm::exp(-p.sigma_t * c.length);
    }
    static glm::dvec3 point(const SurfacePair& s, double xi0, const Lobes& lobes = {})
    {
        using namespace maths_double;
        const Connection c = connect_point({{s.x.x, s.x.y, s.x.z}, {s.n.x, s.n.y, s.n.z}, {s.n.x, s.n.y, s.n.z}, {1, 1, 1}}, light_of<Light>(s.light), medium_of(s.light, lobes),
                                           {lobes.records.data(), lobes.values.data()}, {xi0, .5});
        return glm::dvec3(c.radiance.x, c.radiance.y, c.radiance.z) * glm::exp(-s.light.sigma_t * c.length);
    }
};
struct Float {
    using real = float;
    static glm::dvec3 segment(const Pair& p, double xi0, double xi1, const Lobes& lobes = {})
    {
        using namespace maths_float;
        const MediumRecord medium = medium_of(p, lobes);
        const auto v = [](const glm::dvec3& x) { return real3{float(x.x), float(x.y), float(x.z)}; };
        const Connection c = connect_segment({v(p.o), v(p.a), {1, 1, 1}, float(p.eye_length)},
                                             {v(p.sigma_t), v(p.sigma_s), float(p.g), {1, !lobes.records.empty(), 0, {phase_range(medium)}}}, light_of<Light>(p), medium,
                                             {lobes.records.data(), lobes.values.data()}, {float(xi0), float(xi1)});
        return glm::dvec3(c.radiance.x, c.radiance.y, c.radiance.z) * glm::exp(-p.sigma_t * double(c.length));
    }
    [[maybe_unused]] static glm::dvec3 point(const SurfacePair& s, double xi0, const Lobes& lobes = {})
    {
        using namespace maths_float;
        const auto v = [](const glm::dvec3& x) { return real3{float(x.x), float(x.y), float(x.z)}; };
        const Connection c = connect_point({v(s.x), v(s.n), v(s.n), {1, 1, 1}}, light_of<Light>(s.light), medium_of(s.light, lobes), {lobes.records.data(), lobes.values.data()}, {float(xi0), .5f});
        return glm::dvec3(c.radiance.x, c.radiance.y, c.radiance.z) * glm::exp(-s.light.sigma_t * double(c.length));
    }
};

/// Mean over a midpoint grid of random numbers: the integrand is smooth in them.
[[maybe_unused]] glm::dvec3 mean_over_segment(const Pair& p, int n, const Lobes& lobes = {})
{
    glm::dvec3 sum(0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += Double::segment(p, (i + .5) / n, (j + .5) / n, lobes);
    return sum / double(n * n);
}

[[maybe_unused]] void expect_near(const glm::dvec3& ours, const glm::dvec3& oracle, double tolerance, const std::string& what)
{
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ours[c] / oracle[c], 1, tolerance) << what << ", channel " << c << ": " << ours[c] << " against " << oracle[c];
}

}  // namespace
}  // namespace tyndall
