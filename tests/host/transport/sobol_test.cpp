// Sobol points against those of another program (SciPy 1.x, stats.qmc.Sobol, 32 bits), and what scrambling must keep and must change.
#include "transport/sobol.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace tyndall {
namespace {

TEST(Sobol, IsWhatAnotherProgramGives)
{
    const std::pair<std::uint32_t, std::array<std::uint32_t, sobol_dimensions>> expected[] = {
        {2, {1073741824u, 3221225472u, 3221225472u, 3221225472u, 1073741824u, 1073741824u, 3221225472u, 1073741824u, 1073741824u}},
        {5, {2684354560u, 536870912u, 3758096384u, 2684354560u, 2684354560u, 3758096384u, 536870912u, 536870912u, 536870912u}},
        {77, {2986344448u, 2046820352u, 4261412864u, 1375731712u, 1778384896u, 2248146944u, 3456106496u, 1644167168u, 436207616u}},
        {1000, {398458880u, 692060160u, 1933574144u, 3904897024u, 4265607168u, 700448768u, 71303168u, 2747269120u, 4290772992u}}};
    for (const auto& [index, point] : expected)
        for (std::size_t d = 0; d < sobol_dimensions; ++d) EXPECT_EQ(sobol(index, d), point[d]) << "point " << index << ", dimension " << d;
}

/// Do 2^k numbers of 32 bits lie one in each of 2^k equal intervals?
bool stratified(const std::vector<std::uint32_t>& x, unsigned k)
{
    std::set<std::uint32_t> intervals;
    for (const std::uint32_t value : x) intervals.insert(value >> (32 - k));
    return intervals.size() == x.size();
}

TEST(Sobol, ScrambledStaysStratifiedInEveryDimension)
{
    for (std::size_t d = 0; d < sobol_dimensions; ++d)
        for (const std::uint32_t key : {0u, 1u, 0xdeadbeefu}) {
            std::vector<std::uint32_t> x;
            for (std::uint32_t i = 0; i < 1024; ++i) x.push_back(scrambled(sobol(i, d), key));
            EXPECT_TRUE(stratified(x, 10)) << "dimension " << d << ", key " << key;
            std::vector<std::uint32_t> window;
            for (std::uint32_t i = 3 * 256; i < 4 * 256; ++i) window.push_back(x[i]);
            EXPECT_TRUE(stratified(window, 8));
        }
}

TEST(Sobol, FirstTwoDimensionsFillEveryElementaryRectangle)
{
    for (unsigned across = 0; across <= 8; ++across) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
        for (std::uint32_t i = 0; i < 256; ++i)
            cells.insert({across ? scrambled(sobol(i, 0), 17) >> (32 - across) : 0, across < 8 ? scrambled(sobol(i, 1), 4242) >> (24 + across) : 0});
        EXPECT_EQ(cells.size(), 256u) << across;
    }
}

TEST(Sobol, ScramblingIsABijectionAndMakesEveryPointUniform)
{
    std::set<std::uint32_t> images;
    for (std::uint32_t x = 0; x < 1u << 12; ++x) images.insert(scrambled(x << 20, 99));
    EXPECT_EQ(images.size(), 1u << 12);
    for (const std::uint32_t x : {0u, 1u << 31, 0x12345678u}) {
        std::vector<int> counts(64);
        for (std::uint64_t key = 0; key < 64000; ++key) ++counts[scrambled(x, static_cast<std::uint32_t>(mix_bits(key) >> 32)) >> 26];
        double chi = 0;
        for (const int count : counts) chi += (count - 1000.) * (count - 1000.) / 1000;
        EXPECT_LT(chi, 63 + 5 * std::sqrt(126.)) << x;
    }
}

TEST(EvenSequence, IsUniformAndEvenAndThenIndependent)
{
    constexpr std::uint64_t paths = 4096;
    std::vector<double> even_mean(12), square(12);
    for (std::uint64_t i = 0; i < paths; ++i) {
        EvenSequence random(7, 3, RandomStream::light_path, i, true);
        for (std::size_t d = 0; d < 12; ++d) {
            const double x = random.next();
            ASSERT_TRUE(x >= 0 && x < 1);
            even_mean[d] += x / paths, square[d] += x * x / paths;
        }
    }
    for (std::size_t d = 0; d < sobol_dimensions; ++d) {
        EXPECT_NEAR(even_mean[d], .5, 1. / paths) << "one in each interval: off by at most half of one";
        EXPECT_NEAR(square[d], 1 / 3., 2. / paths);
    }
    for (std::size_t d = sobol_dimensions; d < 12; ++d) EXPECT_NEAR(even_mean[d], .5, 5 * std::sqrt(1 / 12. / paths));
}

TEST(EvenSequence, ChangesWithSeedPassAndStream)
{
    std::set<double> firsts;
    for (const std::uint64_t seed : {1u, 2u})
        for (const std::uint64_t pass : {0u, 1u})
            for (const RandomStream stream : {RandomStream::light_path, RandomStream::pilot}) firsts.insert(EvenSequence(seed, pass, stream, 5, true).next());
    EXPECT_EQ(firsts.size(), 8u);
    EvenSequence off(1, 0, RandomStream::light_path, 5, false);
    RandomSequence plain(1, 0, RandomStream::light_path, 5);
    for (int i = 0; i < 20; ++i) EXPECT_EQ(off.next(), plain.next());
}

}  // namespace
}  // namespace tyndall
