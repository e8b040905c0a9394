#include "metrics/error_curve.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace tyndall::test {
namespace {

using testing::DoubleNear;

TEST(ErrorCurve, IsInterpolatedInLogarithms)
{
    const ErrorCurve curve{{1, 1, .08, .08}, {2, 4, .02, .02}, {4, 16, .02, .02}};
    EXPECT_THAT(*relative_mse_at(curve, 2), DoubleNear(.04, 1e-15)) << "halfway in both logarithms: a straight line would say .06";
    EXPECT_THAT(*relative_mse_at(curve, 4), DoubleNear(.02, 1e-15));
    EXPECT_THAT(*relative_mse_at(curve, 7.3), DoubleNear(.02, 1e-15));
    EXPECT_EQ(relative_mse_at(curve, 1), .08);
    EXPECT_EQ(relative_mse_at(curve, 16), .02);
}

TEST(ErrorCurve, IsNeverExtended)
{
    const ErrorCurve curve{{1, 1, .08, .08}, {2, 4, .02, .02}};
    EXPECT_FALSE(relative_mse_at(curve, .999));
    EXPECT_FALSE(relative_mse_at(curve, 4.001));
    EXPECT_FALSE(relative_mse_at({}, 1));
}

TEST(ErrorCurve, WithoutErrorHasNoLogarithm)
{
    const ErrorCurve curve{{1, 1, .08, 0}, {2, 4, 0, 0}};
    EXPECT_EQ(relative_mse_at(curve, 1.9), .08);
    EXPECT_EQ(relative_mse_at(curve, 2.1), 0);
}

TEST(ErrorCurve, OfIndependentPassesFallsWithTheirRoot)
{
    ErrorCurve curve;
    for (const int n : {1, 2, 4, 8, 16, 32, 64}) curve.push_back({n, .1 + n * .3, .5 / n + .001, 0});
    EXPECT_THAT(*convergence_slope(curve, .001), DoubleNear(-.5, 1e-12));
    EXPECT_GT(*convergence_slope(curve, 0), -.49) << "the reference's noise bends the curve";
}

TEST(ErrorCurve, OfABiasedMethodFallsLess)
{
    ErrorCurve curve;
    for (const int n : {1, 2, 4, 8, 16, 32, 64}) curve.push_back({n, n * 1., .5 / n + .02, 0});
    EXPECT_GT(*convergence_slope(curve, 0), -.4);
}

TEST(ErrorCurve, UnderTheReferencesNoiseHasNoSlope)
{
    const ErrorCurve curve{{8, 1, .004, 0}, {9, 2, .003, 0}, {10, 3, .0019, 0}};
    EXPECT_FALSE(convergence_slope(curve, .001));
    EXPECT_TRUE(convergence_slope(curve, .0009));
    EXPECT_FALSE(convergence_slope({{8, 1, .004, 0}, {9, 2, .003, 0}}, 0)) << "two points are a line whatever the truth";
}

TEST(Spread, IsMedianLowestAndHighest)
{
    const Spread spread = spread_of(std::vector{3., 1., 10.});
    EXPECT_EQ(spread.median, 3);
    EXPECT_EQ(spread.low, 1);
    EXPECT_EQ(spread.high, 10);
}

}  // namespace
}  // namespace tyndall::test
