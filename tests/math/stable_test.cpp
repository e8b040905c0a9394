// The elementary functions of kernels/math/stable.h over their whole domains, against 50 digits.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

#include "kernels/dialect_host.hpp"

namespace tyndall::test {
namespace {

using Big = boost::multiprecision::cpp_bin_float_50;

/// Worst error in units in the last place of Real, over `draws` arguments.
template <class Real, class Argument, class Function, class Oracle>
double worst_ulp(int draws, Argument&& argument, Function&& function, Oracle&& oracle)
{
    std::mt19937_64 engine(7);
    double worst = 0;
    for (int i = 0; i < draws; ++i) {
        const Real x = argument(engine);
        const Real y = function(x);
        if (!std::isfinite(y)) return std::numeric_limits<double>::infinity();
        const Big truth = oracle(Big(x));
        const Real rounded = static_cast<Real>(truth);
        const Real ulp = std::max(std::nextafter(std::fabs(rounded), std::numeric_limits<Real>::infinity()) - std::fabs(rounded), std::numeric_limits<Real>::denorm_min());
        worst = std::max(worst, static_cast<double>(abs(Big(y) - truth) / Big(ulp)));
    }
    return worst;
}

/// Uniform in the exponent, from 2^low to 2^high, of either sign if `both`.
template <class Real>
auto exponent_uniform(double low, double high, bool both = false)
{
    return [=](std::mt19937_64& engine) {
        const double x = std::exp2(low + (high - low) * double(engine() >> 11) * 0x1p-53);
        return Real(both && engine() % 2 ? -x : x);
    };
}

Big log1p_over(const Big& x) { return x == 0 ? Big(1) : Big(log(Big(1 + x)) / x); }
Big expm1_over(const Big& x) { return x == 0 ? Big(1) : Big((exp(x) - 1) / x); }

TEST(Stable, Log1pOverIsWithinThreeUlp)
{
    EXPECT_LE(worst_ulp<float>(20000, exponent_uniform<float>(-60, 126), maths_float::log1p_over, log1p_over), 3);
    EXPECT_LE(worst_ulp<float>(20000, [](std::mt19937_64& e) { return -float(double(e() >> 40) * 0x1p-24); }, maths_float::log1p_over, log1p_over), 3);
    EXPECT_LE(worst_ulp<double>(5000, exponent_uniform<double>(-40, 500), maths_double::log1p_over, log1p_over), 3);
    EXPECT_EQ(maths_float::log1p_over(0), 1);
    EXPECT_EQ(maths_double::log1p_over(0), 1);
}

TEST(Stable, Expm1OverIsWithinThreeUlp)
{
    EXPECT_LE(worst_ulp<float>(20000, exponent_uniform<float>(-60, 6.3, true), maths_float::expm1_over, expm1_over), 3);
    EXPECT_LE(worst_ulp<double>(5000, exponent_uniform<double>(-40, 9, true), maths_double::expm1_over, expm1_over), 3);
    EXPECT_EQ(maths_float::expm1_over(0), 1);
    EXPECT_EQ(maths_double::expm1_over(0), 1);
}

/// The forms without a division: a f(x) / x with a = x / 2^k, so that a and the division by x are exact.
TEST(Stable, ScaledFormsAreWithinThreeUlp)
{
    const auto scaled_log = [](float x) { return maths_float::log1p_scaled(x, x * 0x1p-3f, 0x1p-3f); };
    EXPECT_LE(worst_ulp<float>(20000, exponent_uniform<float>(-60, 120), scaled_log, [](const Big& x) { return Big(x / 8 * log1p_over(x)); }), 3);
    const auto grown = [](float x) { return maths_float::growth(x, x * 0x1p-3f, 0x1p-3f).scaled; };
    EXPECT_LE(worst_ulp<float>(20000, exponent_uniform<float>(-60, 6.4), grown, [](const Big& x) { return Big((exp(x) - 1) / 8); }), 3);
    const auto decayed = [](float x) { return maths_float::growth(x, x, 1).decayed; };
    EXPECT_LE(worst_ulp<float>(20000, exponent_uniform<float>(-60, 6.4), decayed, [](const Big& x) { return Big(exp(Big(-x))); }), 3);
}

TEST(Stable, DecayIsWithinThreeUlpAndEndsAtZero)
{
    EXPECT_LE(worst_ulp<float>(20000, exponent_uniform<float>(-60, 6.44), maths_float::decay, [](const Big& x) { return Big(exp(Big(-x))); }), 3);
    for (const float x : {87.6f, 87.7f, 88.f, 88.1f, 100.f, 1e30f, std::numeric_limits<float>::infinity()}) {
        EXPECT_GE(maths_float::decay(x), 0) << x;
        EXPECT_LE(maths_float::decay(x), 1e-38f) << x;
    }
    EXPECT_EQ(maths_float::decay(0), 1);
    EXPECT_TRUE(std::isnan(maths_float::decay(std::nanf(""))));
}

TEST(Stable, UpperAtan2IsWithinThreeUlpInEveryDirection)
{
    std::mt19937_64 engine(8);
    const auto exponent = exponent_uniform<float>(-30, 30, true);
    for (int i = 0; i < 50000; ++i) {
        const float y = std::fabs(exponent(engine)), x = i % 3 ? y * (2 * float(engine() >> 40) * 0x1p-24f - 1) : exponent(engine);
        const Big truth = atan2(Big(y), Big(x));
        // 3 ulp of the result; the quotient underflows harmlessly below 2^-120.
        EXPECT_LE(abs(Big(maths_float::upper_atan2(y, x)) - truth), 3 * Big(0x1p-23f) * truth + Big(0x1p-120)) << y << ' ' << x;
    }
    EXPECT_EQ(maths_float::upper_atan2(0, 0), 0);
    EXPECT_EQ(maths_float::upper_atan2(0, 1), 0);
    EXPECT_NEAR(maths_float::upper_atan2(0, -1), 3.14159265f, 4e-7);
}

TEST(Stable, SineAndCosineOfAnAngle)
{
    for (int i = 0; i <= 100000; ++i) {
        const float x = float(i) * float(3.14159265358979323846 / 100000);
        const maths_float::SineCosine s = maths_float::sine_cosine(x);
        const double sine_over = x == 0 ? 1 : std::sin(double(x)) / double(x);
        // Up to 2, cos(x/2) > .54 keeps its relative accuracy: 3 epsilon; beyond, its absolute one, 2 epsilon.
        ASSERT_NEAR(s.sine_over, sine_over, x <= 2 ? 3 * 0x1p-23 * sine_over : 0x1p-22) << x;
        ASSERT_NEAR(s.cosine, std::cos(double(x)), 7.2e-7) << x;  // 1 - 2 s^2: six roundings of 2^-24, of at most 2
    }
}

}  // namespace
}  // namespace tyndall::test
