/// Lights chosen on the device for blocks of eyes: every light as often as its weight says, sums that stay what they are, and nothing that breaks it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device/pair_stage.hpp"
#include "kernels/shared/host_features.hpp"
#include "tests/device/random_pairs.hpp"

namespace tyndall {
namespace {

using testing::random_pairs;
using testing::RandomPairs;

Device& device()
{
    static Device one;
    return one;
}

class SelectionAtEveryLaneWidth : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(LightSelection, SelectionAtEveryLaneWidth, ::testing::Values(1, 4, 8, 16));

/// Squares of `groups` groups of 16 neighbouring eyes for each of `parts` camera samples.
struct Blocks {
    std::vector<EyeBlock> blocks;
    std::vector<std::byte> standing;
    std::uint32_t count = 0;

    template <typename Eye>
    Blocks(const std::vector<Eye>& eyes, std::uint32_t groups, std::uint32_t key, std::uint32_t parts)
    {
        std::vector<Eye> records;
        for (std::uint32_t first = 0; first < eyes.size() / 16; first += groups * parts) {
            for (std::uint32_t part = 0; part < parts; ++part)
                blocks.push_back({first + part * groups, groups, key + 7919 * first, static_cast<std::uint32_t>(records.size()), part, parts, 0, 0});
            records.push_back(eyes[first * 16]);
        }
        while (records.size() % 16 != 0) records.push_back(records.back());
        const auto bytes = std::as_bytes(std::span(records));
        standing.assign(bytes.begin(), bytes.end()), count = static_cast<std::uint32_t>(records.size());
    }
    LightSelection selection(std::uint32_t slots, float defence = .1f) const
    {
        return {.standing = standing, .standing_count = count, .blocks = blocks, .slots = slots, .defence = defence};
    }
};

std::span<const std::byte> eyes_of(const RandomPairs& pairs, EyeKind kind)
{
    return kind == EyeKind::segments ? std::as_bytes(std::span(pairs.segments)) : std::as_bytes(std::span(pairs.points));
}

Blocks blocks_of(const RandomPairs& pairs, EyeKind kind, std::uint32_t groups, std::uint32_t key, std::uint32_t parts = 1)
{
    return kind == EyeKind::segments ? Blocks(pairs.segments, groups, key, parts) : Blocks(pairs.points, groups, key, parts);
}

PairProgram program(EyeKind kind, std::uint32_t features, int lanes) { return {.eyes = kind, .features = features, .lanes = lanes, .selection = true}; }

std::vector<LightChoice> choices(PairStage& stage, const RandomPairs& pairs, EyeKind kind, const LightSelection& selection, std::uint32_t vertex_limit = 0xffffffffu)
{
    stage.begin(eyes_of(pairs, kind), static_cast<std::uint32_t>(pairs.segments.size()), pairs.lights, vertex_limit);
    stage.select(selection);
    return stage.chosen();
}

/// Sums of the weights that every light is chosen with: by group, then light.
std::vector<double> weight_sums(const std::vector<LightChoice>& chosen, std::uint32_t slots, std::uint32_t lights)
{
    std::vector<double> sums(chosen.size() / slots * lights);
    for (std::size_t i = 0; i < chosen.size(); ++i) sums[i / slots * lights + chosen[i].light] += double(chosen[i].weight);
    return sums;
}

// The sum of the weights that a light is chosen with is 1 on average, for every light and every group by itself; 1 / parts in each of several parts.
TEST_P(SelectionAtEveryLaneWidth, EveryLightCountsOnceOnAverage)
{
    constexpr std::uint32_t lights = 60, slots = 8;
    constexpr int repeats = 3000;
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points})
        for (const std::uint32_t parts : {1u, 4u}) {
            const auto pairs = random_pairs({.eyes = 64, .lights = lights, .g = .9});
            PairStage stage(device(), program(kind, feature_bit::anisotropic, GetParam()), pairs.tables);
            std::vector<double> sum(4 * lights), squares(4 * lights);
            for (int repeat = 0; repeat < repeats; ++repeat) {
                const Blocks blocks = blocks_of(pairs, kind, 4 / parts, 0x9e3779b9u * static_cast<std::uint32_t>(repeat), parts);
                const auto count = weight_sums(choices(stage, pairs, kind, blocks.selection(slots)), slots, lights);
                for (std::size_t i = 0; i < count.size(); ++i) sum[i] += count[i] * parts, squares[i] += count[i] * parts * count[i] * parts;
            }
            double chi = 0;
            for (std::size_t i = 0; i < sum.size(); ++i) {
                const double mean = sum[i] / repeats, variance = squares[i] / repeats - mean * mean, z = (mean - 1) / std::sqrt(std::max(variance, 1e-12) / repeats);
                EXPECT_LT(std::abs(z), 5.5) << "group " << i / lights << ", light " << i % lights << ": " << mean;
                chi += z * z;
            }
            EXPECT_LT(chi, 240 + 5 * std::sqrt(2 * 240.)) << "240 of them together";
        }
}

