/// Eyes that share an estimate of the lights: every eye once, blocks of one square and one medium, groups that are spread over their block.
#include "tiling/eye_blocks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "device/pair_stage.hpp"

namespace tyndall {
namespace {

/// All pixels of a film, with one eye each; the right half is in another medium.
std::vector<EyePlace> film(int width, int height)
{
    std::vector<EyePlace> eyes;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) eyes.push_back({static_cast<std::uint32_t>(y * width + x), x < width / 2 ? 0u : 1u, 0});
    return eyes;
}

std::vector<std::uint32_t> eyes_of(const EyeBlocks& all, const EyeBlock& block)
{
    const auto first = all.order.begin() + block.first * eye_alignment;
    std::vector<std::uint32_t> eyes;
    for (auto i = first; i != first + block.groups * eye_alignment; ++i)
        if (*i != no_eye) eyes.push_back(*i);
    return eyes;
}

TEST(EyeBlocks, HoldEveryEyeOnceInWholeGroups)
{
    for (const int size : {4, 8, 16}) {
        const auto eyes = film(45, 23);
        const EyeBlocks all = block_eyes(eyes, {.width = 45, .size = size, .offset_x = 3, .offset_y = 1});
        EXPECT_EQ(all.order.size() % eye_alignment, 0u);
        std::multiset<std::uint32_t> seen;
        std::uint32_t next = 0;
        for (const EyeBlock& block : all.blocks) {
            EXPECT_EQ(block.first, next);
            next += block.groups;
            for (const std::uint32_t eye : eyes_of(all, block)) seen.insert(eye);
        }
        EXPECT_EQ(next * eye_alignment, all.order.size());
        EXPECT_EQ(seen.size(), eyes.size());
        EXPECT_EQ(std::set<std::uint32_t>(seen.begin(), seen.end()).size(), eyes.size());
    }
}

TEST(EyeBlocks, AreSquaresOfOneMediumAndTheirGroupsAreNotNeighbours)
{
    const auto eyes = film(64, 32);
    const EyeBlocks all = block_eyes(eyes, {.width = 64, .size = 8});
    EXPECT_EQ(all.blocks.size(), 32u);
    for (const EyeBlock& block : all.blocks) {
        const auto inside = eyes_of(all, block);
        EXPECT_EQ(inside.size(), 64u);
        for (std::size_t i = 0; i < inside.size(); ++i) {
            EXPECT_EQ(inside[i] % 64 / 8, inside[0] % 64 / 8);
            EXPECT_EQ(inside[i] / 64 / 8, inside[0] / 64 / 8);
            EXPECT_EQ(eyes[inside[i]].medium, eyes[inside[0]].medium);
            for (std::size_t j = i / 16 * 16; j < i; ++j) EXPECT_NE(inside[i], inside[j] + 1) << "neighbours in one group";
        }
    }
}

TEST(EyeBlocks, LieInRegionsOfOneMediumAndDepth)
{
    std::vector<EyePlace> eyes = film(200, 150);
    for (EyePlace& eye : eyes) eye.depth = eye.pixel % 200 / 90;
    const EyeBlocks all = block_eyes(eyes, {.width = 200, .size = 4, .offset_x = 3, .offset_y = 2, .region = 16});
    ASSERT_FALSE(all.regions.empty());
    std::set<std::array<std::uint32_t, 4>> seen;
    for (std::size_t r = 0; r < all.regions.size(); ++r) {
        const std::size_t last = r + 1 < all.regions.size() ? all.regions[r + 1] : all.blocks.size();
        std::set<std::array<std::uint32_t, 4>> here;
        for (std::size_t b = all.regions[r]; b < last; ++b)
            for (const std::uint32_t eye : eyes_of(all, all.blocks[b])) here.insert({(eye % 200 + 3) / 64, (eye / 200 + 2) / 64, eyes[eye].medium, eyes[eye].depth});
        EXPECT_EQ(here.size(), 1u);
        EXPECT_TRUE(seen.insert(*here.begin()).second) << "a region comes once";
    }
    EXPECT_EQ(all.regions.front(), 0u);
    EXPECT_GT(seen.size(), 12u) << "4 x 3 squares of 64 pixels, some of two media or depths";
}

TEST(EyeBlocks, StandForTheirMiddle)
{
    const EyeBlocks all = block_eyes(film(64, 32), {.width = 64, .size = 8});
    for (const std::uint32_t eye : all.standing) {
        EXPECT_NEAR(double(eye % 64 % 8), 3.5, .51);
        EXPECT_NEAR(double(eye / 64 % 8), 3.5, .51);
    }
}

TEST(EyeBlocks, StandForLongSegmentsAtASilhouette)
{
    auto eyes = film(8, 8);
    for (EyePlace& eye : eyes) {
        const std::uint32_t x = eye.pixel % 8;
        eye.medium = 0, eye.length = x < 6 ? .1f : x == 6 ? .8f : 1;  // the middle hardly touches what the right edge looks through
    }
    const EyeBlocks all = block_eyes(eyes, {.width = 8, .size = 8});
    ASSERT_EQ(all.standing.size(), 1u);
    EXPECT_EQ(eyes[all.standing[0]].pixel % 8, 6u) << "of the long ones the nearest to the middle";
    const std::uint32_t row = eyes[all.standing[0]].pixel / 8;
    EXPECT_TRUE(row == 3 || row == 4) << row;
}

TEST(EyeBlocks, KeepPiecesOfOnePathApart)
{
    std::vector<EyePlace> eyes;
    for (std::uint32_t pixel = 0; pixel < 64; ++pixel)
        for (int piece = 0; piece < 3; ++piece) eyes.push_back({pixel, piece == 1 ? 1u : 0u, 0});  // medium 0, 1, 0 along every ray
    const EyeBlocks all = block_eyes(eyes, {.width = 8, .size = 8});
    EXPECT_EQ(all.blocks.size(), 3u);
    for (const EyeBlock& block : all.blocks) {
        std::set<std::uint32_t> pixels;
        for (const std::uint32_t eye : eyes_of(all, block)) pixels.insert(eyes[eye].pixel);
        EXPECT_EQ(pixels.size(), 64u) << "each pixel once";
    }
}

TEST(EyeBlocks, OfSeveralCameraSamplesShareAStandingEyeAndAKey)
{
    std::vector<EyePlace> eyes;
    for (std::uint32_t sample = 0; sample < 3; ++sample)
        for (std::uint32_t pixel = 0; pixel < 256; ++pixel)
            if (sample != 1 || pixel % 16 < 8) eyes.push_back({pixel, 0, 0, sample});  // the second sample misses the medium in the right half
    const EyeBlocks all = block_eyes(eyes, {.width = 16, .size = 8, .key = 3, .samples = 3});
    EXPECT_EQ(all.standing.size(), 4u);
    ASSERT_EQ(all.blocks.size(), 10u);
    for (const EyeBlock& block : all.blocks) {
        EXPECT_EQ(block.parts, 3u);
        for (const std::uint32_t eye : eyes_of(all, block)) {
            EXPECT_EQ(eyes[eye].sample, block.part);
            const std::uint32_t standing = eyes[all.standing[block.standing]].pixel, pixel = eyes[eye].pixel;
            EXPECT_EQ(standing / 16 / 8 * 2 + standing % 16 / 8, pixel / 16 / 8 * 2 + pixel % 16 / 8) << "in the same square";
        }
        for (const EyeBlock& other : all.blocks) EXPECT_EQ(block.key == other.key, block.standing == other.standing);
    }
}

TEST(EyeBlocks, HaveKeysOfTheirOwn)
{
    std::set<std::uint32_t> keys;
    for (const std::uint32_t key : {1u, 2u})
        for (const EyeBlock& block : block_eyes(film(256, 256), {.width = 256, .size = 4, .key = key}).blocks) keys.insert(block.key);
    EXPECT_GT(keys.size(), 2 * 4096u - 8u) << "of 8192, a chance pair or two may agree";
    EXPECT_TRUE(block_eyes({}, {}).blocks.empty());
}

}  // namespace
}  // namespace tyndall
