#include "transport/phase_function.hpp"

#include <functional>

#include "scene/phases.hpp"
#include "statistics.hpp"
#include "transport/frame.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

PhaseFunction hg(double g) { return {.type = PhaseFunction::Type::henyey_greenstein, .g = g}; }

class PhaseFunctionOf : public testing::TestWithParam<double> {};

/// Integral of weight(mu) x phase over the sphere; the peak at mu = +-1 is resolved in 1 - mu.
template <class Weight>
double integral(double g, const Weight& weight)
{
    const Vec3 in(0, 0, 1);
    const double sign = g < 0 ? -1 : 1;
    const auto f = [&](long double log_h) {
        const long double h = std::exp(log_h), mu = sign * (1 - h);  // spherical direction at 1 - |mu| = h, without rounding mu
        const double r = std::sqrt(double(h * (2 - h)));
        return h * weight(double(mu)) * evaluate_phase(hg(g), in, {r, 0, double(mu)}) * 2 * pi;
    };
    return double(integrate(f, std::log(1e-16L), std::log(2.0L), 1e-11L));
}

TEST_P(PhaseFunctionOf, IntegratesToOneWithMeanCosineG)
{
    const double g = GetParam();
    // below 1e-16 from the pole lies less than 1e-16 / (1 - |g|)^2; mu itself rounds at 1e-16 against (1 - |g|)^2
    const double rounding = 1e-10 + 1e-14 / ((1 - std::abs(g)) * (1 - std::abs(g)));
    EXPECT_NEAR(integral(g, [](double) { return 1.0; }), 1, rounding);
    EXPECT_NEAR(integral(g, [](double mu) { return mu; }), g, rounding);
}

TEST_P(PhaseFunctionOf, SamplesFollowIt)
{
    const PhaseFunction phase = hg(GetParam());
    const Vec3 in = glm::normalize(Vec3(1, -2, .5));
    RandomSequence random = numbers(1);
    const double p = direction_p(
        200000, [&] { return sample_phase(phase, in, random.next2()).direction; },
        [&](const Vec3& d) { return evaluate_phase(phase, in, d); });
    EXPECT_GT(p, false_alarm_rate);
}

TEST_P(PhaseFunctionOf, SampledDirectionsAreUnitHaveTheirPdfAndMeanCosineG)
{
    const PhaseFunction phase = hg(GetParam());
    const Vec3 in = glm::normalize(Vec3(1, -2, .5));
    RandomSequence random = numbers(2);
    Mean cosine;
    for (int i = 0; i < 50000; ++i) {
        const PhaseSample s = sample_phase(phase, in, random.next2());
        ASSERT_NEAR(glm::dot(s.direction, s.direction), 1, 1e-14);
        ASSERT_EQ(s.pdf, evaluate_phase(phase, in, s.direction));
        cosine.add(glm::dot(s.direction, in));
    }
    expect_mean(cosine, GetParam());
}

INSTANTIATE_TEST_SUITE_P(G, PhaseFunctionOf, testing::Values(-.99, -.5, -1e-9, 0., 1e-12, 1e-4, .3, .55, .9, .99));

// Hard case 14: the dot form loses its digits at the peak.
TEST(PhaseFunction, KeepsItsDigitsAtTheForwardPeak)
{
    for (const double g : {.99, .999, .9999, .999999}) {
        for (const double angle : {0., 1e-9, 1e-6, 1e-3, .1}) {
            const long double s = std::sin(.5L * angle), base = (1 - (long double)g) * (1 - (long double)g) + 4 * g * s * s;
            const long double exact =
                (1 - (long double)g) * (1 + (long double)g) / (4 * 3.14159265358979323846264L * base * std::sqrt(base));
            const Vec3 out(std::sin(angle), 0, std::cos(angle));
            EXPECT_NEAR(evaluate_phase(hg(g), {0, 0, 1}, out) / double(exact), 1, 1e-9) << g << ' ' << angle;
            EXPECT_NEAR(evaluate_phase(hg(-g), {0, 0, -1}, out) / double(exact), 1, 1e-9) << g << ' ' << angle;
        }
    }
}

