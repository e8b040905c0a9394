#include "transport/phase_function.hpp"

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