// Camera samples of a square of pixels share its strata: together they take a light about as often as its share says, as one sample does.
TEST_P(SelectionAtEveryLaneWidth, PartsTogetherTakeEveryStratum)
{
    const auto pairs = random_pairs({.eyes = 64, .lights = 300});
    PairStage stage(device(), program(EyeKind::segments, 0, GetParam()), pairs.tables);
    const auto chosen = choices(stage, pairs, EyeKind::segments, blocks_of(pairs, EyeKind::segments, 1, 5, 4).selection(16));
    std::vector<double> weights(300), counts(300);
    for (const LightChoice& choice : chosen) weights[choice.light] = double(choice.weight), counts[choice.light] += 1;
    for (std::size_t light = 0; light < 300; ++light)
        EXPECT_LT(counts[light] > 0 ? std::abs(counts[light] - 1 / weights[light]) : 0, 2) << "light " << light;
}

// Strata of one group: a light is chosen once more or less often than its share says, never worse.
TEST_P(SelectionAtEveryLaneWidth, ALightIsChosenAboutAsOftenAsItsShare)
{
    const auto pairs = random_pairs({.eyes = 64, .lights = 300});
    PairStage stage(device(), program(EyeKind::segments, 0, GetParam()), pairs.tables);
    constexpr std::uint32_t slots = 64;
    const auto chosen = choices(stage, pairs, EyeKind::segments, blocks_of(pairs, EyeKind::segments, 4, 5).selection(slots));
    ASSERT_EQ(chosen.size(), 4 * slots);
    for (std::size_t group = 0; group < 4; ++group) {
        std::vector<double> weights(300), counts(300);
        for (std::size_t i = group * slots; i < (group + 1) * slots; ++i) weights[chosen[i].light] = double(chosen[i].weight), counts[chosen[i].light] += 1;
        for (std::size_t light = 0; light < 300; ++light)
            EXPECT_LT(counts[light] > 0 ? std::abs(counts[light] - 1 / weights[light]) : 0, 2) << "light " << light;
    }
}

/// Eyes of every group of 16 side by side, as those of neighbouring pixels are.
RandomPairs neighbours(RandomPairs pairs)
{
    for (std::size_t i = 0; i < pairs.segments.size(); ++i) {
        const float shift = .002f * static_cast<float>(i % 16);
        const uint segment_key = pairs.segments[i].key, point_key = pairs.points[i].key;
        pairs.segments[i] = pairs.segments[i / 16 * 16], pairs.points[i] = pairs.points[i / 16 * 16];
        pairs.segments[i].origin_x += shift, pairs.points[i].position_y += shift;
        pairs.segments[i].key = segment_key, pairs.points[i].key = point_key;
    }
    return pairs;
}

/// Mean and variance of that mean of every sum of a stage, over repeats with other random numbers; slots 0: all lights.
struct Scatter {
    std::vector<double> mean, variance;
};
Scatter scatter(PairStage& stage, RandomPairs pairs, EyeKind kind, std::uint32_t slots, float defence, std::uint32_t seed)
{
    constexpr int repeats = 300;
    Scatter s{std::vector<double>(192), std::vector<double>(192)};
    for (int i = 0; i < repeats; ++i) {
        for (auto& eye : pairs.segments) eye.key += seed;
        for (auto& eye : pairs.points) eye.key += seed;
        stage.begin(eyes_of(pairs, kind), 64, pairs.lights, 0xffffffffu);
        const Blocks blocks = blocks_of(pairs, kind, 1, seed * static_cast<std::uint32_t>(i + 1));
        if (slots > 0) stage.select(blocks.selection(slots, defence));
        stage.gather({0, stage.groups(), 0, slots > 0 ? slots : pairs.light_count});
        const auto sums = stage.sums();
        for (std::size_t k = 0; k < sums.size(); ++k) s.mean[k] += sums[k] / repeats, s.variance[k] += sums[k] * sums[k] / repeats;
    }
    for (std::size_t k = 0; k < s.mean.size(); ++k) s.variance[k] = (s.variance[k] - s.mean[k] * s.mean[k]) / (repeats - 1);
    return s;
}