TEST(PhaseFunction, EndsOfTheNumbersStayOnTheSphere)
{
    for (const double g : {-.999999, -.5, 0., .5, .999999})
        for (const double xi : {0., 0x1p-53, .5, 1 - 0x1p-53}) {
            const PhaseSample s = sample_phase(hg(g), {0, 0, 1}, {xi, xi});
            EXPECT_TRUE(std::isfinite(s.pdf) && s.pdf > 0) << g << ' ' << xi;
            EXPECT_NEAR(glm::length(s.direction), 1, 1e-12);
        }
}

TEST(PhaseFunction, IsotropicIsTheSameInAllDirections)
{
    RandomSequence random = numbers(3);
    const PhaseFunction phase;
    EXPECT_GT(direction_p(
                  100000,
                  [&] {
                      return sample_phase(phase, {0, 0, 1}, random.next2()).direction;
                  },
                  [](const Vec3&) { return 1 / (4 * pi); }),
              false_alarm_rate);
}

/// A phase function with its density over mu in closed form.
struct Shape {
    std::string name;
    PhaseFunction phase;
    std::function<double(double)> density;  ///< per unit of mu
    double mean;
};

double hg_density(double g, double mu) { return .5 * (1 - g * g) / std::pow(1 + g * g - 2 * g * mu, 1.5); }

/// A rising piece, a peak, an empty stretch, a plateau; trapezoids of width 1/2.
double table_density(double mu)
{
    constexpr double values[] = {0, 3, 0, 0, 2};
    const double x = 2 * (mu + 1);
    const int i = std::min(int(x), 3);
    return ((i + 1 - x) * values[i] + (x - i) * values[i + 1]) / 2;  // sum of the trapezoids: 2
}

std::vector<Shape> shapes()
{
    const PhaseFunction table = table_phase({0, 30, 0, 0, 20}), forward = henyey_greenstein_phase(.9), back = henyey_greenstein_phase(-.5);
    const double table_mean = (.5 * 3 * -.5 + .5 * .5 * 2 * (1 - .5 / 3)) / 2;
    return {{"Rayleigh", rayleigh_phase(), [](double mu) { return .375 * (1 + mu * mu); }, 0},
            {"Table", table, table_density, table_mean},
            {"Line", table_phase({1, 2}), [](double mu) { return (1.5 + .5 * mu) / 3; }, 1 / 9.},
            {"TwoLobes", blend_phase(.25, forward, back), [](double mu) { return .75 * hg_density(.9, mu) + .25 * hg_density(-.5, mu); }, .55},
            {"FourParts", blend_phase(.5, blend_phase(.25, rayleigh_phase(), table), blend_phase(.5, PhaseFunction{}, forward)),
             [](double mu) { return .375 * .375 * (1 + mu * mu) + .125 * table_density(mu) + .125 + .25 * hg_density(.9, mu); }, .125 * table_mean + .225}};
}

class ShapedPhase : public testing::TestWithParam<Shape> {};
INSTANTIATE_TEST_SUITE_P(Of, ShapedPhase, testing::ValuesIn(shapes()), [](const auto& info) { return info.param.name; });

TEST_P(ShapedPhase, IsItsClosedFormIntegratesToOneAndHasItsMeanCosine)
{
    const Shape& shape = GetParam();
    const Vec3 in = glm::normalize(Vec3(1, -2, .5));
    const Frame frame(in);
    const auto at = [&](double mu) { return evaluate_phase(shape.phase, in, frame.to_world(spherical(mu, .3))); };
    for (int i = 0; i <= 1000; ++i) {
        const double mu = -1 + .002 * i;
        EXPECT_NEAR(at(mu), shape.density(mu) / (2 * pi), 1e-12 * (1 + shape.density(mu))) << mu;
    }
    double whole = 0, moment = 0;
    for (int piece = 0; piece < 4; ++piece) {  // corners of the table lie at its ends
        const double from = -1 + .5 * piece;
        whole += double(integrate([&](long double mu) { return (long double)at(double(mu)) * 2 * pi; }, from, from + .5, 1e-12L, 30));
        moment += double(integrate([&](long double mu) { return mu * at(double(mu)) * 2 * pi; }, from, from + .5, 1e-12L, 30));
    }
    EXPECT_NEAR(whole, 1, 1e-9);
    EXPECT_NEAR(moment, shape.mean, 1e-9);
    EXPECT_NEAR(shape.phase.g, shape.mean, 1e-14);
}

