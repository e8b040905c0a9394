// The product conditional: its density is normalised, draws follow it (chi^2), float agrees with double, lobes are found, and what it is worth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "kernels/dialect_host.hpp"
#include "tests/support/chi_square.hpp"

namespace tyndall::test {
namespace {

namespace twice = maths_double;
namespace single = maths_float;

struct Geometry {
    twice::real3 p, a, b;
    double length, g_eye, g_light;
};

twice::real3 direction(std::mt19937& engine)
{
    std::normal_distribution<double> normal;
    const double x = normal(engine), y = normal(engine), z = normal(engine), n = std::sqrt(x * x + y * y + z * z);
    return {x / n, y / n, z / n};
}

/// Random, with near-parallel directions and points that almost touch the segment among them.
Geometry random_geometry(std::mt19937& engine)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    Geometry g{{uniform(engine), uniform(engine), uniform(engine)}, direction(engine), direction(engine), std::exp(3 * uniform(engine)), 0, 0};
    const double sharpness[] = {0, .3, .55, .9, .99, .999, -.7, -.999};
    g.g_eye = sharpness[engine() % 8], g.g_light = sharpness[engine() % 8];
    const double wiggle = std::pow(10, -1 - 6 * std::abs(uniform(engine)));
    if (engine() % 4 == 0) g.b = {g.a.x + wiggle, g.a.y, g.a.z - wiggle};
    if (engine() % 4 == 0) g.p = {.3 * g.a.x * g.length + wiggle, .3 * g.a.y * g.length, .3 * g.a.z * g.length};
    const double n = std::sqrt(twice::dot3(g.b, g.b));
    g.b = {g.b.x / n, g.b.y / n, g.b.z / n};
    return g;
}

twice::PhaseWarp sample(const Geometry& g, double xi) { return twice::sample_phase_product(g.p, g.a, g.length, g.b, g.g_eye, g.g_light, xi); }
double pdf(const Geometry& g, double x) { return twice::pdf_phase_product(g.p, g.a, g.length, g.b, g.g_eye, g.g_light, x); }

TEST(PhaseProduct, DensityIntegratesToOneAtAThousandGeometries)
{
    std::mt19937 engine(3);
    for (int i = 0; i < 1000; ++i) {
        const Geometry g = random_geometry(engine);
        // Piecewise linear: exact between the vertices, so integrate from vertex to vertex.
        const twice::PhaseFan fan = twice::phase_fan(g.p, g.a, g.length, g.b, g.g_eye, g.g_light);
        const twice::PhaseTable table = twice::phase_table(fan);
        double integral = 0;
        for (int j = 0; j + 1 < PHASE_VERTICES; ++j) {
            const double x0 = (table.angle[j] - fan.start) / fan.extent, x1 = (table.angle[j + 1] - fan.start) / fan.extent;
            integral += (x1 - x0) * pdf(g, .5 * (x0 + x1));
        }
        ASSERT_NEAR(integral, 1, 1e-6) << "geometry " << i << " g " << g.g_eye << ' ' << g.g_light;
    }
}

TEST(PhaseProduct, DrawsFollowTheDensityAtAThousandGeometries)
{
    std::mt19937 engine(4);
    std::uniform_real_distribution<double> uniform;
    constexpr int bins = 24, draws = 4000;
    int rejected = 0;
    for (int i = 0; i < 1000; ++i) {
        const Geometry g = random_geometry(engine);
        std::vector<double> observed(bins, 0), expected(bins, 0);
        for (int k = 0; k < draws; ++k) observed[std::min(int(sample(g, uniform(engine)).x * bins), bins - 1)] += 1;
        for (int b = 0; b < bins; ++b)
            for (int k = 0; k < 400; ++k) expected[b] += pdf(g, (b + (k + .5) / 400) / bins) * draws / (400.0 * bins);
        double statistic = 0, degrees = -1, pooled_observed = 0, pooled_expected = 0;
        for (int b = 0; b < bins; ++b) {
            pooled_observed += observed[b], pooled_expected += expected[b];
            if (pooled_expected < 8) continue;
            statistic += (pooled_observed - pooled_expected) * (pooled_observed - pooled_expected) / pooled_expected;
            degrees += 1, pooled_observed = pooled_expected = 0;
        }
        // Wilson-Hilferty: z of a chi^2; 1000 tests at z = 4.5 raise one false alarm in 300 runs of fresh numbers (the seed is fixed).
        const double z = (std::cbrt(statistic / degrees) - (1 - 2 / (9 * degrees))) / std::sqrt(2 / (9 * degrees));
        rejected += degrees >= 3 && z > 4.5;
    }
    EXPECT_EQ(rejected, 0);
}

TEST(PhaseProduct, DensityIsTheOneOfTheDrawAndBoundedBelow)
{
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < 20000; ++i) {
        const Geometry g = random_geometry(engine);
        const twice::PhaseWarp w = sample(g, uniform(engine));
        ASSERT_GE(w.x, 0);
        ASSERT_LE(w.x, 1);
        ASSERT_NEAR(w.density / pdf(g, w.x), 1, 1e-9);
        ASSERT_GE(w.density, .0999999) << "the defensive share bounds every weight by 10 times the equi-angular one";
        const single::PhaseWarp f = single::sample_phase_product({float(g.p.x), float(g.p.y), float(g.p.z)}, {float(g.a.x), float(g.a.y), float(g.a.z)}, float(g.length),
                                                                 {float(g.b.x), float(g.b.y), float(g.b.z)}, float(g.g_eye), float(g.g_light), float(uniform(engine)));
        ASSERT_TRUE(std::isfinite(f.x) && std::isfinite(f.density));
        ASSERT_TRUE(f.x >= 0 && f.x <= 1 && f.density >= .0999f);
    }
}

