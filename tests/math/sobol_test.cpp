// Scrambled Sobol points: the two dimensions against Sobol's direction numbers, the nets that they form before and after scrambling, the scramble's nesting, and
// that each point alone is uniform. Counts are integers: where there is no statistics there is no tolerance.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "kernels/dialect_host.hpp"
#include "tests/support/chi_square.hpp"

namespace tyndall::test {
namespace {

using maths_float::mirrored_bits;
using maths_float::nested_scramble;
using maths_float::Random2;
using maths_float::scrambled_sobol2;

/// Sobol's second dimension by its recurrence: the primitive polynomial 1 + x gives v_1 = 1/2, v_(k+1) = v_k xor v_k / 2.
std::uint32_t second_by_direction_numbers(std::uint32_t index)
{
    std::uint32_t direction = 0x80000000u, result = 0;
    for (; index; index >>= 1, direction ^= direction >> 1)
        if (index & 1) result ^= direction;
    return result;
}
std::uint32_t mirrored_slowly(std::uint32_t x)
{
    std::uint32_t result = 0;
    for (int i = 0; i < 32; ++i) result |= ((x >> i) & 1u) << (31 - i);
    return result;
}

TEST(Sobol, SecondDimensionFollowsTheDirectionNumbers)
{
    for (std::uint32_t i = 0; i < 100000; ++i) {
        const std::uint32_t index = i < 50000 ? i : i * 2654435761u;
        ASSERT_EQ(mirrored_bits(maths_float::sobol_second(index)), second_by_direction_numbers(index)) << index;
        ASSERT_EQ(mirrored_bits(index), mirrored_slowly(index));
    }
}

/// Every box 2^-i x 2^(i - m) holds exactly one of the points first ... first + 2^m - 1.
void expect_net(std::uint32_t key, std::uint32_t first, int m)
{
    for (int i = 0; i <= m; ++i) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> boxes;
        for (std::uint32_t k = 0; k < (1u << m); ++k) {
            const Random2 xi = scrambled_sobol2(key, first + k);
            boxes.emplace(std::uint32_t(std::ldexp(xi.first, i)), std::uint32_t(std::ldexp(xi.second, m - i)));
        }
        EXPECT_EQ(boxes.size(), std::size_t(1) << m) << "key " << key << " from " << first << ": boxes of 2^-" << i;
    }
}

TEST(Sobol, EveryAlignedRunIsANetUnderEveryKey)
{
    for (const std::uint32_t key : {0u, 1u, 77u, 0x80000000u, 0xffffffffu})
        for (const int m : {1, 2, 3, 4, 6, 8, 10})
            for (const std::uint32_t run : {0u, 1u, 5u, 1000u}) expect_net(key, run << m, m);
}

/// Nested: the first n digits of the result follow from the first n of the argument (mirrored: the lowest n bits), and each n digits occur once.
TEST(Sobol, ScrambleIsNested)
{
    for (std::uint32_t seed = 1; seed < 2000; seed += 37)
        for (const int n : {1, 5, 12}) {
            const std::uint32_t mask = (1u << n) - 1, hashed = maths_float::mix_scalar(seed);
            std::set<std::uint32_t> images;
            for (std::uint32_t x = 0; x <= mask; ++x) {
                const std::uint32_t image = nested_scramble(x, hashed) & mask;
                images.insert(image);
                ASSERT_EQ(nested_scramble(x | (maths_float::mix_scalar(x) << n), hashed) & mask, image) << "later digits change earlier ones";
            }
            ASSERT_EQ(images.size(), std::size_t(mask) + 1) << "not a bijection of " << n << " digits";
        }
}

/// Over seeds, each digit is flipped half the time whatever the digits before it, and flips of one digit behind different prefixes are independent: correlation within
/// 5.5 standard deviations, 2000 such tests.
TEST(Sobol, FlipsAreFairAndIndependentBetweenPrefixes)
{
    constexpr int seeds = 1 << 14;
    for (int digit = 1; digit < 9; ++digit) {
        const std::uint32_t prefixes = 1u << std::min(digit, 4);
        std::vector<std::vector<int>> flips(prefixes);
        for (std::uint32_t prefix = 0; prefix < prefixes; ++prefix)
            for (std::uint32_t seed = 0; seed < seeds; ++seed) {
                const std::uint32_t x = prefix << (digit - std::min(digit, 4));
                flips[prefix].push_back(int((nested_scramble(x, maths_float::mix_scalar(seed)) ^ x) >> digit & 1u) * 2 - 1);
            }
        for (std::uint32_t i = 0; i < prefixes; ++i) {
            double sum = 0;
            for (const int f : flips[i]) sum += f;
            EXPECT_LT(std::abs(sum), 5.5 * std::sqrt(seeds)) << "digit " << digit << " behind " << i;
            for (std::uint32_t j = 0; j < i; ++j) {
                double product = 0;
                for (int k = 0; k < seeds; ++k) product += flips[i][std::size_t(k)] * flips[j][std::size_t(k)];
                EXPECT_LT(std::abs(product), 5.5 * std::sqrt(seeds)) << "digit " << digit << " behind " << i << " and " << j;
            }
        }
    }
}

constexpr std::uint32_t draws = 1u << 20;
template <class F>
double grid_p(F&& pair)
{
    std::vector<double> counts(64 * 64), expected(64 * 64, draws / 4096.);
    for (std::uint32_t i = 0; i < draws; ++i) {
        const auto [x, y] = pair(i);
        counts[std::size_t(x * 64) * 64 + std::size_t(y * 64)] += 1;
    }
    return chi_square_p(counts, expected);
}

TEST(Sobol, EachPointAloneIsUniformOverTheKeys)
{
    for (const std::uint32_t index : {0u, 1u, 2u, 3u, 17u, 1023u, 0x80000000u, 0xffffffffu})
        EXPECT_GT(grid_p([&](std::uint32_t key) { const Random2 r = scrambled_sobol2(key, index); return std::pair{r.first, r.second}; }), false_alarm_rate) << index;
}

/// Points of different keys know nothing of each other.
TEST(Sobol, NeighbouringKeysAreIndependent)
{
    EXPECT_GT(grid_p([](std::uint32_t key) { return std::pair{scrambled_sobol2(key, 5).first, scrambled_sobol2(key + 1, 5).first}; }), false_alarm_rate);
    EXPECT_GT(grid_p([](std::uint32_t key) { return std::pair{scrambled_sobol2(key, 5).second, scrambled_sobol2(key + 1, 5).second}; }), false_alarm_rate);
}

TEST(Sobol, StaysBelowOneAndIsTheSameInBothPrecisions)
{
    for (std::uint32_t i = 0; i < 100000; ++i) {
        const Random2 r = scrambled_sobol2(i * 2654435761u, i);
        ASSERT_TRUE(r.first >= 0 && r.first < 1 && r.second >= 0 && r.second < 1);
        const auto d = maths_double::scrambled_sobol2(i * 2654435761u, i);
        ASSERT_TRUE(double(r.first) == d.first && double(r.second) == d.second);
    }
}

/// What it is for: the mean of 16 points of a smooth function scatters far less over keys than that of 16 random ones, around the same mean.
TEST(Sobol, MeansScatterLessAroundTheSameMean)
{
    const auto f = [](Random2 r) { return std::exp(r.first) * (1 + r.second * r.second); };
    const double truth = (std::exp(1) - 1) * 4 / 3;
    double sobol = 0, squares = 0, random_squares = 0;
    constexpr std::uint32_t keys = 20000;
    for (std::uint32_t key = 0; key < keys; ++key) {
        double a = 0, b = 0;
        for (std::uint32_t i = 0; i < 16; ++i) a += f(scrambled_sobol2(key, i)) / 16, b += f(maths_float::random2(key, i)) / 16;
        sobol += a / keys, squares += (a - truth) * (a - truth) / keys, random_squares += (b - truth) * (b - truth) / keys;
    }
    EXPECT_NEAR(sobol, truth, 5 * std::sqrt(squares / keys));
    EXPECT_LT(squares, .05 * random_squares);
}

}  // namespace
}  // namespace tyndall::test