// The estimate is there to lower the variance: a sum over chosen lights is closer to the sum over all than one over lights chosen by power alone.
TEST_P(SelectionAtEveryLaneWidth, SumsAgreeWithAllLightsAndTheEstimateHelps)
{
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
        const auto pairs = neighbours(random_pairs({.eyes = 64, .lights = 300, .g = .55, .coloured = true}));
        const std::uint32_t features = feature_bit::anisotropic | feature_bit::coloured;
        PairStage all(device(), {.eyes = kind, .features = features, .lanes = GetParam()}, pairs.tables), stage(device(), program(kind, features, GetParam()), pairs.tables);
        const Scatter expected = scatter(all, pairs, kind, 0, 0, 0x85ebca6bu), chosen = scatter(stage, pairs, kind, 32, .1f, 0xc2b2ae35u),
                      by_power = scatter(stage, pairs, kind, 32, 1.f, 0x27d4eb2fu);
        double noise = 0, noise_by_power = 0;
        for (std::size_t k = 0; k < 192; ++k) {
            if (expected.mean[k] <= 0) continue;
            EXPECT_LT(std::abs(chosen.mean[k] - expected.mean[k]), 5 * std::sqrt(chosen.variance[k] + expected.variance[k])) << "sum " << k;
            noise += chosen.variance[k] / (expected.mean[k] * expected.mean[k]), noise_by_power += by_power.variance[k] / (expected.mean[k] * expected.mean[k]);
        }
        EXPECT_LT(noise, .5 * noise_by_power);
    }
}

// Candidates for a region, and what squares choose among them, still count every light once on average.
TEST_P(SelectionAtEveryLaneWidth, EveryCandidateCountsOnceOnAverage)
{
    constexpr std::uint32_t lights = 60, first = 10, count = 45, slots = 12;
    constexpr int repeats = 3000;
    const auto pairs = random_pairs({.eyes = 64, .lights = lights, .g = .9});
    PairStage stage(device(), program(EyeKind::segments, feature_bit::anisotropic, GetParam()), pairs.tables);
    stage.offer(pairs.lights, 0xffffffffu);
    const std::span<const std::byte> standing = eyes_of(pairs, EyeKind::segments).first(eye_alignment * sizeof(EyeSegment));
    std::vector<double> sum(lights), squares(lights);
    for (std::uint32_t repeat = 0; repeat < repeats; ++repeat) {
        const auto drawn = stage.candidates({.standing = standing, .standing_count = eye_alignment, .blocks = {}, .slots = slots}, first, count, 0x9e3779b9u * repeat);
        const auto of_light = weight_sums(drawn, slots, lights);
        for (std::size_t i = 0; i < lights; ++i) sum[i] += of_light[i], squares[i] += of_light[i] * of_light[i];
    }
    for (std::uint32_t i = 0; i < lights; ++i) {
        const double mean = sum[i] / repeats, variance = squares[i] / repeats - mean * mean, expected = i >= first && i < first + count ? 1 : 0;
        EXPECT_LE(std::abs(mean - expected), 5.5 * std::sqrt(variance / repeats)) << "light " << i;
    }
}

