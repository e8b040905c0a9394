// The tabulated marginal and the values that the tables follow: normalised, drawn from (chi^2), inverted, bounded below, finite in float, and what they claim to
// be by textbook formulas that share no code with the kernels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "kernels/dialect_host.hpp"
#include "tests/support/chi_square.hpp"
#include "tests/support/quadrature.hpp"

namespace tyndall::test {
namespace {

namespace twice = maths_double;
namespace single = maths_float;

struct TwoSegments {
    twice::real3 q, a, b;
    double light_length, eye_length, g_eye, g_light, sigma;
};

twice::real3 direction(std::mt19937& engine)
{
    std::normal_distribution<double> normal;
    const double x = normal(engine), y = normal(engine), z = normal(engine), n = std::sqrt(x * x + y * y + z * z);
    return {x / n, y / n, z / n};
}

/// Random; one in four nearly parallel, one in four nearly touching, some infinite, some without length.
TwoSegments random_segments(std::mt19937& engine)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    TwoSegments s{{uniform(engine), uniform(engine), uniform(engine)}, direction(engine), direction(engine), std::exp(3 * uniform(engine)), std::exp(3 * uniform(engine)), 0, 0, 0};
    const double sharpness[] = {0, .3, .55, .9, .99, .9999, -.7, -.999}, extinction[] = {0, .1, 1, 10, 1000};
    s.g_eye = sharpness[engine() % 8], s.g_light = sharpness[engine() % 8], s.sigma = extinction[engine() % 5];
    const double wiggle = std::pow(10, -1 - 6 * std::abs(uniform(engine)));
    if (engine() % 4 == 0) s.b = {s.a.x + wiggle, s.a.y, s.a.z - wiggle};
    const double n = std::sqrt(twice::dot3(s.b, s.b));
    s.b = {s.b.x / n, s.b.y / n, s.b.z / n};
    if (engine() % 4 == 0) {  // the light passes within `wiggle` of a point of the eye segment
        const double u = .4 * s.eye_length, v = .3 * s.light_length;
        s.q = {u * s.a.x - v * s.b.x + wiggle, u * s.a.y - v * s.b.y, u * s.a.z - v * s.b.z};
    }
    if (engine() % 16 == 0 && s.sigma > 0) s.eye_length = INFINITY;
    return s;
}

twice::GuideMedia media(const TwoSegments& s) { return {s.g_eye, s.g_light, s.sigma, s.sigma, s.sigma}; }
twice::RodSample sample(const TwoSegments& s, twice::TableShape shape, double xi) { return twice::sample_rod_table(s.q, s.a, s.b, s.light_length, s.eye_length, media(s), shape, xi); }
twice::RodTable table(const TwoSegments& s, twice::TableShape shape)
{
    const twice::RodFrame f = twice::rod_frame(s.q, s.a, s.b, s.light_length);
    return twice::rod_table(f, twice::rod_whole(f), twice::rod_view(f, s.q, s.a, s.b, s.eye_length, media(s)), shape);
}

struct Shape {
    const char* name;
    int nodes, angles, lobes;
};
void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }
const Shape shapes[] = {{"EightBySix", 8, 6, 1}, {"FourByFour", 4, 4, 1}, {"ThreeByTwo", 3, 2, 1}, {"ThreeByTwoWithoutLobes", 3, 2, 0}};
class RodTable : public testing::TestWithParam<Shape> {
protected:
    static twice::TableShape in_double() { return {GetParam().nodes, GetParam().angles, GetParam().lobes}; }
    static single::TableShape in_float() { return {GetParam().nodes, GetParam().angles, GetParam().lobes}; }
};
INSTANTIATE_TEST_SUITE_P(Of, RodTable, testing::ValuesIn(shapes), [](const auto& shape) { return std::string(shape.param.name); });

TEST_P(RodTable, DensityIntegratesToOneAndIsBoundedBelowAtAThousandPairs)
{
    std::mt19937 engine(31);
    for (int i = 0; i < 1000; ++i) {
        const TwoSegments s = random_segments(engine);
        const twice::RodTable t = table(s, in_double());
        double integral = 0;
        for (int k = 0; k + 1 < GetParam().nodes; ++k) integral += twice::place_in_rod_table(t, in_double(), (k + .5) / (GetParam().nodes - 1)).density / (GetParam().nodes - 1);
        ASSERT_NEAR(integral, 1, 1e-12) << "pair " << i;
        for (double x = 0; x <= 1; x += 1. / 64) ASSERT_GE(twice::place_in_rod_table(t, in_double(), x).density, .1 - 1e-12) << "pair " << i;
    }
}

