// Bugs that implementations of such samplers have had in public, one test each: the bug, written out, fails what the kernels' mathematics passes
// (host/docs/hard_cases.md lists them).
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "selftest/golden.hpp"
#include "tests/hard_cases/plain_pair.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "selftest/evaluate.hpp"
// clang-format on

namespace tyndall::test {
namespace {

using Inputs = std::array<float, 14>;
using Vector = maths_float::real3;
using maths_float::dot3;

/// Eye from the origin along z, 2 long unless said otherwise.
Inputs pair_of(Vector q, Vector b, float light = 1, float eye = 2)
{
    const float size = std::sqrt(dot3(b, b));
    return {q.x, q.y, q.z, 0, 0, 1, b.x / size, b.y / size, b.z / size, light, eye, .5f, .5f};
}
Vector origin_of(const Inputs& in) { return {in[0], in[1], in[2]}; }
Vector eye_of(const Inputs& in) { return {in[3], in[4], in[5]}; }
Vector light_of(const Inputs& in) { return {in[6], in[7], in[8]}; }

float weight_of(const Inputs& in) { return evaluate_on_host<float>(SAMPLER_PAIR, in)[0]; }
float potential_of(Inputs in)
{
    in[10] = in[11];
    return evaluate_on_host<float>(SAMPLER_ROD, in)[0];
}

/// Mean over where on the light of what an estimator weighs a pair with; the transport between the two segments if the estimator is right.
double mean_of(const Inputs& in, const std::function<float(const Inputs&)>& weight)
{
    const MeanNodes<float> nodes = mean_nodes<float>(in, 64);
    double mean = 0;
    for (std::size_t i = 0; i < nodes.in.size(); ++i) mean += nodes.weight[i] * double(weight(nodes.in[i]));
    return mean;
}

/// |x / truth - 1|; NaN and infinity are as wrong as can be.
double error(double x, long double truth) { return std::isfinite(x) ? double(std::abs(x / truth - 1)) : HUGE_VAL; }

constexpr double rounding = 1e-5;  ///< well-conditioned pairs: some 10 epsilon of float for a weight, times what the rounding of the inputs does

/// Closest points of the talk's marginal, and its h; `clamped`: to the two segments.
struct ClosestPoints {
    float v, h;
    ClosestPoints(const Inputs& in, bool clamped)
    {
        const Vector q = origin_of(in), a = eye_of(in), b = light_of(in);
        const float cosine = dot3(a, b);
        v = (dot3(q, a) * cosine - dot3(q, b)) / (1 - cosine * cosine);
        float u = dot3(q, a) + v * cosine;
        if (clamped) v = std::clamp(v, 0.f, in[9]), u = std::clamp(u, 0.f, in[10]);
        const Vector d{q.x + v * b.x - u * a.x, q.y + v * b.y - u * a.y, q.z + v * b.z - u * a.z};
        h = std::sqrt(dot3(d, d));
    }
};

TEST(PublicBugs, ClosestPointsClampedToTheSegmentsInADensityForInfiniteLines)
{
    const Inputs in = pair_of({.5f, .2f, 3}, {.3f, -.1f, .8f}, 1.5f, 1);  // the lines are closest beyond both segments
    const PlainPair pair(in);
    const ClosestPoints closest(in, true);
    const float cosine = in[8];
    double ours = 0, clamped = 0;
    for (int i = 0; i <= 16; ++i) {
        const float v = in[9] * i / 16;
        Inputs at = in;
        at[10] = v;
        // The density is 1 / D, normalised. The clamped one is normalised as well, so that nobody notices, but of another function.
        const long double truth = 1 / (pair.potential() * pair.distance(v));
        ours = std::max(ours, error(evaluate_on_host<float>(SAMPLER_ROD_PDF, at)[0], truth));
        const auto bare = [&](long double x) { return 1 / std::sqrt(closest.h * closest.h + (1 - cosine * cosine) * (x - closest.v) * (x - closest.v)); };
        clamped = std::max(clamped, error(double(bare(v) / integrate(bare, 0, in[9], 1e-9L)), truth));
    }
    EXPECT_LT(ours, rounding);
    EXPECT_GT(clamped, .2);
}

TEST(PublicBugs, SamplesDroppedWhereTheSineOrTheDistanceIsZero)
{
    const Inputs parallel = pair_of({.3f, .4f, .25f}, {0, 0, 1}), coplanar = pair_of({1, 0, .5f}, {.6f, 0, .8f});  // which meets the eye line behind its start
    const auto dropping = [](const Inputs& in) {
        const float cosine = dot3(eye_of(in), light_of(in)), sine = std::sqrt(1 - cosine * cosine);
        if (sine == 0) return 0.f;
        return ClosestPoints(in, false).h < 1e-6f ? 0.f : weight_of(in);
    };
    for (const Inputs& in : {parallel, coplanar}) {
        EXPECT_LT(error(mean_of(in, weight_of), PlainPair(in).transport()), rounding);
        EXPECT_EQ(mean_of(in, dropping), 0);
    }
}

TEST(PublicBugs, EpsilonsThatAreLengths)
{
    const Inputs in = pair_of({.3f, .7f, .25f}, {.5f, .2f, -.6f}, 1, 1);
    /// "Parallel" if the determinant of the two segments, a length to the fourth power, is below 1e-4: then E = L / D.
    const auto absolute = [](const Inputs& i) {
        const float cosine = dot3(eye_of(i), light_of(i)), determinant = i[9] * i[9] * i[10] * i[10] * (1 - cosine * cosine);
        return determinant < 1e-4f ? float(i[9] / PlainPair(i).distance(0)) : potential_of(i);
    };
    for (const float scale : {0x1p-40f, 0x1p-10f, 0x1p10f, 0x1p40f}) {
        Inputs scaled = in;
        for (const std::size_t length : {0, 1, 2, 9, 10}) scaled[length] *= scale;
        EXPECT_EQ(potential_of(scaled), potential_of(in)) << "scale " << scale;
        EXPECT_TRUE(scale > 1 || error(absolute(scaled), absolute(in)) > .02) << "scale " << scale;
    }
}

TEST(PublicBugs, ClosestPointFromAbsolutePositions)
{
    const Vector eye{131072, -65536, 131072}, light{131072.5f, -65535.75f, 131073.25f};  // exact in float; a metre apart, 200 km from the origin
    const Inputs in = pair_of({light.x - eye.x, light.y - eye.y, light.z - eye.z}, {.5f, .2f, -.6f}, 1, 1);
    const Vector a = eye_of(in), b = light_of(in);
    const float cosine = dot3(a, b), sine2 = 1 - cosine * cosine;
    const float absolute = ((dot3(light, a) - dot3(eye, a)) * cosine - (dot3(light, b) - dot3(eye, b))) / sine2;  // products with positions, then the difference
    EXPECT_GT(std::abs(absolute - ClosestPoints(in, false).v), 1e-3f) << "of a light that is 1 long";
    EXPECT_EQ(potential_of(in), potential_of(pair_of({.5f, .25f, 1.25f}, {.5f, .2f, -.6f}, 1, 1)));
    EXPECT_LT(error(potential_of(in), PlainPair(in).potential()), rounding);
}

TEST(PublicBugs, AreaHyperbolicSineAsALogarithm)
{
    const Inputs in = pair_of({.001f, 10, .5f}, {0, -1, 1}, 1);  // passes the line a thousandth beside it, 10 further on
    const auto as_logarithm = [](float x) { return std::log(x + std::sqrt(x * x + 1)); };
    const ClosestPoints closest(in, false);
    const float cosine = in[8], sine = std::sqrt(1 - cosine * cosine);
    const float wrong = (as_logarithm((in[9] - closest.v) * sine / closest.h) - as_logarithm(-closest.v * sine / closest.h)) / sine;
    EXPECT_LT(-closest.v * sine / closest.h, -3000);
    EXPECT_GT(error(wrong, PlainPair(in).potential()), .1);
    EXPECT_LT(error(potential_of(in), PlainPair(in).potential()), rounding);
}

TEST(PublicBugs, UniformDrawInsideALinearPiece)
{
    // The integral of r over [0, 1] by draws from a piece that rises from 1 to 9, weighted with the density of the line.
    const auto estimate = [](bool uniform) {
        double sum = 0;
        for (int i = 0; i < 4096; ++i) {
            const float xi = (i + .5f) / 4096, r = uniform ? xi : maths_float::sample_linear(1, 9, xi);
            sum += r / maths_float::pdf_linear(1, 9, r) / 4096;
        }
        return sum;
    };
    EXPECT_NEAR(estimate(false), .5, 1e-5);
    EXPECT_GT(std::abs(estimate(true) - .5), .02);
    // The product conditional is built of such pieces.
    const Vector p{.3f, .4f, .9f}, a{0, 0, 1}, b{.6f, 0, .8f};
    double sum = 0;
    for (int i = 0; i < 1 << 14; ++i) {
        const maths_float::PhaseWarp warp = maths_float::sample_phase_product(p, a, 2, b, {.9f, .7f, 0, 0, 0}, {10, 1, 0}, (i + .5f) / (1 << 14));
        sum += warp.x / warp.density / (1 << 14);
    }
    EXPECT_NEAR(sum, .5, 1e-3);
}

TEST(PublicBugs, NearlyParallelLightsDropped)
{
    for (const float theta : {2e-3f, 1e-4f, 1e-6f}) {
        const Inputs in = pair_of({.3f, .4f, .25f}, {theta, 0, 1});
        const auto dropping = [](const Inputs& i) { return std::abs(dot3(eye_of(i), light_of(i))) > std::cos(.18f * 3.14159265f / 180) ? 0.f : weight_of(i); };
        EXPECT_LT(error(mean_of(in, weight_of), PlainPair(in).transport()), rounding);
        EXPECT_EQ(mean_of(in, dropping), 0) << theta;
    }
}

TEST(PublicBugs, DivisionByTheCosine)
{
    const Inputs in = pair_of({.3f, .4f, .25f}, {1, 0, 0});
    const Vector q = origin_of(in), a = eye_of(in), b = light_of(in);
    const float cosine = dot3(a, b), closest = (dot3(q, a) - dot3(q, b) / cosine) / (1 / cosine - cosine);
    EXPECT_FALSE(std::isfinite(closest));
    EXPECT_LT(error(mean_of(in, weight_of), PlainPair(in).transport()), rounding);
}

TEST(PublicBugs, TwiceTheAreaHyperbolicTangentAsALogarithm)
{
    const Inputs in = pair_of({1, 0, .5f}, {-1, 0, 0}, 2);  // crosses the eye line: s L = D0 + D1
    const PlainPair pair(in);
    const float D0 = float(pair.distance(0)), D1 = float(pair.distance(in[9])), z = in[9] / (D0 + D1);
    EXPECT_EQ(z, 1) << "which it never is for lines that miss each other, unless rounded";
    EXPECT_FALSE(std::isfinite(std::log1p(2 * z / (1 - z))));
    const float ours = potential_of(in), floor = 2 * std::numeric_limits<float>::epsilon();
    EXPECT_TRUE(std::isfinite(ours));
    EXPECT_LT(ours, 2 * std::log(4 / floor)) << "that of a light which passes at the floor's distance";
}

}  // namespace
}  // namespace tyndall::test
