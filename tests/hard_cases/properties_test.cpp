// What holds for every pair, degenerate ones included: finite, not negative, on its segments, bounded (rows 27, 28, 34).
#include <gtest/gtest.h>

#include "tests/hard_cases/degenerate.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "selftest/evaluate.hpp"
// clang-format on

namespace tyndall::test {
namespace {

template <class Real>
class EveryPair : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryPair, Precisions);

/// Directions are sometimes equal or opposite, positions sometimes on the eye line.
template <class Real>
std::array<Real, 14> any_pair()
{
    std::array<Real, 14> in{};
    const Vector a = *direction();
    const int kind = *rc::gen::inRange(0, 8);
    const Vector b = kind == 0 ? a : kind == 1 ? Vector{-a.x, -a.y, -a.z} : *direction();
    const float along = *coordinate();
    const Vector q = *rc::gen::inRange(0, 6) == 0 ? Vector{along * a.x, along * a.y, along * a.z} : *vector();
    put(in, 0, q), put(in, 3, a), put(in, 6, b);
    in[9] = *size(), in[10] = *size(), in[11] = *number(), in[12] = *number();
    return in;
}

TYPED_TEST(EveryPair, IsFiniteAndOnItsSegmentsAndBounded)
{
    EXPECT_TRUE(holds("pair", [] {
        const auto in = any_pair<TypeParam>();
        const auto [weight, v, u, floor_ratio] = evaluate_on_host<TypeParam>(SAMPLER_PAIR, in);
        RC_ASSERT(std::isfinite(weight) && weight >= 0);
        RC_ASSERT(v >= 0 && v <= in[9]);
        RC_ASSERT(u >= 0 && u <= in[10]);
        RC_ASSERT(floor_ratio >= 1);
        auto rod = in;
        rod[10] = in[11];
        const TypeParam potential = evaluate_on_host<TypeParam>(SAMPLER_ROD, rod)[0];
        RC_ASSERT(std::isfinite(potential) && potential >= 0);
        if (floor_ratio == 1) RC_ASSERT(weight <= TypeParam(3.1415928) * potential);  // 1 + 2e-8 times pi: rounding of Theta
    }));
}

TYPED_TEST(EveryPair, OfLightAndSurfaceIsFiniteAndOnTheLight)
{
    EXPECT_TRUE(holds("surface", [] {
        std::array<TypeParam, 14> in{};
        const Vector n = *direction(), b = *rc::gen::inRange(0, 4) == 0 ? n : *direction();
        const float along = *coordinate();
        put(in, 0, *rc::gen::inRange(0, 6) == 0 ? Vector{along * b.x, along * b.y, along * b.z} : *vector());
        put(in, 3, b), put(in, 7, n);
        in[6] = *size(), in[10] = *number();
        const auto [v, weight, pdf, xi] = evaluate_on_host<TypeParam>(SAMPLER_SURFACE, in);
        RC_ASSERT(v >= 0 && v <= in[6]);
        RC_ASSERT(std::isfinite(weight) && weight >= 0);
        // At most 2 / D, also of a light through the surface point: D is known to 4 epsilon |p| and counts as no less than epsilon^(3/2) of the scale, half of |p| or more (eq. 21a).
        const double e = std::numeric_limits<TypeParam>::epsilon(), p = std::hypot(double(in[0]), double(in[1]), double(in[2]));
        const double D = std::hypot(double(in[1]) * in[5] - double(in[2]) * in[4], double(in[2]) * in[3] - double(in[0]) * in[5], double(in[0]) * in[4] - double(in[1]) * in[3]);
        const double size = std::max({std::abs(double(in[0])), std::abs(double(in[1])), std::abs(double(in[2])), e * in[6], 0x1p-100});
        RC_ASSERT(double(weight) * std::max(D - 4 * e * p, e * std::sqrt(e) * size / 2) <= 2 * (1 + 8 * e));
        RC_ASSERT(pdf >= 0);
        RC_ASSERT(xi >= 0 && xi <= 1);
    }));
}

TYPED_TEST(EveryPair, OfAsymmetryAndNumberIsACosine)
{
    EXPECT_TRUE(holds("phase function", [] {
        std::array<TypeParam, 14> in{};
        in[0] = *rc::gen::weightedOneOf<float>({{1, rc::gen::element(0.f, 1.f, -1.f, 2.f, 1e-30f)}, {4, rc::gen::map(rc::gen::inRange(-1000, 1001), [](int i) { return float(i) * 1e-3f; })}});
        in[1] = *number();
        const auto [cosine, one_minus, one_plus, xi] = evaluate_on_host<TypeParam>(SAMPLER_SCATTER, in);
        RC_ASSERT(cosine >= -1 && cosine <= 1);
        RC_ASSERT(one_minus >= 0 && one_plus >= 0);
        RC_ASSERT(std::abs(one_minus + one_plus - 2) <= 8 * std::numeric_limits<TypeParam>::epsilon());
        RC_ASSERT(xi >= 0 && xi <= 1 + 4 * std::numeric_limits<TypeParam>::epsilon());
    }));
}

TYPED_TEST(EveryPair, OfExtinctionAndLengthGivesADistanceInside)
{
    EXPECT_TRUE(holds("distance", [] {
        std::array<TypeParam, 14> in{};
        in[0] = *size(), in[1] = *size(), in[2] = *number();
        const auto [t, pdf, xi, transmitted] = evaluate_on_host<TypeParam>(SAMPLER_DISTANCE, in);
        RC_ASSERT(t >= 0 && t <= in[1]);
        RC_ASSERT(pdf >= 0);
        RC_ASSERT(transmitted >= 0 && transmitted <= 1);
    }));
}

}  // namespace
}  // namespace tyndall::test
