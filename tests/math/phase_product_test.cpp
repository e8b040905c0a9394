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
    double length, g_eye, g_light, sigma = 0;
};

/// How the samplers of kernels/shared/samplers.h shape their conditionals, with and without lobes.
struct Shape {
    const char* name;
    int vertices, lobes, absorbs;
};
void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }
const Shape shapes[] = {{"Ten", 10, 1, 0}, {"TenAbsorbing", 10, 1, 1}, {"SixAbsorbing", 6, 1, 1}, {"FourAbsorbing", 4, 1, 1}, {"SixWithoutLobes", 6, 0, 1}, {"FourWithoutLobes", 4, 0, 1}};
class PhaseProduct : public testing::TestWithParam<Shape> {
protected:
    static twice::WarpShape in_double() { return {GetParam().vertices, GetParam().lobes, GetParam().absorbs}; }
    static single::WarpShape in_float() { return {GetParam().vertices, GetParam().lobes, GetParam().absorbs}; }
};
INSTANTIATE_TEST_SUITE_P(Of, PhaseProduct, testing::ValuesIn(shapes), [](const auto& shape) { return std::string(shape.param.name); });
constexpr twice::WarpShape ten{10, 1, 0};

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
    const double extinctions[] = {0, .1, 1, 10, 1000};
    g.sigma = extinctions[engine() % 5];
    const double wiggle = std::pow(10, -1 - 6 * std::abs(uniform(engine)));
    if (engine() % 4 == 0) g.b = {g.a.x + wiggle, g.a.y, g.a.z - wiggle};
    if (engine() % 4 == 0) g.p = {.3 * g.a.x * g.length + wiggle, .3 * g.a.y * g.length, .3 * g.a.z * g.length};
    const double n = std::sqrt(twice::dot3(g.b, g.b));
    g.b = {g.b.x / n, g.b.y / n, g.b.z / n};
    return g;
}

twice::GuideMedia media(const Geometry& g) { return {g.g_eye, g.g_light, g.sigma, g.sigma, g.sigma}; }
twice::PhaseWarp sample(const Geometry& g, twice::WarpShape shape, double xi) { return twice::sample_phase_product(g.p, g.a, g.length, g.b, media(g), shape, xi); }
double pdf(const Geometry& g, twice::WarpShape shape, double x) { return twice::pdf_phase_product(g.p, g.a, g.length, g.b, media(g), shape, x); }
single::PhaseWarp sample_in_float(const Geometry& g, single::WarpShape shape, double xi)
{
    const auto rounded = [](const twice::real3& v) { return single::real3{float(v.x), float(v.y), float(v.z)}; };
    const float sigma = float(g.sigma);
    return single::sample_phase_product(rounded(g.p), rounded(g.a), float(g.length), rounded(g.b), {float(g.g_eye), float(g.g_light), sigma, sigma, sigma}, shape, float(xi));
}

TEST_P(PhaseProduct, DensityIntegratesToOneAtAThousandGeometries)
{
    std::mt19937 engine(3);
    for (int i = 0; i < 1000; ++i) {
        const Geometry g = random_geometry(engine);
        // Piecewise linear: exact between the vertices, so integrate from vertex to vertex.
        const twice::PhaseTable table = twice::phase_table(twice::phase_fan(g.p, g.a, g.length, g.b, media(g), in_double()), in_double());
        double integral = 0;
        for (int j = 0; j + 1 < GetParam().vertices; ++j) integral += (table.x[j + 1] - table.x[j]) * pdf(g, in_double(), .5 * (table.x[j] + table.x[j + 1]));
        ASSERT_NEAR(integral, 1, 1e-12) << "geometry " << i << " g " << g.g_eye << ' ' << g.g_light;
    }
}

TEST_P(PhaseProduct, DrawsFollowTheDensityAtAThousandGeometries)
{
    std::mt19937 engine(4);
    std::uniform_real_distribution<double> uniform;
    constexpr int bins = 24, draws = 4000;
    int rejected = 0;
    for (int i = 0; i < 1000; ++i) {
        const Geometry g = random_geometry(engine);
        const twice::PhaseTable table = twice::phase_table(twice::phase_fan(g.p, g.a, g.length, g.b, media(g), in_double()), in_double());
        std::vector<double> observed(bins, 0), expected(bins, 0);
        for (int k = 0; k < draws; ++k) observed[std::min(int(twice::warp_phase_table(table, in_double(), uniform(engine)).x * bins), bins - 1)] += 1;
        for (int b = 0; b < bins; ++b)
            for (int k = 0; k < 400; ++k) expected[b] += twice::table_density(table, in_double(), (b + (k + .5) / 400) / bins) * draws / (400.0 * bins);
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

TEST_P(PhaseProduct, DensityIsTheOneOfTheDrawAndBoundedBelow)
{
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < 20000; ++i) {
        const Geometry g = random_geometry(engine);
        const twice::PhaseWarp w = sample(g, in_double(), uniform(engine));
        ASSERT_GE(w.x, 0);
        ASSERT_LE(w.x, 1);
        ASSERT_NEAR(w.density / pdf(g, in_double(), w.x), 1, 1e-9);
        ASSERT_GE(w.density, .0999999) << "the defensive share bounds every weight by 10 times the equi-angular one";
        const single::PhaseWarp f = sample_in_float(g, in_float(), uniform(engine));
        ASSERT_TRUE(std::isfinite(f.x) && std::isfinite(f.density));
        ASSERT_TRUE(f.x >= 0 && f.x <= 1 && f.density >= .0999f);
    }
}

TEST_P(PhaseProduct, EndsOfTheNumbersStayInside)
{
    std::mt19937 engine(6);
    for (int i = 0; i < 4000; ++i) {
        const Geometry g = random_geometry(engine);
        for (const float xi : {0.0f, 0.0999999f, 0.1f, 0x1.fffffep-1f}) {
            const single::PhaseWarp f = sample_in_float(g, in_float(), xi);
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
        const twice::PhaseFan fan = twice::phase_fan(geometry.p, geometry.a, geometry.length, geometry.b, media(geometry), ten);
        const auto product_at = [&](double x) { return twice::fan_value(fan, ten, twice::fan_direction(fan, x)); };
        double sums[2] = {0, 0}, squares[2] = {0, 0};
        for (int k = 0; k < draws; ++k) {
            const twice::PhaseWarp w = sample(geometry, ten, (k + uniform(engine)) / draws);
            const double product = product_at(w.x) / w.density;
            const double even = product_at(uniform(engine));
            sums[0] += product, squares[0] += product * product, sums[1] += even, squares[1] += even * even;
        }
        with += squares[0] * draws / (sums[0] * sums[0]) - 1, without += squares[1] * draws / (sums[1] * sums[1]) - 1;
    }
    return {with / geometries, without / geometries};
}

TEST(PhaseProductVariance, IsLessThanOfTheEvenAngleWhereScatteringIsForward)
{
    for (const double g : {.55, .9}) {
        const auto [with, without] = relative_variances(g, 7);
        EXPECT_LT(with, .25 * without) << "g = " << g << ": " << with << " against " << without;
        EXPECT_LT(with, .2);
    }
}

}  // namespace
}  // namespace tyndall::test
