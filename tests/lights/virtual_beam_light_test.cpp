/// The light contract for virtual beam lights: transport equals quadrature that shares no code with kernels/, also where beam and eye segment cross; float agrees with double;
/// and what thickness does to a field of light is what section 18 of kernels/README.md predicts, radius by radius.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "lights/progressive_radius.hpp"
#include "tests/lights/host_maths.hpp"

namespace tyndall {
static float tested_radius = .5f;
namespace maths_float {
#include "kernels/lights/virtual_beam_light.h"
}
#undef VIRTUAL_BEAM_LIGHT_H
namespace maths_double {
#include "kernels/lights/virtual_beam_light.h"
}

/// The pair's ray, tested_radius thick.
template <typename Light>
Light light_of(const plain::Pair& p)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    return {{f(p.p.x), f(p.p.y), f(p.p.z), f(p.light_length), f(p.b.x), f(p.b.y), f(p.b.z), 0, f(p.flux.x), f(p.flux.y), f(p.flux.z), 0,
             f(p.share.x), f(p.share.y), f(p.share.z), p.is_short ? 1u : 0u},
            tested_radius, 0, 0, 0};
}

}  // namespace tyndall

#include "tests/lights/both_precisions.hpp"
#include "tests/lights/found_places.hpp"

namespace tyndall {
namespace {

/// What takes the place of 1 / w^2.
double geometry(double w) { return w < tested_radius ? (9 - 8 * w / tested_radius) / (double(tested_radius) * tested_radius) : 1 / (w * w); }

/// A pair whose segments cross at a random place of both.
Pair crossing_pair(std::mt19937& engine, double g)
{
    std::uniform_real_distribution<double> inside(.2, .8);
    Pair p = plain::random_pair(engine, g, false);
    p.p = p.o + inside(engine) * p.eye_length * p.a - inside(engine) * p.light_length * p.b;
    return p;
}

class BeamLight : public testing::TestWithParam<int> {
protected:
    void SetUp() override { tested_sampler = GetParam(); }
    void TearDown() override { tested_sampler = SAMPLER_PAPER_ISOTROPIC, tested_radius = .5f; }
};
INSTANTIATE_TEST_SUITE_P(VirtualBeamLight, BeamLight, testing::Values(SAMPLER_PAPER_ISOTROPIC, SAMPLER_PAPER, SAMPLER_TABLE_3X2));

TEST_P(BeamLight, TransportToASegmentEqualsQuadrature)
{
    std::mt19937 engine(11);
    for (const double g : {0.0, .55, -.7})
        for (int i = 0; i < 4; ++i) {
            const Pair p = plain::random_pair(engine, g, i % 2);
            // The kink at the radius costs both rules some accuracy.
            expect_near(mean_over_segment(p, 256), plain::transport(p, geometry), 2e-3, "g " + std::to_string(g) + " pair " + std::to_string(i));
        }
}

TEST_P(BeamLight, TransportAcrossASegmentEqualsQuadrature)
{
    std::mt19937 engine(12);
    for (int i = 0; i < 4; ++i) {
        const Pair p = crossing_pair(engine, 0);
        expect_near(mean_over_segment(p, 400), plain::transport(p, geometry), 5e-3, "pair " + std::to_string(i));  // a cone at the crossing, whose tip both rules cut off
    }
}

TEST_P(BeamLight, FloatAgreesWithDouble)
{
    std::mt19937 engine(13);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<double> errors;
    for (int i = 0; i < 3000; ++i) {
        const Pair p = plain::as_float(plain::random_pair(engine, i % 2 ? .55 : 0, i % 3 == 0));
        const float xi0 = uniform(engine), xi1 = uniform(engine);
        const glm::dvec3 f = Float::segment(p, xi0, xi1), d = Double::segment(p, xi0, xi1);
        ASSERT_TRUE(std::isfinite(f.x + f.y + f.z)) << "pair " << i;
        errors.push_back(glm::length(f - d) / glm::length(d));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() / 2], 5e-6);
    EXPECT_LT(errors.back(), 2e-3);  // as for rays
}

TEST(VirtualBeamLight, TransportToASurfaceEqualsQuadratureAndIsBoundedAtContact)
{
    std::mt19937 engine(14);
    for (const double g : {0.0, .55})
        for (int i = 0; i < 8; ++i) {
            const SurfacePair s = plain::random_surface_pair(engine, g, i % 2);
            glm::dvec3 sum(0);
            const int n = 4096;
            for (int k = 0; k < n; ++k) sum += Double::point(s, (k + .5) / n);
            expect_near(sum / double(n), plain::transport(s, geometry), 1e-3, "g " + std::to_string(g) + " pair " + std::to_string(i));
        }
    SurfacePair s = plain::random_surface_pair(engine, 0, false);
    s.light.sigma_t = {}, s.light.b = {1, 0, 0}, s.n = {0, 0, 1};
    for (const double h : {1e-2, 1e-4, 1e-6, 1e-8}) {
        s.light.p = s.x + glm::dvec3(-.5 * s.light.light_length, 0, h);
        for (const double xi : {.02, .3, .5, .9}) EXPECT_LE(Double::point(s, xi).x, s.light.flux.x * s.light.sigma_s.x * 9 / (tested_radius * tested_radius) * s.light.light_length) << h;
    }
}

TEST(VirtualBeamLight, APlantedErrorOfTheToleranceIsSeen)
{
    std::mt19937 engine(11);
    const Pair p = crossing_pair(engine, 0);
    const double right = plain::transport(p, geometry).x;
    tested_radius = .505f;
    EXPECT_GT(std::abs(mean_over_segment(p, 400).x / right - 1), 5e-3);
    tested_radius = .5f;
}

TEST(VirtualBeamLight, IsTheRayBeyondItsRadius)
{
    std::mt19937 engine(15);
    tested_radius = .1f;  // pairs are .15 apart
    for (int i = 0; i < 4; ++i) {
        const Pair p = plain::random_pair(engine, .3, false);
        expect_near(mean_over_segment(p, 64), mean_over_segment(p, 64), 0, "");
        expect_near(mean_over_segment(p, 192), plain::transport(p), 5e-4, "pair " + std::to_string(i));
    }
    tested_radius = .5f;
}

/// Bias of an even field of beams, whose places lie uniformly in space: per direction it is the integral of (k - 1) e^(-sigma w) over w < r, in closed form. Returns mean and its error.
struct Measured { double value, error, predicted; };
constexpr double beam_length = .2, seen_length = .5;

Measured bias_at(double radius, unsigned seed)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::normal_distribution<double> normal;
    const double sigma = 1, length = beam_length, eye_length = seen_length, margin = radius + length;
    const glm::dvec3 low(-margin, -margin, -margin), size(eye_length + 2 * margin, 2 * margin, 2 * margin);
    Pair p{.o = {}, .a = {1, 0, 0}, .p = {}, .b = {}, .eye_length = eye_length, .light_length = length, .g = 0, .sigma_t = glm::dvec3(sigma), .sigma_s = glm::dvec3(1), .flux = glm::dvec3(1),
           .share = {.25, .25, .5}, .is_short = true};
    const int count = 2000000;
    double sum = 0, squares = 0;
    for (int i = 0; i < count; ++i) {
        p.p = low + size * glm::dvec3(uniform(engine), uniform(engine), uniform(engine)), p.b = glm::normalize(glm::dvec3(normal(engine), normal(engine), normal(engine)));
        const double xi0 = uniform(engine), xi1 = uniform(engine);
        tested_radius = static_cast<float>(radius);
        const double thick = Double::segment(p, xi0, xi1).x;
        tested_radius = 1e-12f;
        const double x = thick - Double::segment(p, xi0, xi1).x;
        sum += x, squares += x * x;
    }
    tested_radius = .5f;
    const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count), four_pi = 16 * std::atan(1.);
    double radial = 0;
    for (int i = 0; i < 20000; ++i) {
        const double x = (i + .5) / 20000;
        radial += (x * x * (9 - 8 * x) - 1) * std::exp(-sigma * x * radius) * radius / 20000;
    }
    return {mean, error, length / (size.x * size.y * size.z) * (1 - std::exp(-sigma * eye_length)) / sigma / four_pi * radial};
}

