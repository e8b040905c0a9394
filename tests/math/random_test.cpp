// random2: uniform, in [0, 1), its two numbers and its neighbours in key and counter independent. False alarm 1e-6 per test.
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "kernels/dialect_host.hpp"
#include "tests/support/chi_square.hpp"

namespace tyndall::test {
namespace {

using maths_float::random2;
using maths_float::Random2;

/// chi^2 of pairs (x, y) over a grid of 64 x 64.
template <class F>
double grid_p(std::uint32_t draws, F&& pair)
{
    std::vector<double> counts(64 * 64), expected(64 * 64, draws / 4096.);
    for (std::uint32_t i = 0; i < draws; ++i) {
        const auto [x, y] = pair(i);
        counts[std::size_t(x * 64) * 64 + std::size_t(y * 64)] += 1;
    }
    return chi_square_p(counts, expected);
}

constexpr std::uint32_t draws = 1u << 20;

TEST(Random, BothNumbersAreIndependentAlongCounters)
{
    for (const std::uint32_t key : {0u, 1u, 17u, 0x80000000u, 0xffffffffu})
        EXPECT_GT(grid_p(draws, [&](std::uint32_t i) { const Random2 r = random2(key, i); return std::pair{r.first, r.second}; }), false_alarm_rate) << key;
}

TEST(Random, BothNumbersAreIndependentAlongKeys)
{
    for (const std::uint32_t counter : {0u, 1u, 17u, 0x80000000u, 0xffffffffu})
        EXPECT_GT(grid_p(draws, [&](std::uint32_t i) { const Random2 r = random2(i, counter); return std::pair{r.first, r.second}; }), false_alarm_rate) << counter;
}

TEST(Random, NeighboursInKeyAndInCounterAreIndependent)
{
    EXPECT_GT(grid_p(draws, [](std::uint32_t i) { return std::pair{random2(i, 5).first, random2(i + 1, 5).first}; }), false_alarm_rate);
    EXPECT_GT(grid_p(draws, [](std::uint32_t i) { return std::pair{random2(9, i).first, random2(9, i + 1).first}; }), false_alarm_rate);
    EXPECT_GT(grid_p(draws, [](std::uint32_t i) { return std::pair{random2(9, i).second, random2(9, i + 1).second}; }), false_alarm_rate);
    EXPECT_GT(grid_p(draws, [](std::uint32_t i) { return std::pair{random2(i, 3).second, random2(i, 4).second}; }), false_alarm_rate);
    EXPECT_GT(grid_p(draws, [](std::uint32_t i) { return std::pair{random2(i & 1023, i >> 10).first, random2(i >> 10, i & 1023).first}; }), false_alarm_rate);
}

TEST(Random, LowBitsOfBothAreFairToo)
{
    const auto low = [](float x) { return float(std::uint32_t(x * 0x1p24f) & 63) / 64; };
    EXPECT_GT(grid_p(draws, [&](std::uint32_t i) { const Random2 r = random2(i, 2); return std::pair{low(r.first), low(r.second)}; }), false_alarm_rate);
    EXPECT_GT(grid_p(draws, [&](std::uint32_t i) { const Random2 r = random2(2, i); return std::pair{low(r.first), low(r.second)}; }), false_alarm_rate);
}

/// Flipping one bit of key or counter flips each of the 24 bits of both numbers half the time: 65,536 trials each, 5.5 standard deviations
/// (2 x 24 x 64 bits, each alarming at 4e-8: 1e-4 in all).
TEST(Random, EveryBitOfKeyAndCounterReachesEveryBitOfBothNumbers)
{
    constexpr int trials = 1 << 16;
    for (int flipped = 0; flipped < 64; ++flipped) {
        std::array<int, 48> changed{};
        for (int i = 0; i < trials; ++i) {
            const std::uint32_t key = std::uint32_t(i) * 2654435761u + 7u, counter = std::uint32_t(i) * 40503u;
            const Random2 r = random2(key, counter), s = flipped < 32 ? random2(key ^ (1u << flipped), counter) : random2(key, counter ^ (1u << (flipped - 32)));
            const auto first = std::uint32_t(r.first * 0x1p24f) ^ std::uint32_t(s.first * 0x1p24f), second = std::uint32_t(r.second * 0x1p24f) ^ std::uint32_t(s.second * 0x1p24f);
            for (int bit = 0; bit < 24; ++bit) changed[bit] += (first >> bit) & 1, changed[24 + bit] += (second >> bit) & 1;
        }
        for (const int count : changed) EXPECT_NEAR(count, trials / 2, 5.5 * std::sqrt(trials) / 2) << "bit " << flipped;
    }
}

TEST(Random, StaysBelowOneAndReachesBothEnds)
{
    float least = 1, most = 0;
    for (std::uint32_t i = 0; i < (1u << 26); ++i) {
        const Random2 r = random2(i, 0);
        least = std::min({least, r.first, r.second}), most = std::max({most, r.first, r.second});
    }
    EXPECT_GE(least, 0);
    EXPECT_LT(most, 1);
    EXPECT_LT(least, 0x1p-22f);
    EXPECT_GT(most, 1 - 0x1p-22f);
}

TEST(Random, IsTheSameInBothPrecisions)
{
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_EQ(double(random2(i, 3).first), maths_double::random2(i, 3).first);
}

}  // namespace
}  // namespace tyndall::test
