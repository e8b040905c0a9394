/// The light contract for photons: what an eye point takes from photons all around it is what falls on the surface there; float agrees with double; hard cases are finite; and the blur's bias
/// falls as section 19 of kernels/README.md predicts.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "lights/progressive_radius.hpp"
#include "tests/lights/host_maths.hpp"

namespace tyndall {
namespace maths_float {
#include "kernels/lights/photon.h"
}
#undef PHOTON_H
namespace maths_double {
#include "kernels/lights/photon.h"
}
namespace {

using glm::dvec3;

struct Case {
    dvec3 x{0}, normal{0, 0, 1}, facing{0, 0, 1}, throughput{.3, .2, .1};
    dvec3 at{0}, direction{0, 0, -1}, side{0, 0, 1}, power{1, 2, 3};
    double radius = .1;
};

template <typename Photon>
Photon photon_of(const Case& c)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(c.at.x), f(c.at.y), f(c.at.z), f(c.radius), f(c.direction.x), f(c.direction.y), f(c.direction.z), 0, f(c.power.x), f(c.power.y), f(c.power.z), 0, f(c.side.x), f(c.side.y), f(c.side.z), 0};
}
dvec3 taken(const Case& c)
{
    using namespace maths_double;
    const EyePointLanes eye{{c.x.x, c.x.y, c.x.z}, {c.normal.x, c.normal.y, c.normal.z}, {c.facing.x, c.facing.y, c.facing.z}, {c.throughput.x, c.throughput.y, c.throughput.z}};
    const Photon photon = photon_of<Photon>(c);
    const real3 r = gather_at_point(eye, photon, meet_point(eye, photon));
    return {r.x, r.y, r.z};
}
dvec3 taken_in_float(const Case& c)
{
    using namespace maths_float;
    const auto v = [](const dvec3& x) { return real3{float(x.x), float(x.y), float(x.z)}; };
    const EyePointLanes eye{v(c.x), v(c.normal), v(c.facing), v(c.throughput)};
    const Photon photon = photon_of<Photon>(c);
    const real3 r = gather_at_point(eye, photon, meet_point(eye, photon));
    return {r.x, r.y, r.z};
}

/// Mean of what photons at all places of a square around the point leave, times its area: density(place) photons per area.
template <typename Density>
dvec3 of_all_places(Case c, int n, const Density& density)
{
    dvec3 sum(0);
    const double half = 1.1 * c.radius;
    const dvec3 middle = c.x;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const dvec3 offset(half * (2 * (i + .5) / n - 1), half * (2 * (j + .5) / n - 1), 0);
            c.at = middle + offset;
            sum += density(offset) * taken(c);
        }
    return sum * 4. * half * half / double(n) / double(n);
}

TEST(Photon, AnEvenRainGivesItsFlux)
{
    Case c{.direction = glm::normalize(dvec3(.5, -.3, -.8))};
    const dvec3 ours = of_all_places(c, 1000, [](const dvec3&) { return 1.; });
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(ours[i] / (c.power[i] * c.throughput[i]), 1, 1e-5);
    c.normal = glm::normalize(dvec3(.2, 0, 1));  // radiance is the flux over the true cosine; what the surface makes of it, times the cosine to the shading normal
    const double bent = glm::dot(-c.direction, c.normal) / glm::dot(-c.direction, c.facing);
    EXPECT_NEAR(of_all_places(c, 1000, [](const dvec3&) { return 1.; }).x / (c.power.x * c.throughput.x), bent, 1e-5);
    c.power.x *= 1.001;
    EXPECT_GT(std::abs(of_all_places(c, 1000, [](const dvec3&) { return 1.; }).x / (Case{}.power.x * c.throughput.x) / bent - 1), 1e-4) << "a planted error is not seen";
}

TEST(Photon, GivesNothingBeyondItsRadiusNorToTheOtherSide)
{
    Case c;
    c.at = {.0999, 0, 0};
    EXPECT_GT(taken(c).x, 0);
    c.at = {.1001, 0, 0};
    EXPECT_EQ(taken(c).x, 0);
    c.at = {}, c.side = {0, 0, -1}, c.direction = {0, 0, 1};
    EXPECT_EQ(taken(c).x, 0) << "it fell on the back of the sheet";
    c.side = {0, 0, 1};
    EXPECT_EQ(taken(c).x, 0) << "it comes from behind";
    c.direction = {1, 0, 0};
    EXPECT_EQ(taken(c).x, 0) << "it grazes: no cosine, and nothing divided by it";
    c.direction = glm::normalize(dvec3(1, 0, -1e-3)), c.normal = glm::normalize(dvec3(1, 0, .5));
    EXPECT_EQ(taken(c).x, 0) << "it comes from behind the shading normal";
}

TEST(Photon, FloatAgreesWithDoubleAndHardCasesAreFinite)
{
    std::mt19937 engine(31);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto rounded = [](double x) {
        volatile float kept = static_cast<float>(x);  // GCC 12 turns double to float to double, three at a time, into nothing
        return static_cast<double>(kept);
    };
    const auto f = [&](const dvec3& x) { return dvec3(rounded(x.x), rounded(x.y), rounded(x.z)); };
    for (int i = 0; i < 100000; ++i) {
        Case c{.radius = static_cast<float>(std::pow(10, -1 - 2.5 * (uniform(engine) + 1)))};
        c.x = f({uniform(engine), uniform(engine), uniform(engine)}), c.at = f(c.x + .7 * c.radius * dvec3(uniform(engine), uniform(engine), 0));
        c.direction = f(glm::normalize(dvec3(uniform(engine), uniform(engine), -1.1 - uniform(engine))));
        const dvec3 single = taken_in_float(c), exact = taken(c);
        ASSERT_TRUE(std::isfinite(single.x + single.y + single.z)) << i;
        // Positions are floats: their difference is exact or one rounding; near the edge 1 - x^2 / r^2 cancels to its rounding.
        const double scale = c.power.x * c.throughput.x * 2 / M_PI / (c.radius * c.radius);
        ASSERT_NEAR(single.x, exact.x, 4e-6 * scale) << i << " radius " << c.radius;
    }
}

TEST(Photon, BiasFallsWithTheSquareOfTheRadius)
{
    std::vector<double> biases;
    for (const double radius : {.4, .2, .1}) {
        Case c{.radius = radius};
        biases.push_back(of_all_places(c, 800, [](const dvec3& x) { return std::exp(-.5 * (x.x * x.x + x.y * x.y)); }).x / (c.power.x * c.throughput.x) - 1);
        EXPECT_NEAR(biases.back() / (-radius * radius / 6), 1, .02 + .2 * radius * radius) << radius;  // half the second moment, r^2 / 3, times the second derivative
    }
    EXPECT_NEAR(std::log2(biases[0] / biases[2]) / 2, 2, .04);
}

TEST(ProgressiveRadius, OfTwoDimensionsIsTheProductOfItsSteps)
{
    double square = .09;
    for (std::uint64_t pass = 0; pass < 2000; ++pass) {
        EXPECT_NEAR(std::pow(progressive_radius(.3, pass, 2), 2) / square, 1, 1e-11) << pass;
        square *= (double(pass) + 1 + 2. / 3) / (double(pass) + 2);
    }
}

}  // namespace
}  // namespace tyndall