/// Slope of log y against log x with weights; error: one standard error of it.
struct Slope { double value, error; };
Slope slope_of(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& weights)
{
    double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double a = std::log(x[i]), b = std::log(y[i]);
        w += weights[i], wx += weights[i] * a, wy += weights[i] * b, wxx += weights[i] * a * a, wxy += weights[i] * a * b;
    }
    return {(w * wxy - wx * wy) / (w * wxx - wx * wx), std::sqrt(w / (w * wxx - wx * wx))};
}

TEST(VirtualBeamLight, BiasFallsWithTheSquareOfTheRadius)
{
    const std::vector<double> radii{.8, .4, .2, .1};
    std::vector<double> measured, predicted, weights;
    for (const double radius : radii) {
        const Measured m = bias_at(radius, 50);
        EXPECT_NEAR(m.value, m.predicted, 5 * m.error) << "radius " << radius;
        EXPECT_LT(m.error, .3 * std::abs(m.predicted)) << "too weak at radius " << radius;
        const double margin = radius + beam_length, volume = (seen_length + 2 * margin) * 4 * margin * margin;  // of beams with an equal density
        measured.push_back(-m.value * volume), predicted.push_back(-m.predicted * volume), weights.push_back(std::pow(m.value / m.error, 2));
    }
    const Slope slope = slope_of(radii, measured, weights), expected = slope_of(radii, predicted, weights);
    RecordProperty("slope", std::to_string(slope.value) + " +- " + std::to_string(slope.error));
    std::printf("bias falls as radius^%.3f +- %.3f (one standard error), by eq. 63 as radius^%.3f over these radii\n", slope.value, slope.error, expected.value);
    EXPECT_NEAR(slope.value, expected.value, 4 * slope.error);
    EXPECT_LT(slope.error, .1);
    EXPECT_NEAR(std::log2(predicted[2] / predicted[3]), 2, .15) << "the prediction itself: 2 but for its cubic term, which is .44 sigma r of the square";
}

TEST(ProgressiveRadius, IsTheProductOfItsSteps)
{
    double radius = .3;
    for (std::uint64_t pass = 0; pass < 2000; ++pass) {
        EXPECT_NEAR(progressive_radius(.3, pass) / radius, 1, 1e-11) << pass;
        radius *= (double(pass) + 1 + 2. / 3) / (double(pass) + 2);
    }
}

TEST_P(BeamLight, PlacesThatAreFoundWeighAsTheyDoWhenDrawn) { expect_found_places_to_weigh_as_drawn(61, 1e-6); }

TEST(VirtualBeamLight, PlacesThatAreFoundWeighAsTheyDoWhenDrawn)
{
    expect_found_places_to_weigh_as_drawn(62, 1e-9);
    expect_found_places_seen_from_points_to_weigh_as_drawn(63);
}

TEST(VirtualBeamLight, IsTheLineOfItsRecord) { expect_the_line_of_the_record(64); }

}  // namespace
}  // namespace tyndall