TEST_P(ShapedPhase, SamplesFollowItAndHaveItsDensity)
{
    const Shape& shape = GetParam();
    const Vec3 in = glm::normalize(Vec3(1, -2, .5));
    RandomSequence random = numbers(6);
    constexpr int cells = 64, draws = 400000;
    std::vector<double> observed(cells, 0), expected(cells, 0), counts, masses;
    for (int i = 0; i < draws; ++i) {
        const PhaseSample s = sample_phase(shape.phase, in, random.next2());
        ASSERT_NEAR(glm::dot(s.direction, s.direction), 1, 1e-14);
        ASSERT_EQ(s.pdf, evaluate_phase(shape.phase, in, s.direction));
        ++observed[std::min(int(.5 * (glm::dot(in, s.direction) + 1) * cells), cells - 1)];
    }
    for (int c = 0; c < cells; ++c) {
        const double from = -1 + 2. * c / cells;
        expected[c] = draws * double(integrate([&](long double mu) { return (long double)shape.density(double(mu)); }, from, from + 2. / cells, 1e-12L, 30));
        if (expected[c] == 0) { EXPECT_EQ(observed[c], 0) << "cell " << c; }
        if (counts.empty() || masses.back() > 20) counts.push_back(0), masses.push_back(0);
        counts.back() += observed[c], masses.back() += expected[c];
    }
    EXPECT_GT(chi_square_p(counts, masses), false_alarm_rate);
    EXPECT_GT(direction_p(
                  100000, [&] { return sample_phase(shape.phase, in, random.next2()).direction; }, [&](const Vec3& d) { return evaluate_phase(shape.phase, in, d); }),
              false_alarm_rate);
}

TEST_P(ShapedPhase, SampledCosineIsTheInverseOfTheDistribution)
{
    const Shape& shape = GetParam();
    if (shape.phase.type == PhaseFunction::Type::blend) return;  // a part is chosen first
    for (const double xi : {0., 1e-12, .01, .2, .5, .50001, .77, .999, 1 - 0x1p-53}) {
        const double mu = sample_phase(shape.phase, {0, 0, 1}, {xi, .1}).direction.z;
        double below = 0;
        for (int piece = 0; piece < 4; ++piece) {
            const double from = -1 + .5 * piece, to = std::min(from + .5, mu);
            if (to > from) below += double(integrate([&](long double x) { return (long double)shape.density(double(x)); }, from, to, 1e-13L, 30));
        }
        EXPECT_NEAR(below, xi, 1e-12) << mu;
    }
}

// The textbook's Cardano form takes the difference of two cube roots, which agree at xi = 1/2.
TEST(PhaseFunction, RayleighsRootKeepsItsDigitsNearZero)
{
    for (const double offset : {1e-15, 1e-12, 1e-6, -1e-9}) {
        const double xi = .5 + offset, exact = 8 / 3. * (xi - .5);  // mu^3 + 3 mu = 8 xi - 4, mu^3 below rounding
        const double mu = sample_phase(rayleigh_phase(), {0, 0, 1}, {xi, 0}).direction.z;
        EXPECT_NEAR(mu / exact, 1, 1e-11) << offset;
    }
}

TEST(Frame, IsOrthonormalAndRightHandedEverywhere)
{
    RandomSequence random = numbers(4);
    for (int i = 0; i < 2000; ++i) {
        Vec3 n = sample_uniform_sphere(random.next2());
        if (i < 4) n = Vec3(0, 0, i % 2 ? -1 : 1);
        if (i == 2) n = Vec3(1, 0, -0.0);
        const Frame f(n);
        EXPECT_NEAR(glm::length(glm::cross(f.s, f.t) - f.n), 0, 1e-14);
        EXPECT_NEAR(glm::length(f.s), 1, 1e-14);
        EXPECT_NEAR(glm::length(f.to_world(f.to_local({.1, .2, .3})) - Vec3(.1, .2, .3)), 0, 1e-14);
    }
}

}  // namespace
