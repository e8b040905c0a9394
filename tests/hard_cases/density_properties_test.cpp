// What holds for the density of every sampler at random and degenerate inputs: it integrates to one, weights stay below what the mathematics bounds them by,
// and inverses undo draws. Integrals in double, finiteness in both precisions.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/hard_cases/degenerate.hpp"
#include "tests/support/quadrature.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "selftest/evaluate.hpp"
// clang-format on

namespace tyndall::test {
namespace {

namespace twice = maths_double;

twice::real3 as_double(const Vector& v) { return {v.x, v.y, v.z}; }

template <class Real>
class EveryDensity : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryDensity, Precisions);

/// Directions that are sometimes equal or opposite to `a`, positions that are sometimes on its line.
Vector direction_near(const Vector& a)
{
    const int kind = *rc::gen::inRange(0, 8);
    return kind == 0 ? a : kind == 1 ? Vector{-a.x, -a.y, -a.z} : *direction();
}
Vector position_near(const Vector& a)
{
    const double along = *coordinate();
    return *rc::gen::inRange(0, 6) == 0 ? Vector{along * a.x, along * a.y, along * a.z} : *vector();
}
rc::Gen<float> asymmetry()
{
    return rc::gen::weightedOneOf<float>({{1, rc::gen::element(0.f, 1e-30f, -1e-6f)}, {1, rc::gen::element(.999f, -.999f, .99f)}, {3, rc::gen::map(rc::gen::inRange(-999, 1000), [](int i) { return float(i) * 1e-3f; })}});
}

/// Integral of a density over [0, length], cut where the sampler puts every sixteenth of it, so that narrow peaks are met.
template <class Density, class Draw>
double total(const Density& density, const Draw& draw, double length)
{
    std::vector<double> cuts{0, length};
    for (int i = 0; i <= 16; ++i) cuts.push_back(std::clamp(double(draw(std::min(i / 16., 1 - 0x1p-53))), 0., length));  // the ends too: a horizon may cut
    std::ranges::sort(cuts);
    long double sum = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        if (cuts[i + 1] > cuts[i]) sum += integrate([&](long double x) { return static_cast<long double>(density(double(x))); }, cuts[i], cuts[i + 1], 1e-9L, 24);
    return double(sum);
}

double length_of(const twice::real3& v) { return std::sqrt(twice::dot3(v, v)); }

constexpr double tolerance = 1e-6;  ///< 16 adaptive quadratures at 1e-9 each, and the density's own rounding where nothing is within 1e-8 of touching

TEST(AnyDensity, OfALightIntegratesToOne)
{
    EXPECT_TRUE(holds("rod", [] {
        const Vector a = *direction(), b = direction_near(a), q = position_near(a);
        const twice::real3 ra = as_double(a), rb = as_double(b), rq = as_double(q);
        const double length = *size();
        const twice::RodFrame f = twice::rod_frame(rq, ra, rb, length);
        const double nearest = std::min({f.D0, f.D1, f.x0 < 0 && f.x1 > 0 ? std::sqrt(f.h2) : HUGE_VAL});
        RC_PRE(length > 0 && nearest > 1e-8 * std::max(f.D0, f.D1));  // closer, D(v) itself has few digits in double
        const double sum = total([&](double v) { return twice::pdf_rod(rq, ra, rb, length, v); }, [&](double xi) { return twice::sample_rod(rq, ra, rb, length, xi).v; }, length);
        RC_ASSERT(std::abs(sum - 1) < tolerance);
    }, 2000));
}

TEST(AnyDensity, OfAnEyeSegmentIntegratesToOne)
{
    EXPECT_TRUE(holds("equi-angular", [] {
        const Vector a = *direction();
        const twice::real3 ra = as_double(a), p = as_double(position_near(a));
        const double length = *size();
        const twice::AngleFrame f = twice::angle_frame(p, ra, length);
        RC_PRE(length > 0 && f.D > 1e-8 * std::max({std::abs(f.t0), std::abs(f.t1), f.length}));
        const double sum = total([&](double u) { return twice::pdf_equiangular(p, ra, length, u); }, [&](double xi) { return twice::sample_equiangular(p, ra, length, xi).u; }, length);
        RC_ASSERT(std::abs(sum - 1) < tolerance);
    }, 2000));
}

TEST(AnyDensity, OfALightAboveASurfaceIntegratesToOneAndItsWeightIsBounded)
{
    EXPECT_TRUE(holds("surface", [] {
        const Vector n = *direction(), b = direction_near(n);
        const twice::real3 rn = as_double(n), rb = as_double(b), p = as_double(position_near(b));
        const double length = *size();
        const twice::SurfaceRodFrame f = twice::surface_rod_frame(p, rb, length, rn);
        const double D = length_of(twice::cross3(p, rb)), weight = twice::sample_surface_rod(p, rb, length, rn, .5).weight;
        // The integral of a cosine over an arc of directions is at most 2. D is known to 4 epsilon |p|, and counts as no less than epsilon^(3/2) of the scale (eq. 21a).
        const double e = std::numeric_limits<double>::epsilon(), least = std::max(D - 4 * e * length_of(p), e * std::sqrt(e) * f.scale);
        RC_ASSERT(std::isfinite(weight) && weight >= 0 && weight * least <= 2 * (1 + 1e-12));
        const bool visible = f.length > 1e-6 * length / f.scale && f.c0 + f.c1 > 1e-6;
        RC_PRE(length > 0 && visible && std::sqrt(f.D2) > 1e-6 * std::max({f.r0, f.r1, f.length}));
        const double sum = total([&](double v) { return twice::pdf_surface_rod(p, rb, length, rn, v); }, [&](double xi) { return twice::sample_surface_rod(p, rb, length, rn, xi).v; }, length);
        RC_ASSERT(std::abs(sum - 1) < tolerance);
    }, 2000));
}

TEST(AnyDensity, OfADistanceIntegratesToOneAndItsInverseUndoesDraws)
{
    EXPECT_TRUE(holds("distance", [] {
        const double sigma = *size(), length = *size(), xi = *number();
        RC_PRE(length > 0 && sigma * length < 600);
        const double sum = total([&](double t) { return twice::pdf_distance(sigma, length, t); }, [&](double x) { return twice::sample_distance(sigma, length, x); }, length);
        RC_ASSERT(std::abs(sum - 1) < tolerance);
        RC_ASSERT(std::abs(twice::invert_distance(sigma, length, twice::sample_distance(sigma, length, xi)) - xi) < 1e-12);
    }, 2000));
}

TEST(AnyDensity, OfALinearPieceIntegratesToOneAndItsInverseUndoesDraws)
{
    EXPECT_TRUE(holds("linear", [] {
        const double f0 = std::abs(*coordinate()), f1 = std::abs(*coordinate()), xi = *number();
        const double sum = total([&](double r) { return twice::pdf_linear(f0, f1, r); }, [&](double x) { return twice::sample_linear(f0, f1, x); }, 1);
        RC_ASSERT(std::abs(sum - 1) < tolerance);
        RC_ASSERT(std::abs(twice::invert_linear(f0, f1, twice::sample_linear(f0, f1, xi)) - xi) < 1e-12);
    }, 2000));
}

TEST(AnyDensity, OfHenyeyAndGreensteinIntegratesToOneAndItsInverseUndoesDraws)
{
    EXPECT_TRUE(holds("henyey greenstein", [] {
        const double g = *asymmetry(), xi = *number();
        const auto draw = [&](double x) { return twice::sample_henyey_greenstein_cosine(g, x); };
        // Over 1 - cos, from the side of the peak, where the density needs its digits.
        const auto from_peak = [&](double x) { return g < 0 ? twice::ScatterCosine{2 - x, x} : twice::ScatterCosine{x, 2 - x}; };
        const double sum = total([&](double x) { return twice::pdf_henyey_greenstein(g, from_peak(x)); }, [&](double x) { return g < 0 ? draw(x).one_plus : draw(x).one_minus; }, 2);
        RC_ASSERT(std::abs(sum - 1) < tolerance);
        RC_ASSERT(std::abs(twice::invert_henyey_greenstein(g, draw(xi)) - xi) < 1e-12);
    }, 2000));
}

TYPED_TEST(EveryDensity, OfAPhaseProductIsFiniteBoundedAndOfTheSampleThatWasDrawn)
{
    EXPECT_TRUE(holds("phase product", [] {
        using Real = TypeParam;
        const auto check = [](const auto& sample, const auto& pdf) {
            RC_ASSERT(sample.x >= 0 && sample.x <= 1);
            // At least the even share, whose reciprocal, 10, bounds the weight by 10 pi E.
            RC_ASSERT(std::isfinite(sample.density) && sample.density >= Real(.1) * (1 - 4 * std::numeric_limits<Real>::epsilon()));
            RC_ASSERT(std::isfinite(pdf) && std::abs(pdf - sample.density) <= 64 * std::numeric_limits<Real>::epsilon() * sample.density);
        };
        const Vector a = *direction(), b = direction_near(a), p = position_near(a);
        const Real length = *size(), g_eye = *asymmetry(), g_light = *asymmetry(), sigma = *size(), xi = *number();
        const bool absorbs = *rc::gen::inRange(0, 2) == 1;
        if constexpr (sizeof(Real) == 4) {
            const auto narrow = [](const Vector& v) { return maths_float::real3{float(v.x), float(v.y), float(v.z)}; };
            const maths_float::GuideMedia media{g_eye, g_light, sigma, sigma, sigma};
            const maths_float::WarpShape shape{absorbs ? 6 : 10, 1, absorbs};
            const auto sample = maths_float::sample_phase_product(narrow(p), narrow(a), length, narrow(b), media, shape, xi);
            check(sample, maths_float::pdf_phase_product(narrow(p), narrow(a), length, narrow(b), media, shape, sample.x));
        } else {
            const twice::GuideMedia media{g_eye, g_light, sigma, sigma, sigma};
            const twice::WarpShape shape{absorbs ? 6 : 10, 1, absorbs};
            const auto sample = twice::sample_phase_product(as_double(p), as_double(a), length, as_double(b), media, shape, xi);
            check(sample, twice::pdf_phase_product(as_double(p), as_double(a), length, as_double(b), media, shape, sample.x));
        }
    }));
}

TEST(AnyDensity, OfAPhaseProductIntegratesToOne)
{
    EXPECT_TRUE(holds("phase product", [] {
        const Vector a = *direction(), b = direction_near(a);
        const twice::real3 ra = as_double(a), rb = as_double(b), p = as_double(position_near(a));
        const double length = *size(), g_eye = *asymmetry(), g_light = *asymmetry();
        const twice::GuideMedia media{g_eye, g_light, 1, 1, 1};
        const twice::WarpShape shape{*rc::gen::element(4, 6, PHASE_VERTICES), 1, *rc::gen::inRange(0, 2)};
        const twice::PhaseTable table = twice::phase_table(twice::phase_fan(p, ra, length, rb, media, shape), shape);
        double sum = 0;
        for (int j = 0; j + 1 < shape.vertices; ++j)  // linear between vertices: the middle's value is the mean
            sum += (table.x[j + 1] - table.x[j]) * twice::pdf_phase_product(p, ra, length, rb, media, shape, .5 * (table.x[j] + table.x[j + 1]));
        RC_ASSERT(std::abs(sum - 1) < tolerance);
    }));
}

TYPED_TEST(EveryDensity, AnAngleIsOneAndItsSampleOnTheSegment)
{
    EXPECT_TRUE(holds("angle", [] {
        std::array<TypeParam, 14> in{};
        const Vector a = *direction();
        put(in, 0, position_near(a)), put(in, 3, a);
        if (*rc::gen::inRange(0, 20) == 0) in[0] = in[1] = in[2] = 0;  // seen from its own origin
        in[6] = *rc::gen::inRange(0, 20) == 0 ? std::numeric_limits<TypeParam>::infinity() : TypeParam(*size()), in[7] = *number();
        const auto [u, angle, over_distance, xi] = evaluate_on_host<TypeParam>(SAMPLER_ANGLE, in);
        RC_ASSERT(u >= 0 && u <= in[6] && std::isfinite(u));
        RC_ASSERT(angle >= 0 && angle <= TypeParam(3.1415928));
        RC_ASSERT(std::isfinite(over_distance) && over_distance >= 0);
        RC_ASSERT(in[6] == 0 || (xi >= 0 && xi <= 1));
    }));
}

/// The checks see errors of a part in a thousand.
TEST(AnyDensity, ThatIsWrongIsFound)
{
    const double right = total([](double t) { return twice::pdf_distance(3, 2, t); }, [](double x) { return twice::sample_distance(3, 2, x); }, 2);
    const double wrong = total([](double t) { return twice::pdf_distance(3.003, 2, t) * (3 / 3.003); }, [](double x) { return twice::sample_distance(3, 2, x); }, 2);
    EXPECT_LT(std::abs(right - 1), tolerance);
    EXPECT_GT(std::abs(wrong - 1), tolerance);
}

}  // namespace
}  // namespace tyndall::test