TEST_P(RodTable, DrawsFollowTheDensityAtAThousandPairs)
{
    std::mt19937 engine(32);
    std::uniform_real_distribution<double> uniform;
    constexpr int bins = 24, draws = 3000, points = 48;
    int rejected = 0;
    for (int i = 0; i < 1000; ++i) {
        const TwoSegments s = random_segments(engine);
        const twice::RodTable t = table(s, in_double());
        std::vector<double> observed(bins, 0), expected(bins, 0);
        for (int k = 0; k < draws; ++k) observed[std::min(int(twice::warp_rod_table(t, in_double(), uniform(engine)).x * bins), bins - 1)] += 1;
        for (int bin = 0; bin < bins; ++bin)
            for (int k = 0; k < points; ++k) expected[bin] += twice::place_in_rod_table(t, in_double(), (bin + (k + .5) / points) / bins).density * draws / (double(points) * bins);
        // z of 1000 chi^2 beyond 4.5 (Wilson and Hilferty): one false alarm in 300 runs of fresh numbers; the seed is fixed. Every cell expects at least 12 draws.
        double statistic = 0, degrees = bins - 1;
        for (int bin = 0; bin < bins; ++bin) statistic += (observed[bin] - expected[bin]) * (observed[bin] - expected[bin]) / expected[bin];
        rejected += (std::cbrt(statistic / degrees) - (1 - 2 / (9 * degrees))) / std::sqrt(2 / (9 * degrees)) > 4.5;
    }
    EXPECT_EQ(rejected, 0);
}

TEST_P(RodTable, SampleCarriesItsDensityAndInvertUndoesIt)
{
    std::mt19937 engine(33);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < 2000; ++i) {
        const TwoSegments s = random_segments(engine);
        const double xi = uniform(engine);
        const twice::RodSample rod = sample(s, in_double(), xi);
        ASSERT_TRUE(rod.v >= 0 && rod.v <= s.light_length) << "pair " << i;
        // v is known to some 30 epsilon of the light's length (kernels/math/rod.h): pairs that nearly touch magnify that by the length over their distance.
        const twice::RodFrame f = twice::rod_frame(s.q, s.a, s.b, s.light_length);
        const double magnified = 1e-14 * s.light_length * rod.potential / (twice::rod_distance(f, rod.v / f.scale) * f.scale);
        const double D = twice::rod_distance(f, rod.v / f.scale) * f.scale;
        ASSERT_NEAR(rod.potential * D * twice::pdf_rod_table(s.q, s.a, s.b, s.light_length, s.eye_length, media(s), in_double(), rod.v), 1, 1e-9 + 1e3 * magnified) << "pair " << i;
        ASSERT_NEAR(twice::invert_rod_table(s.q, s.a, s.b, s.light_length, s.eye_length, media(s), in_double(), rod.v), xi, 1e-9 + 1e3 * magnified) << "pair " << i;
    }
}

TEST_P(RodTable, IsFiniteInFloatAtEveryPairAndNumber)
{
    std::mt19937 engine(34);
    for (int i = 0; i < 20000; ++i) {
        TwoSegments s = random_segments(engine);
        if (i % 8 == 0) s.b = s.a;                                   // parallel
        if (i % 24 == 0) s.q = {s.a.x, s.a.y, s.a.z};                // on one line
        if (i % 10 == 0) s.q = {0, 0, 0};                            // starts at the eye
        if (i % 30 == 0) s.light_length = 0;
        if (i % 50 == 0) s.eye_length = 0;
        const auto rounded = [](const twice::real3& v) { return single::real3{float(v.x), float(v.y), float(v.z)}; };
        const float sigma = float(s.sigma);
        for (const float xi : {0.0f, .3f, 0x1.fffffep-1f}) {
            const single::RodSample rod = single::sample_rod_table(rounded(s.q), rounded(s.a), rounded(s.b), float(s.light_length), float(s.eye_length),
                                                                   {float(s.g_eye), float(s.g_light), sigma, sigma, sigma}, in_float(), xi);
            ASSERT_TRUE(std::isfinite(rod.potential) && rod.potential >= 0) << "pair " << i << " xi " << xi;
            ASSERT_TRUE(rod.v >= 0 && rod.v <= float(s.light_length)) << "pair " << i << " xi " << xi;
        }
    }
}

