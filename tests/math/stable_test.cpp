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

}  // namespace
}  // namespace tyndall::test
