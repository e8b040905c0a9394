// Mean weights of whole connections against independent integrals, symmetry, and scale.
#include <gtest/gtest.h>

#include <random>

#include "kernels/dialect_host.hpp"
#include "tests/support/quadrature.hpp"

namespace tyndall::test {
namespace {

namespace twice = maths_double;
namespace single = maths_float;
using Vector = twice::real3;

struct Pair {
    Vector q, a, b;
    double light, eye;
};

double weight(const Pair& p, double xi)
{
    const twice::RodSample rod = twice::sample_rod(p.q, p.a, p.b, p.light, xi);
    const twice::AngleSample angle = twice::sample_equiangular(twice::along3(p.q, rod.v, p.b), p.a, p.eye, .5);
    return twice::pair_weight(rod, angle);
}

/// Integral of 1 / w^2 over both segments: long double, no line of the kernels; inner integral in closed form (difference of arc tangents).
long double flow(const Pair& p)
{
    return integrate(
        [&](long double v) {
            const long double x = p.q.x + v * p.b.x, y = p.q.y + v * p.b.y, z = p.q.z + v * p.b.z;
            const long double foot = x * p.a.x + y * p.a.y + z * p.a.z;
            const long double D = std::sqrt(x * x + y * y + z * z - foot * foot);
            return (std::atan((p.eye - foot) / D) + std::atan(foot / D)) / D;
        },
        0, p.light, 1e-14L);
}

Pair random_pair(std::mt19937& engine)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto direction = [&] {
        Vector d;
        do d = {uniform(engine), uniform(engine), uniform(engine)};
        while (twice::dot3(d, d) > 1 || twice::dot3(d, d) < .01);
        const double n = twice::length3(d);
        return Vector{d.x / n, d.y / n, d.z / n};
    };
    return {{uniform(engine), uniform(engine), uniform(engine)}, direction(), direction(), .2 + std::fabs(uniform(engine)), .2 + 2 * std::fabs(uniform(engine))};
}

TEST(PairWeight, MeanIsTheIntegralOfTheInverseSquare)
{
    std::mt19937 engine(11);
    for (int i = 0; i < 100; ++i) {
        const Pair p = random_pair(engine);
        // Theta is smooth in xi, with kinks no sharper than the distance of closest approach: 1e-6 covers the worst of these hundred.
        const double mean = double(integrate([&](long double xi) { return static_cast<long double>(weight(p, double(xi))); }, 0, 1, 1e-10L, 20));
        const double truth = double(flow(p));
        EXPECT_NEAR(mean, truth, 1e-6 * truth) << "pair " << i;
    }
}

TEST(PairWeight, IsTheReciprocalOfTheDensitiesAndTheSquaredDistance)
{
    std::mt19937 engine(12);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 1000; ++i) {
        const Pair p = random_pair(engine);
        const twice::RodSample rod = twice::sample_rod(p.q, p.a, p.b, p.light, uniform(engine));
        const Vector y = twice::along3(p.q, rod.v, p.b);
        const twice::AngleSample angle = twice::sample_equiangular(y, p.a, p.eye, uniform(engine));
        const Vector w = twice::along3(y, -angle.u, p.a);
        const double direct = 1 / (twice::dot3(w, w) * twice::pdf_rod(p.q, p.a, p.b, p.light, rod.v) * twice::pdf_equiangular(y, p.a, p.eye, angle.u));
        EXPECT_NEAR(twice::pair_weight(rod, angle), direct, 1e-10 * direct);  // 1e-16 / (D / |q|), D > 1e-4 in these pairs
    }
}

/// The marginal over an infinite eye line gives pi E exactly, whatever xi.
TEST(PairWeight, OfAnInfiniteEyeLineIsPiTimesThePotential)
{
    std::mt19937 engine(13);
    for (int i = 0; i < 100; ++i) {
        const Pair p = random_pair(engine);
        const twice::RodSample rod = twice::sample_rod(p.q, p.a, p.b, p.light, .3);
        const Vector y = twice::along3(twice::along3(p.q, rod.v, p.b), 1e15, p.a);  // seen from 1e15 before: the line is infinite both ways
        const twice::AngleSample angle = twice::sample_equiangular(y, p.a, 2e15, .5);
        EXPECT_NEAR(twice::pair_weight(rod, angle), 3.14159265358979323846 * rod.potential, 1e-13 * rod.potential);
    }
}

/// Exchanging eye segment and light exchanges nothing but the names: the mean weight is the same.
TEST(PairWeight, MeanIsReciprocal)
{
    std::mt19937 engine(14);
    for (int i = 0; i < 50; ++i) {
        const Pair p = random_pair(engine);
        const Pair swapped{{-p.q.x, -p.q.y, -p.q.z}, p.b, p.a, p.eye, p.light};
        const auto mean = [](const Pair& pair) { return double(integrate([&](long double xi) { return static_cast<long double>(weight(pair, double(xi))); }, 0, 1, 1e-10L, 20)); };
        EXPECT_NEAR(mean(p), mean(swapped), 2e-6 * mean(p));
    }
}

/// Doubling every length changes nothing but the unit, to the bit: there is no absolute epsilon anywhere.
TEST(PairWeight, DoesNotChangeByOneBitWhenEverythingIsScaledByAPowerOfTwo)
{
    std::mt19937 engine(15);
    for (int i = 0; i < 1000; ++i) {
        const Pair p = random_pair(engine);
        const auto sample = [&](float k) {
            const single::real3 q{float(p.q.x) * k, float(p.q.y) * k, float(p.q.z) * k}, a{float(p.a.x), float(p.a.y), float(p.a.z)}, b{float(p.b.x), float(p.b.y), float(p.b.z)};
            const single::RodSample rod = single::sample_rod(q, a, b, float(p.light) * k, .375f);
            const single::AngleSample angle = single::sample_equiangular(single::along3(q, rod.v, b), a, float(p.eye) * k, .625f);
            return std::array{single::pair_weight(rod, angle), rod.v / k, angle.u / k, rod.potential, angle.angle};
        };
        const auto unscaled = sample(1);
        for (const float k : {0x1p-60f, 0x1p-20f, 2.f, 0x1p20f, 0x1p60f}) EXPECT_EQ(sample(k), unscaled) << "scale " << k;
    }
}

/// Under the floor (a light that meets the eye line exactly) the density still integrates to one and its reciprocal still weighs every part right:
/// the integral over v of pdf, from its own inverse, and of floor_ratio / D against 1 / D.
TEST(PairWeight, UnderTheFloorIsTheReciprocalOfTheDensityThatWasSampled)
{
    const single::real3 q{-.5f, 0, 1}, a{0, 0, 1}, b{1, 0, 0};  // crosses the eye line at v = 1/2, exactly
    double mean = 0;
    constexpr int n = 4096;
    for (int i = 0; i < n; ++i) {
        const single::RodSample rod = single::sample_rod(q, a, b, 1, (float(i) + .5f) / n);
        EXPECT_GE(rod.floor_ratio, 1);
        mean += rod.potential * rod.distance * (rod.v > .75f) / n;  // length of the part (3/4, 1], from samples
        EXPECT_NEAR(1 / (rod.potential * rod.distance), single::pdf_rod(q, a, b, 1, rod.v), 1e-5 / (rod.potential * rod.distance));
    }
    EXPECT_NEAR(mean, .25, .01);  // 1 / n of the samples at each edge, each weighing up to E / n = .008
}

}  // namespace
}  // namespace tyndall::test