/// Henyey and Greenstein's product times exp(-sigma (v + u + w)) by points in space, up to (1 - g^2)^2 / (4 pi)^2.
double textbook(const TwoSegments& s, double v, double u)
{
    const double d[3] = {u * s.a.x - s.q.x - v * s.b.x, u * s.a.y - s.q.y - v * s.b.y, u * s.a.z - s.q.z - v * s.b.z};  // light to eye
    const double w = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double light = (d[0] * s.b.x + d[1] * s.b.y + d[2] * s.b.z) / w, eye = -(d[0] * s.a.x + d[1] * s.a.y + d[2] * s.a.z) / w;
    const auto lobe = [](double mu, double g) { return std::pow(1 + g * g - 2 * g * mu, -1.5); };
    return lobe(light, s.g_light) * lobe(eye, s.g_eye) * std::exp(-s.sigma * (v + u + w));
}

/// Where on the segment the share x of the angle ends, by the arc tangent.
double at_angle(const TwoSegments& s, double v, double x)
{
    const double p[3] = {s.q.x + v * s.b.x, s.q.y + v * s.b.y, s.q.z + v * s.b.z}, foot = p[0] * s.a.x + p[1] * s.a.y + p[2] * s.a.z;
    const double D = std::sqrt(std::max(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - foot * foot, 0.)), low = std::atan2(-foot, D), high = std::atan2(s.eye_length - foot, D);
    return foot + D * std::tan(low + x * (high - low));
}

/// Pairs without extremes, for comparisons with formulas that suffer from these.
TwoSegments plain_segments(std::mt19937& engine)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    TwoSegments s{{uniform(engine), uniform(engine), uniform(engine)}, direction(engine), direction(engine), 1 + .5 * uniform(engine), 1 + .5 * uniform(engine), .7 * uniform(engine),
                  .7 * uniform(engine), 1 + uniform(engine)};
    return s;
}

TEST(GuideValues, AreTheProductOfPhaseFunctionsAndTransmittance)
{
    std::mt19937 engine(35);
    for (int i = 0; i < 300; ++i) {
        const TwoSegments s = plain_segments(engine);
        const double v = .37 * s.light_length;
        const twice::WarpShape shape{6, 1, 1};
        const twice::PhaseFan fan = twice::phase_fan({s.q.x + v * s.b.x, s.q.y + v * s.b.y, s.q.z + v * s.b.z}, s.a, s.eye_length, s.b, media(s), shape);
        for (const double x : {.05, .3, .8, .97})
            ASSERT_NEAR(twice::fan_value(fan, shape, twice::fan_direction(fan, x)) * std::exp(-s.sigma * v) / textbook(s, v, at_angle(s, v, x)), 1, 1e-8) << "pair " << i << " x " << x;
    }
}

TEST(GuideValues, NodesAreTheMidPointRuleOfTheIntegralOverTheAngle)
{
    std::mt19937 engine(36);
    for (int i = 0; i < 300; ++i) {
        const TwoSegments s = plain_segments(engine);
        constexpr int angles = 6;
        const twice::TableShape shape{8, angles, 1};
        const twice::RodTable t = table(s, shape);
        double nodes[8], mean = 0;
        for (int k = 0; k < 8; ++k) {
            const double v = twice::sample_rod(s.q, s.a, s.b, s.light_length, k / 7.).v, D = 1e-300 + std::abs(v);
            const double p[3] = {s.q.x + v * s.b.x, s.q.y + v * s.b.y, s.q.z + v * s.b.z}, foot = p[0] * s.a.x + p[1] * s.a.y + p[2] * s.a.z;
            const double away = std::sqrt(std::max(p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - foot * foot, 0.));
            nodes[k] = 0;
            for (int j = 0; j < angles; ++j) nodes[k] += textbook(s, v, at_angle(s, v, (j + .5) / angles)) / angles * (std::atan2(s.eye_length - foot, away) - std::atan2(-foot, away));
            mean += nodes[k] / 7 * (k == 0 || k == 7 ? .5 : 1);
            ASSERT_GT(D, 0);
        }
        for (int k = 0; k < 8; ++k) ASSERT_NEAR(twice::place_in_rod_table(t, shape, k / 7.).density, .1 + .9 * nodes[k] / mean, 1e-6) << "pair " << i << " node " << k;
    }
}

}  // namespace
}  // namespace tyndall::test