TEST(PhaseProduct, EndsOfTheNumbersStayInside)
{
    std::mt19937 engine(6);
    for (int i = 0; i < 4000; ++i) {
        const Geometry g = random_geometry(engine);
        for (const float xi : {0.0f, 0.0999999f, 0.1f, 0x1.fffffep-1f}) {
            const single::PhaseWarp f = single::sample_phase_product({float(g.p.x), float(g.p.y), float(g.p.z)}, {float(g.a.x), float(g.a.y), float(g.a.z)}, float(g.length),
                                                                     {float(g.b.x), float(g.b.y), float(g.b.z)}, float(g.g_eye), float(g.g_light), xi);
            ASSERT_TRUE(f.x >= 0 && f.x <= 1 && std::isfinite(f.density)) << xi;
        }
    }
}

/// Variance over squared mean of the estimate of the integral of f_eye f_light over the angle, with and without the product conditional.
std::pair<double, double> relative_variances(double g, int seed)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform;
    double with = 0, without = 0;
    constexpr int geometries = 200, draws = 400;
    for (int i = 0; i < geometries; ++i) {
        Geometry geometry{{uniform(engine) - .5, uniform(engine) - .5, uniform(engine) - .5}, direction(engine), direction(engine), 1, g, g};
        const twice::PhaseFan fan = twice::phase_fan(geometry.p, geometry.a, geometry.length, geometry.b, g, g);
        double sums[2] = {0, 0}, squares[2] = {0, 0};
        for (int k = 0; k < draws; ++k) {
            const twice::PhaseWarp w = sample(geometry, (k + uniform(engine)) / draws);
            const double product = twice::phase_product(fan, fan.start + w.x * fan.extent) / w.density;
            const double even = twice::phase_product(fan, fan.start + uniform(engine) * fan.extent);
            sums[0] += product, squares[0] += product * product, sums[1] += even, squares[1] += even * even;
        }
        with += squares[0] * draws / (sums[0] * sums[0]) - 1, without += squares[1] * draws / (sums[1] * sums[1]) - 1;
    }
    return {with / geometries, without / geometries};
}

TEST(PhaseProduct, HasLessVarianceThanTheEvenAngleWhereScatteringIsForward)
{
    for (const double g : {.55, .9}) {
        const auto [with, without] = relative_variances(g, 7);
        EXPECT_LT(with, .25 * without) << "g = " << g << ": " << with << " against " << without;
        EXPECT_LT(with, .2);
    }
}

}  // namespace
}  // namespace tyndall::test
