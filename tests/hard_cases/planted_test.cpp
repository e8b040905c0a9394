// The tables find errors: the textbook's formulas, in float, miss the rows that were made for them, and an error of the claimed size is seen.
#include <gtest/gtest.h>

#include "tests/hard_cases/check_row.hpp"

namespace tyndall::test {
namespace {

/// Share of the cases of a row for which `output` (a function of a case) misses the interval of its output k.
template <class F>
double share_missed(const HardRow<float>& row, std::size_t k, F&& output)
{
    std::size_t missed = 0;
    for (const HardCase<float>& c : row.cases) {
        const float x = output(c);
        missed += !(std::isfinite(x) && c.expected[k].holds(Big(x)));
    }
    return double(missed) / double(row.cases.size());
}

struct Vector {
    float x, y, z;
};
float dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector at(const HardCase<float>& c, std::size_t i) { return {c.in[i], c.in[i + 1], c.in[i + 2]}; }

/// The talk's marginal: closest points by the normal equations, h, and the difference of two asinh.
float potential_of_the_talk(const HardCase<float>& c)
{
    const Vector q = at(c, 0), a = at(c, 3), b = at(c, 6);
    const float cosine = dot(a, b), sine = std::sqrt(1 - cosine * cosine);
    const float v_closest = (dot(q, a) * cosine - dot(q, b)) / (1 - cosine * cosine), u_closest = dot(q, a) + v_closest * cosine;
    const Vector d{q.x + v_closest * b.x - u_closest * a.x, q.y + v_closest * b.y - u_closest * a.y, q.z + v_closest * b.z - u_closest * a.z};
    const float h = std::sqrt(dot(d, d));
    return (std::asinh((c.in[9] - v_closest) * sine / h) - std::asinh(-v_closest * sine / h)) / sine;
}

/// Equi-angular sampling as published: the difference of two arc tangents.
float angle_as_published(const HardCase<float>& c)
{
    const Vector p = at(c, 0), a = at(c, 3);
    const float foot = dot(p, a), D = std::sqrt(std::max(dot(p, p) - foot * foot, 0.f));
    return std::atan((c.in[6] - foot) / D) - std::atan(-foot / D);
}

float phase_as_published(const HardCase<float>& c)
{
    const float g = c.in[6], base = 1 + g * g - 2 * g * dot(at(c, 0), at(c, 3));
    return (1 - g * g) / (4 * 3.14159265f * base * std::sqrt(base));
}

float distance_as_published(const HardCase<float>& c) { return -std::log(1 - c.in[2] * (1 - std::exp(-c.in[0] * c.in[1]))) / c.in[0]; }

TEST(HardCasesFind, TheTalksMarginalInRows1And2And6)
{
    EXPECT_GT(share_missed(row01<float>(), 0, potential_of_the_talk), .9);
    EXPECT_GT(share_missed(row02<float>(), 0, potential_of_the_talk), .9);
    EXPECT_GT(share_missed(row06<float>(), 0, potential_of_the_talk), .9);
}

TEST(HardCasesFind, ThePublishedEquiangularFormInRows10And11)
{
    EXPECT_GT(share_missed(row10<float>(), 1, angle_as_published), .5);
    EXPECT_GT(share_missed(row11<float>(), 1, angle_as_published), .5);
}

TEST(HardCasesFind, ThePublishedPhaseFunctionInRow14) { EXPECT_GT(share_missed(row14<float>(), 0, phase_as_published), .5); }

TEST(HardCasesFind, ThePublishedDistanceInRow17) { EXPECT_GT(share_missed(row17<float>(), 0, distance_as_published), .4); }

/// An error of twice the bound (which is in epsilons) in each output that has one is found in most cases.
TEST(HardCasesFind, ErrorsOfTwiceTheBound)
{
    const auto wrong = [](std::size_t k, float relative) {
        return [=](const HardCase<float>& c) { return evaluate_on_host<float>(c.sampler, c.in)[k] * (1 + relative); };
    };
    const float e = epsilon<float>;
    EXPECT_GT(share_missed(row01<float>(), 0, wrong(0, 12 * e)), .9);
    EXPECT_GT(share_missed(row07<float>(), 0, wrong(0, 12 * e)), .9);
    EXPECT_GT(share_missed(row11<float>(), 1, wrong(1, 12 * e)), .9);
    EXPECT_GT(share_missed(row11<float>(), 2, wrong(2, 12 * e)), .9);
    EXPECT_GT(share_missed(row14<float>(), 0, wrong(0, 12 * e)), .9);
    EXPECT_GT(share_missed(row15<float>(), 1, wrong(1, 12 * e)), .7);
    EXPECT_GT(share_missed(row39<float>(), 1, wrong(1, 32 * e)), .9);
}

/// A NaN or an infinity never lies in an interval.
TEST(HardCasesFind, WhatIsNotFinite)
{
    EXPECT_EQ(share_missed(row13<float>(), 0, [](const HardCase<float>&) { return std::nanf(""); }), 1);
    EXPECT_EQ(share_missed(row28<float>(), 0, [](const HardCase<float>&) { return INFINITY; }), 1);
}

}  // namespace
}  // namespace tyndall::test
