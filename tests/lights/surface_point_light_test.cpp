/// The light contract for virtual point lights on surfaces: transport equals quadrature that shares no code with kernels/, float agrees with double, and the laws that light obeys hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/lights/host_maths.hpp"

namespace tyndall {
namespace maths_float {
#include "kernels/lights/surface_point_light.h"
}
#undef SURFACE_POINT_LIGHT_H
namespace maths_double {
#include "kernels/lights/surface_point_light.h"
}

/// At the pair's p, on a flat surface that faces b, of the power flux per steradian and cosine.
template <typename Light>
Light light_of(const plain::Pair& p)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(p.p.x), f(p.p.y), f(p.p.z), 0, f(p.b.x), f(p.b.y), f(p.b.z), 0, f(p.flux.x), f(p.flux.y), f(p.flux.z), 0, f(p.b.x), f(p.b.y), f(p.b.z), 0};
}

}  // namespace tyndall

#include "tests/lights/both_precisions.hpp"

namespace tyndall {
namespace {

/// The whole eye segment in front of the light: the integrand is smooth.
Pair pair_in_front(std::mt19937& engine, double g)
{
    for (;;) {
        Pair p = plain::random_pair(engine, g, false);
        if (glm::dot(p.b, p.o - p.p) < 0) p.b = -p.b;
        if (glm::dot(p.b, p.o - p.p) > .1 && glm::dot(p.b, p.o + p.eye_length * p.a - p.p) > .1) return p;
    }
}

SurfacePair surface_pair_in_front(std::mt19937& engine)
{
    SurfacePair s = plain::random_surface_pair(engine, 0, false);
    if (glm::dot(s.light.b, s.x - s.light.p) < 0) s.light.b = -s.light.b;
    return s;
}

/// Mean over a midpoint grid of the number that draws the place on the eye segment.
glm::dvec3 mean_over_eye(const Pair& p, int n, const Lobes& lobes = {})
{
    glm::dvec3 sum(0);
    for (int j = 0; j < n; ++j) sum += Double::segment(p, .5, (j + .5) / n, lobes);
    return sum / double(n);
}

class SurfaceLightBySampler : public testing::TestWithParam<int> {
protected:
    void SetUp() override { tested_sampler = GetParam(); }
    void TearDown() override { tested_sampler = SAMPLER_PAPER_ISOTROPIC; }
};
INSTANTIATE_TEST_SUITE_P(SurfacePointLight, SurfaceLightBySampler, testing::Values(SAMPLER_PAPER_ISOTROPIC, SAMPLER_PAPER, SAMPLER_PAPER_6, SAMPLER_TABLE, SAMPLER_TABLE_3X2));

TEST_P(SurfaceLightBySampler, TransportToASegmentEqualsQuadrature)
{
    std::mt19937 engine(11);
    for (const double g : {0.0, .55, .9, -.7})
        for (int i = 0; i < 8; ++i) {
            const Pair p = pair_in_front(engine, g);
            // Midpoint rule with 4096 places: far below 1e-5 for a smooth density; a product's corners cost some.
            expect_near(mean_over_eye(p, 4096), plain::transport_from_surface(p), GetParam() == SAMPLER_PAPER_ISOTROPIC ? 1e-5 : 2e-4, "g " + std::to_string(g) + " pair " + std::to_string(i));
        }
}

TEST_P(SurfaceLightBySampler, FloatAgreesWithDouble)
{
    std::mt19937 engine(13);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<double> errors;
    for (int i = 0; i < 4000; ++i) {
        const Pair p = plain::as_float(pair_in_front(engine, i % 2 ? .55 : 0));
        const float xi = uniform(engine);
        const glm::dvec3 f = Float::segment(p, .5, xi), d = Double::segment(p, .5, xi);
        ASSERT_TRUE(std::isfinite(f.x + f.y + f.z)) << "pair " << i;
        errors.push_back(glm::length(f - d) / glm::length(d));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() / 2], 4e-6);  // some ten roundings of 6e-8, thirty more in a product's table
    EXPECT_LT(errors.back(), 1e-3);
}

TEST(SurfacePointLight, TransportBySumsOfLobesEqualsQuadrature)
{
    std::mt19937 engine(31);
    for (const Lobes& lobes : all_lobes())
        for (int i = 0; i < 4; ++i) {
            Pair p = pair_in_front(engine, 0);
            p.phase = lobes.phase, p.g = lobes.mean;
            expect_near(mean_over_eye(p, 8192, lobes), plain::transport_from_surface(p), 3e-4, lobes.name + " pair " + std::to_string(i));  // a table has corners
        }
}

TEST(SurfacePointLight, TransportToASurfaceEqualsItsFormula)
{
    std::mt19937 engine(12);
    for (int i = 0; i < 60; ++i) {
        SurfacePair s = surface_pair_in_front(engine);
        s.light = plain::as_float(s.light);  // as its record: what is left of float's rounding counts the tangent of the angle at the light, some 50 here
        expect_near(Double::point(s, .5), plain::transport_from_surface(s), 1e-10, "pair " + std::to_string(i));
        expect_near(Float::point(s, .5), plain::transport_from_surface(s), 2e-5, "pair " + std::to_string(i));
    }
}

TEST(SurfacePointLight, APlantedErrorOfTheToleranceIsSeen)
{
    std::mt19937 engine(11);
    Pair p = pair_in_front(engine, 0);
    const glm::dvec3 oracle = plain::transport_from_surface(p);
    p.b = glm::normalize(p.b + .001 * p.a);  // a normal that leans
    EXPECT_GT(std::abs(mean_over_eye(p, 4096).x / oracle.x - 1), 1e-5);
}

TEST(SurfacePointLight, SendsNothingBehindEitherNormalAndNothingArrivesBelowTheHorizon)
{
    std::mt19937 engine(17);
    const SurfacePair s = surface_pair_in_front(engine);
    SurfacePair below = s, behind = s;
    below.n = -s.n, behind.light.b = -s.light.b;
    EXPECT_EQ(Double::point(below, .5), glm::dvec3(0));
    EXPECT_EQ(Double::point(behind, .5), glm::dvec3(0));
    using namespace maths_double;
    SurfacePointLight leaning = light_of<SurfacePointLight>(s.light);
    EXPECT_GT(cosine_at_light(leaning, {s.light.p.x - s.x.x, s.light.p.y - s.x.y, s.light.p.z - s.x.z}, glm::distance(s.light.p, s.x)), 0);
    leaning.normal_x = -leaning.normal_x, leaning.normal_y = -leaning.normal_y, leaning.normal_z = -leaning.normal_z;
    EXPECT_EQ(cosine_at_light(leaning, {s.light.p.x - s.x.x, s.light.p.y - s.x.y, s.light.p.z - s.x.z}, glm::distance(s.light.p, s.x)), 0) << "the shading normal says that the eye is behind";
}

TEST(SurfacePointLight, IsLinearInItsPowerAndKnowsNoUnitOfLength)
{
    std::mt19937 engine(15);
    for (const int exponent : {-50, -3, 5, 50}) {
        const double k = std::ldexp(1.0, exponent);
        Pair p = plain::as_float(pair_in_front(engine, .3));
        const glm::dvec3 one = Float::segment(p, .3, .6);
        Pair brighter = p, larger = p;
        brighter.flux *= k;
        larger.o *= k, larger.p *= k, larger.eye_length *= k, larger.light_length *= k, larger.sigma_t /= k, larger.sigma_s /= k;
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(Float::segment(brighter, .3, .6)[c], k * one[c]) << "2^" << exponent;
            EXPECT_EQ(Float::segment(larger, .3, .6)[c] * k * k, one[c]) << "2^" << exponent;  // sigma_s of the eye and 1 / w^2 du: k^-2
        }
        SurfacePair s = surface_pair_in_front(engine), far;
        s.light = plain::as_float(s.light), s.x = glm::dvec3(glm::vec3(s.x)), s.n = glm::dvec3(glm::vec3(s.n)), far = s;
        far.light.p *= k, far.x *= k, far.light.sigma_t /= k;
        for (int c = 0; c < 3; ++c) EXPECT_EQ(Float::point(far, .5)[c] * k * k, Float::point(s, .5)[c]) << "2^" << exponent;
    }
}