// Lights that count for more are chosen more often, and what is chosen carries what they count for.
TEST_P(SelectionAtEveryLaneWidth, WeightsOfCandidatesAreCarriedOn)
{
    constexpr std::uint32_t lights = 40, slots = 20;
    constexpr int repeats = 2000;
    const auto pairs = random_pairs({.eyes = 16, .lights = lights});
    PairStage stage(device(), program(EyeKind::segments, 0, GetParam()), pairs.tables);
    std::vector<float> weights(lights);
    for (std::uint32_t i = 0; i < lights; ++i) weights[i] = .25f * static_cast<float>(1 + i % 7);
    std::vector<double> sum(lights), squares(lights);
    for (std::uint32_t repeat = 0; repeat < repeats; ++repeat) {
        stage.begin(eyes_of(pairs, EyeKind::segments), 16, pairs.lights, 0xffffffffu, weights);
        stage.select(blocks_of(pairs, EyeKind::segments, 1, 0x9e3779b9u * repeat).selection(slots));
        const auto of_light = weight_sums(stage.chosen(), slots, lights);
        for (std::size_t i = 0; i < lights; ++i) sum[i] += of_light[i], squares[i] += of_light[i] * of_light[i];
    }
    for (std::uint32_t i = 0; i < lights; ++i) {
        const double mean = sum[i] / repeats, variance = squares[i] / repeats - mean * mean;
        EXPECT_LE(std::abs(mean - double(weights[i])), 5.5 * std::sqrt(variance / repeats)) << "light " << i;
    }
}

TEST_P(SelectionAtEveryLaneWidth, PathsThatAreTooLongAreNeverChosen)
{
    auto pairs = random_pairs({.eyes = 32, .lights = 200});
    for (auto& eye : pairs.segments) eye.depth = 1;
    PairStage stage(device(), program(EyeKind::segments, feature_bit::depth_limit, GetParam()), pairs.tables);
    // Light i has depth i % 4: with limit 4 depths 0 and 1 may join an eye of depth 1.
    for (const LightChoice& choice : choices(stage, pairs, EyeKind::segments, blocks_of(pairs, EyeKind::segments, 2, 1).selection(64), 4)) {
        EXPECT_LE(choice.light % 4, 1u);
        EXPECT_GT(choice.weight, 0);
    }
    for (const LightChoice& choice : choices(stage, pairs, EyeKind::segments, blocks_of(pairs, EyeKind::segments, 2, 1).selection(64), 2)) EXPECT_EQ(choice.weight, 0) << "none may";
}

TEST_P(SelectionAtEveryLaneWidth, DegenerateAndBrokenLightsDoNoHarm)
{
    auto pairs = random_pairs({.eyes = 32, .lights = 256, .g = .9});
    testing::degenerate(pairs);
    testing::set_flux(pairs, 7, std::numeric_limits<float>::quiet_NaN());
    testing::set_flux(pairs, 8, std::numeric_limits<float>::infinity());
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
        PairStage stage(device(), program(kind, feature_bit::anisotropic, GetParam()), pairs.tables);
        for (const LightChoice& choice : choices(stage, pairs, kind, blocks_of(pairs, kind, 1, 3).selection(100))) {
            EXPECT_LT(choice.light, 256u);
            EXPECT_TRUE(std::isfinite(choice.weight) && choice.weight > 0);
        }
    }
}

TEST_P(SelectionAtEveryLaneWidth, WithoutAnyLightOrAnyPowerNothingIsAdded)
{
    auto none = random_pairs({.eyes = 16, .lights = 0});
    PairStage stage(device(), program(EyeKind::segments, 0, GetParam()), none.tables);
    stage.begin(eyes_of(none, EyeKind::segments), 16, none.lights, 0xffffffffu);
    stage.select(blocks_of(none, EyeKind::segments, 1, 3).selection(100));
    for (const double x : stage.sums()) EXPECT_EQ(x, 0);
}

TEST_P(SelectionAtEveryLaneWidth, SamplingAndAccumulatingEqualsGathering)
{
    const std::uint32_t row = 16u / static_cast<std::uint32_t>(GetParam());
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
        const auto pairs = random_pairs({.eyes = 48, .lights = 300});
        PairStage fused(device(), program(kind, 0, GetParam()), pairs.tables), split(device(), program(kind, feature_bit::occluders, GetParam()), pairs.tables);
        const Blocks blocks = blocks_of(pairs, kind, 3, 3);
        choices(fused, pairs, kind, blocks.selection(40));
        fused.gather({0, fused.groups(), 0, 40});
        choices(split, pairs, kind, blocks.selection(40));
        for (std::uint32_t group = 0; group < split.groups(); group += row) {
            split.sample(0, {group, row, 0, 40});
            split.sampled(0);
            split.accumulate(0);
        }
        EXPECT_EQ(split.sums(), fused.sums());
    }
}

}  // namespace
}  // namespace tyndall
