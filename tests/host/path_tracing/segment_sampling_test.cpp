#include "path_tracing/segment_sampling.hpp"

#include "../transport/statistics.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

/// Share of the angle before u, in long double, from the ends' angles.
double angle_share(long double d, long double foot, long double length, long double u)
{
    const auto angle = [&](long double t) { return std::atan2(d * t, d * d - foot * (t - foot)); };
    return double(angle(u) / angle(length));
}

// Hard cases 10 and 11: the light near the line with its foot outside, and short stretches far away.
TEST(AngleSampling, UndoesItsDistributionOnHardStretches)
{
    for (const double d : {1e-30, 1e-12, 1e-7, 1e-3, .1, 1., 100.})
        for (const double foot : {-1000., -1., -1e-3, .2, .5, 1.001, 3., 1e5})
            for (const double length : {1e-3, 1., 1e3}) {
                const SeenStretch seen = see_stretch({0, d, foot}, {0, 0, 1}, length);
                if (seen.distance != d) continue;  // raised to its floor: tested below
                for (double xi = .05; xi < 1; xi += .13) {
                    const double u = sample_angle(seen, xi);
                    ASSERT_TRUE(u >= 0 && u <= length);
                    // near the foot u is fixed to a rounding of itself: the angle then by that over the distance
                    const double rounding = 1e-13 + 4e-16 * std::abs(foot) / std::hypot(d, u - foot) / seen.angle;
                    ASSERT_NEAR(angle_share(d, foot, length, u), xi, rounding) << d << ' ' << foot << ' ' << length;
                }
            }
}

TEST(AngleSampling, DensityIntegratesToOne)
{
    for (const double d : {1e-4, .1, 3.})
        for (const double foot : {-2., .3, 5.}) {
            const SeenStretch seen = see_stretch({d, 0, foot}, {0, 0, 1}, 1.5);
            const auto pdf = [&](long double u) {
                return (long double)pdf_angle_times_square(seen) / ((long double)d * d + (u - foot) * (u - foot));
            };
            EXPECT_NEAR(double(integrate(pdf, 0, 1.5, 1e-12L)), 1, 1e-9);
        }
}

TEST(AngleSampling, ALightOnTheLineGivesFiniteDensities)
{
    for (const Vec3& q : {Vec3(0, 0, .3), Vec3(0, 0, -2), Vec3(0, 0, 0), Vec3(0, 0, 1)}) {
        const SeenStretch seen = see_stretch(q, {0, 0, 1}, 1);
        EXPECT_TRUE(pdf_angle_times_square(seen) > 0 && std::isfinite(pdf_angle_times_square(seen)));
        for (const double xi : {0., .5, 1 - 0x1p-53}) {
            const double u = sample_angle(seen, xi);
            EXPECT_TRUE(u >= 0 && u <= 1) << q.z << ' ' << xi;
        }
    }
}

TEST(ExponentialMixture, SamplesFollowItsDensity)
{
    const ExponentialMixture mixture{.sigma = {.2, 3, 10}, .share = {.5, 0, .5}, .length = 2};
    constexpr int bins = 20, draws = 100000;
    std::vector<double> observed(bins, 0.0), expected;
    for (int i = 0; i < bins; ++i)
        expected.push_back(draws * double(integrate([&](long double u) { return (long double)pdf_mixture(mixture, double(u)); }, i * .1L,
                                                    (i + 1) * .1L, 1e-10L)));
    RandomSequence random = numbers(1);
    for (int i = 0; i < draws; ++i) ++observed[std::min(int(sample_mixture(mixture, random.next2()) * 10), bins - 1)];
    EXPECT_GT(chi_square_p(observed, expected), false_alarm_rate);
}

}  // namespace