/// Contact and all but contact: hard_cases rows 10-13, 28 and 29 for a point on a surface.
TEST(SurfacePointLight, IsFiniteWhereItTouches)
{
    std::mt19937 engine(19);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int i = 0; i < 4000; ++i) {
        Pair p = plain::as_float(plain::random_pair(engine, i % 2 ? .99 : 0, false));
        const double near = std::pow(10., -double(i / 8 % 12));
        if (i % 8 == 0) p.p = p.o;
        if (i % 8 == 1) p.p = p.o + .5 * p.eye_length * p.a;
        if (i % 8 == 2) p.p = p.o - near * p.a;
        if (i % 8 == 3) p.p = p.o + (p.eye_length + near) * p.a;
        if (i % 8 == 4) p.p = p.o + .3 * p.eye_length * p.a + near * glm::dvec3(p.a.y, -p.a.x, 0);
        if (i % 8 == 5) p.o = p.p = {};
        if (i % 8 == 6) p.eye_length = near * 1e-6;
        if (i % 8 == 7) p.p *= 1e6, p.o = p.p + near * p.a;
        const glm::dvec3 f = Float::segment(plain::as_float(p), .5, uniform(engine));
        EXPECT_TRUE(std::isfinite(f.x + f.y + f.z)) << "case " << i;
        const SurfacePair s{plain::as_float(p), glm::dvec3(glm::vec3(p.o)), p.a};
        const glm::dvec3 g = Float::point(s, .5);
        EXPECT_TRUE(std::isfinite(g.x + g.y + g.z)) << "case " << i;
    }
}

