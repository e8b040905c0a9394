// What holds for every pair, degenerate ones included: finite, not negative, on its segments, bounded (rows 27, 28, 34).
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "selftest/evaluate.hpp"

namespace tyndall::test {
namespace {

/// rc::check prints the counterexample and the seed that reproduces it; RC_PARAMS overrides. The default configuration is fixed here.
template <class F>
bool holds(const std::string& what, F&& property)
{
    rc::detail::Configuration configuration;
    configuration.testParams.seed = 20120805;
    configuration.testParams.maxSuccess = 20000;
    rc::detail::TestMetadata metadata;
    metadata.id = metadata.description = what;
    const auto result = rc::detail::checkTestable(std::forward<F>(property), metadata, configuration.testParams);
    rc::detail::printResultMessage(result, std::cerr);
    return result.template is<rc::detail::SuccessResult>();
}

/// Coordinates that like to coincide: whole numbers, halves, tiny ones, ordinary ones.
rc::Gen<float> coordinate()
{
    const auto scaled = [](double scale) { return rc::gen::map(rc::gen::inRange(-1000, 1001), [scale](int i) { return float(i * scale); }); };
    return rc::gen::weightedOneOf<float>({{3, rc::gen::element(0.f, 1.f, -1.f, .5f, -.5f)}, {3, scaled(1e-3)}, {1, scaled(1e-9)}, {1, scaled(1e-18)}, {1, scaled(10.)}});
}

struct Vector {
    float x, y, z;
};
rc::Gen<Vector> vector() { return rc::gen::map(rc::gen::tuple(coordinate(), coordinate(), coordinate()), [](const auto& t) { return Vector{std::get<0>(t), std::get<1>(t), std::get<2>(t)}; }); }

rc::Gen<Vector> direction()
{
    return rc::gen::map(rc::gen::suchThat(vector(), [](const Vector& v) { return double(v.x) * v.x + double(v.y) * v.y + double(v.z) * v.z > 1e-30; }),
                        [](const Vector& v) {
                            const double n = std::sqrt(double(v.x) * v.x + double(v.y) * v.y + double(v.z) * v.z);
                            return Vector{float(v.x / n), float(v.y / n), float(v.z / n)};
                        });
}

/// Lengths: 0, or within 1e-9 ... 1e7, so that the integral of 1 / w^2 at contact, 1 / (epsilon^3 length), is a float.
rc::Gen<float> size()
{
    const auto scaled = [](float scale) { return rc::gen::map(rc::gen::inRange(0, 1001), [scale](int i) { return float(i) * scale; }); };
    return rc::gen::weightedOneOf<float>({{2, rc::gen::element(0.f, 1.f, 2.f, 1e-7f, 1e7f)}, {2, scaled(1e-3f)}, {1, scaled(1e-9f)}, {1, scaled(10)}});
}
rc::Gen<float> number()
{
    return rc::gen::weightedOneOf<float>({{1, rc::gen::element(0.f, 0x1.fffffep-1f, .5f, 0x1p-24f)}, {4, rc::gen::map(rc::gen::inRange(0, 1 << 24), [](int i) { return float(i) * 0x1p-24f; })}});
}

template <class Real>
void put(std::array<Real, 14>& in, std::size_t first, const Vector& v)
{
    in[first] = v.x, in[first + 1] = v.y, in[first + 2] = v.z;
}

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