double sum(const glm::dvec3& v) { return v.x + v.y + v.z; }
double cosine(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, glm::normalize(b)); }

TEST(SurfacePointLight, EstimatesFollowQuadrature)
{
    constexpr double sphere = 4 * 3.14159265358979323846;
    using namespace maths_double;
    std::mt19937 engine(41);
    for (const double g : {0.0, .55, -.7})
        for (int i = 0; i < 300; ++i) {
            const Pair p = pair_in_front(engine, g);
            const SurfacePair s = surface_pair_in_front(engine);
            if (cosine(s.light.b, s.x - s.light.p) < .1 || cosine(p.b, p.o - p.p) < .1) continue;  // where a cosine is small, a tenth stands for it
            const MediumRecord medium = medium_of(p);
            const MediumLanes eye_medium{{p.sigma_t.x, p.sigma_t.y, p.sigma_t.z}, {p.sigma_s.x, p.sigma_s.y, p.sigma_s.z}, p.g, {1, 0, 0, {phase_range(medium)}}};
            const double to_segment = estimate_to_segment({{p.o.x, p.o.y, p.o.z}, {p.a.x, p.a.y, p.a.z}, {1, 1, 1}, p.eye_length}, eye_medium, light_of<Light>(p), medium, 1) / sphere;
            const double to_point = estimate_to_point({{s.x.x, s.x.y, s.x.z}, {s.n.x, s.n.y, s.n.z}, {s.n.x, s.n.y, s.n.z}, {1, 1, 1}}, light_of<Light>(s.light), medium_of(s.light), 1);
            for (const double ratio : {to_segment / sum(plain::transport_from_surface(p)), to_point / sum(plain::transport_from_surface(s))}) {
                EXPECT_GT(ratio, .2) << g << ", pair " << i;
                EXPECT_LT(ratio, 25) << g << ", pair " << i;
            }
        }
}

}  // namespace
}  // namespace tyndall
