/// Connections through density grids on the device: their mean equals a quadrature that shares no code with kernels/, for every way of drawing them, every
/// lane width and both ways to find transmittances; what must not depend on tiles, lanes or masks does not; degenerate pairs stay finite.
#include "tests/device/grid_pairs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "kernels/shared/host_features.hpp"

namespace tyndall {
namespace {

using testing::gathered;
using testing::grid_pairs;
using testing::GridWishes;
using testing::RandomPairs;

Device& device()
{
    static Device one;
    return one;
}

std::uint32_t mask_of(const GridWishes& w)
{
    return feature_bit::heterogeneous | (w.g != 0 ? feature_bit::anisotropic : 0u) | (w.coloured ? feature_bit::coloured | feature_bit::coloured_grids : 0u) |
           (w.short_lights ? feature_bit::short_lights : 0u) | (w.homogeneous_beside ? feature_bit::many_media | feature_bit::boundaries | feature_bit::coloured : 0u);
}

PairProgram program(EyeKind kind, const GridWishes& w, int lanes, int transmittance, std::uint32_t samples = 1)
{
    return {.eyes = kind, .features = mask_of(w), .lanes = lanes, .sampler = w.g != 0 && kind == EyeKind::segments ? SAMPLER_PAPER : SAMPLER_PAPER_ISOTROPIC, .samples = samples,
            .transmittance = transmittance};
}

/// Mean and its standard error over batches with keys of their own.
struct Estimate {
    std::vector<double> mean, error;
};
Estimate estimate(PairStage& stage, RandomPairs pairs, EyeKind kind, std::uint32_t samples)
{
    constexpr int batches = 24;
    std::vector<double> sum(48), square(48);
    for (int batch = 0; batch < batches; ++batch) {
        for (EyeSegment& eye : pairs.segments) eye.key = eye.key * 0x9e3779b1u + 77u;
        for (EyePoint& eye : pairs.points) eye.key = eye.key * 0x9e3779b1u + 77u;
        const auto sums = gathered(stage, pairs, kind, 1000, 1024);
        for (std::size_t i = 0; i < 48; ++i) sum[i] += sums[i] / samples, square[i] += sums[i] / samples * sums[i] / samples;
    }
    Estimate e;
    for (std::size_t i = 0; i < 48; ++i) {
        e.mean.push_back(sum[i] / batches);
        e.error.push_back(std::sqrt(std::max(square[i] / batches - e.mean[i] * e.mean[i], 0.) / (batches - 1)));
    }
    return e;
}

/// Every eye and channel lies within its error; all eyes together do so more sharply. The 16 eyes share choices, so theirs are not independent.
void expect_unbiased(const Estimate& e, const std::vector<double>& oracle, const std::string& what)
{
    double squares = 0, ours = 0, theirs = 0, error = 0;
    for (std::size_t i = 0; i < oracle.size(); ++i) {
        if (oracle[i] == 0) {
            EXPECT_EQ(e.mean[i], 0) << what << ", eye " << i / 3 << ": all lights are behind the surface";
            continue;
        }
        const double z = (e.mean[i] - oracle[i]) / e.error[i];
        squares += z * z / double(oracle.size());
        ours += e.mean[i] / oracle[i] / double(oracle.size()), theirs += 1. / double(oracle.size()), error += e.error[i] / oracle[i] / double(oracle.size());
        EXPECT_LT(std::abs(z), 5.5) << what << ", eye " << i / 3 << " channel " << i % 3 << ": " << e.mean[i] << " +- " << e.error[i] << " against " << oracle[i];
    }
    EXPECT_LT(squares, 2.5) << what;
    EXPECT_LT(std::abs(ours - theirs), 3 * error) << what;
    EXPECT_LT(error, .02) << what << ": too noisy to prove anything";
}

const GridWishes all_wishes[] = {{},
                                 {.extinction = 8},
                                 {.g = .6, .coloured = true, .albedo = true, .short_lights = true},
                                 {.extinction = 5, .albedo = true, .holes = true},
                                 {.g = .4, .extinction = 3, .homogeneous_beside = true},
                                 {.extinction = 8, .short_lights = true, .holes = true}};

std::string name_of(std::size_t wishes, EyeKind kind, int transmittance)
{
    return "wishes " + std::to_string(wishes) + (kind == EyeKind::segments ? ", segments, " : ", points, ") + (transmittance == TRANSMITTANCE_EXACT ? "exact" : "march");
}

class GridPairsOfEveryKind : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(GridPairs, GridPairsOfEveryKind, ::testing::Range(std::size_t(0), std::size(all_wishes)));

TEST_P(GridPairsOfEveryKind, TheirMeanIsTheExactTransport)
{
    constexpr std::uint32_t samples = 1000;
    const GridWishes& wishes = all_wishes[GetParam()];
    const RandomPairs pairs = grid_pairs(wishes);
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
        const std::vector<double> oracle = testing::grid_oracle(pairs, kind);
        for (const int transmittance : {TRANSMITTANCE_MARCH, TRANSMITTANCE_EXACT}) {
            PairStage stage(device(), program(kind, wishes, 16, transmittance, samples), pairs.tables);
            expect_unbiased(estimate(stage, pairs, kind, samples), oracle, name_of(GetParam(), kind, transmittance));
            EXPECT_EQ(stage.ledger().not_finite, 0u);
        }
    }
}

/// Largest difference, relative to the larger of the sum and a typical sum: contributions of both signs make small sums of large terms.
double worst_difference(const std::vector<double>& a, const std::vector<double>& b)
{
    double worst = 0, typical = 0;
    for (const double x : b) typical += std::abs(x) / double(b.size());
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]) / std::max(std::abs(b[i]), .1 * typical));
    return worst;
}

TEST(GridPairs, LaneWidthsAgreeWithinRounding)
{
    for (const std::size_t i : {std::size_t(2), std::size_t(4)})
        for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
            const int transmittance = i == 2 && kind == EyeKind::segments ? TRANSMITTANCE_EXACT : TRANSMITTANCE_MARCH;
            const RandomPairs pairs = grid_pairs(all_wishes[i]);
            PairStage wide(device(), program(kind, all_wishes[i], 16, transmittance, 40), pairs.tables);
            const auto expected = gathered(wide, pairs, kind, 1000, 1024);
            for (const int lanes : {1, 4, 8}) {
                PairStage narrow(device(), program(kind, all_wishes[i], lanes, transmittance, 40), pairs.tables);
                // Depths of up to 10 are sums of some 100 roundings of 6e-8: exp carries 1e-5 of them at worst.
                EXPECT_LT(worst_difference(gathered(narrow, pairs, kind, 1000, 1024), expected), 2e-5) << name_of(i, kind, transmittance) << ", " << lanes << " lanes";
            }
        }
}

/// Every light `times` times, and three times as many eyes, with keys of their own.
RandomPairs repeated(RandomPairs pairs, std::uint32_t times)
{
    const auto lights = pairs.lights;
    for (std::uint32_t i = 1; i < times; ++i) pairs.lights.insert(pairs.lights.end(), lights.begin(), lights.end());
    pairs.light_count *= times;
    for (int copy = 1; copy < 3; ++copy)
        for (std::size_t i = 0; i < 16; ++i) {
            pairs.segments.push_back(pairs.segments[i]), pairs.points.push_back(pairs.points[i]);
            pairs.segments.back().key += 101u * static_cast<uint>(copy), pairs.points.back().key += 101u * static_cast<uint>(copy);
        }
    return pairs;
}

TEST(GridPairs, TilesNeverChangeAByte)
{
    const RandomPairs pairs = repeated(grid_pairs(all_wishes[1]), 100);
    for (const int lanes : {4, 16}) {
        PairStage stage(device(), program(EyeKind::segments, all_wishes[1], lanes, TRANSMITTANCE_MARCH), pairs.tables);
        const auto whole = gathered(stage, pairs, EyeKind::segments, 1000, 1024);
        EXPECT_EQ(gathered(stage, pairs, EyeKind::segments, 1, 256), whole);
        EXPECT_EQ(gathered(stage, pairs, EyeKind::segments, 2, 512), whole);
        PairProgram split = program(EyeKind::segments, all_wishes[1], lanes, TRANSMITTANCE_MARCH);
        split.features |= feature_bit::occluders;
        PairStage shadowed(device(), split, pairs.tables);
        EXPECT_EQ(testing::sampled_and_accumulated(shadowed, pairs, EyeKind::segments, 16u / static_cast<std::uint32_t>(lanes)), whole);
    }
}

TEST(GridPairs, AConstantGridIsAHomogeneousMedium)
{
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points})
        for (const int transmittance : {TRANSMITTANCE_MARCH, TRANSMITTANCE_EXACT}) {
            RandomPairs pairs = testing::random_pairs({.g = .3, .coloured = true});
            const std::uint32_t mask = feature_bit::anisotropic | feature_bit::coloured;
            MediumRecord& m = pairs.tables.media[0];
            const auto scale = [&](float by) {
                for (float* sigma : {&m.sigma_t_r, &m.sigma_t_g, &m.sigma_t_b, &m.sigma_s_r, &m.sigma_s_g, &m.sigma_s_b}) *sigma *= by;
            };
            scale(.25f);
            PairStage even(device(), {.eyes = kind, .features = mask, .lanes = 16}, pairs.tables);
            const auto expected = gathered(even, pairs, kind, 1000, 1024);
            scale(2);
            m.density_grid = 0;
            pairs.tables.grids.push_back({1.5f, 0, 0, 1.5f, 0, 1.5f, 0, 1.5f, 0, 0, 1.5f, 1.5f, 3, 3, 3, 0});
            pairs.tables.voxels.assign(27, .5f);
            PairStage grid(device(), {.eyes = kind, .features = mask | feature_bit::heterogeneous, .lanes = 16, .transmittance = transmittance}, pairs.tables);
            // So thin that all is drawn by angle: the same places, and depths below 1 from 8 to 64 terms, each rounded by 6e-8.
            EXPECT_LT(worst_difference(gathered(grid, pairs, kind, 1000, 1024), expected), 5e-6);
        }
}

TEST(GridPairs, MoreFeaturesGiveTheSameSums)
{
    const RandomPairs pairs = grid_pairs({.extinction = 4, .albedo = true, .holes = true});
    const auto sums = [&](std::uint32_t mask) {
        PairStage stage(device(), {.eyes = EyeKind::segments, .features = mask, .lanes = 16, .samples = 20}, pairs.tables);
        return gathered(stage, pairs, EyeKind::segments, 1000, 1024);
    };
    const auto own = sums(feature_bit::heterogeneous);
    for (const std::uint32_t more : {feature_bit::coloured | feature_bit::coloured_grids, feature_bit::many_media | feature_bit::anisotropic,
                                     feature_bit::boundaries | feature_bit::short_lights | feature_bit::depth_limit})
        EXPECT_LT(worst_difference(sums(feature_bit::heterogeneous | more), own), 2e-5) << more;
    EXPECT_GT(worst_difference(sums(0), own), .1) << "without the grid the image is another one";
}

/// Pairs that meet, lie in each other, have no length, run along faces of the box, through nothing, or outside of it.
RandomPairs degenerate_pairs()
{
    RandomPairs pairs = grid_pairs({.extinction = 30, .coloured = true, .albedo = true});
    for (std::size_t i = 0; i < pairs.tables.voxels.size(); ++i)
        if (i % 7 < 3) pairs.tables.voxels[i] = 0;   // the half x < -1/7
    const auto set_eye = [&](std::size_t i, glm::vec3 o, glm::vec3 d, float length) {
        EyeSegment& e = pairs.segments[i];
        e.origin_x = o.x, e.origin_y = o.y, e.origin_z = o.z, e.direction_x = d.x, e.direction_y = d.y, e.direction_z = d.z, e.length = length;
        EyePoint& p = pairs.points[i];
        p.position_x = o.x, p.position_y = o.y, p.position_z = o.z, p.normal_x = p.facing_x = d.x, p.normal_y = p.facing_y = d.y, p.normal_z = p.facing_z = d.z;
    };
    const auto set_light = [&](std::size_t i, glm::vec3 o, glm::vec3 d, float length) {
        const float record[7] = {o.x, o.y, o.z, length, d.x, d.y, d.z};
        std::memcpy(pairs.lights.data() + 64 * i, record, sizeof record);
    };
    set_eye(0, {0, 0, 0}, {1, 0, 0}, .5f), set_eye(1, {-1, -1, -1}, {1, 0, 0}, 2), set_eye(2, {-.9f, 0, 0}, {0, 1, 0}, .5f), set_eye(3, {.5f, .5f, .5f}, {0, 0, 1}, 0);
    set_eye(4, {1, -1, 0}, {-0.f, 1, -0.f}, 2), set_eye(5, {2, 2, 2}, {0, 1, 0}, 1), set_eye(6, {-.95f, 0, 0}, {1, 0, 0}, 1.9f), set_eye(7, {1, 1, 1}, {-1, 0, 0}, 2);
    set_light(0, {.25f, -.25f, 0}, {0, 1, 0}, .5f), set_light(1, {0, 0, 0}, {1, 0, 0}, .5f), set_light(2, {-.9f, -.5f, 0}, {0, 1, 0}, .3f);
    set_light(3, {.5f, .5f, .5f}, {0, 0, 1}, 0), set_light(4, {-1, -1, -1}, {1, 0, 0}, 2), set_light(5, {1, -1, 0}, {0, 1, 0}, 2);
    return pairs;
}

class GridPairsAtEveryLaneWidth : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(GridPairs, GridPairsAtEveryLaneWidth, ::testing::Values(1, 4, 8, 16));

TEST_P(GridPairsAtEveryLaneWidth, DegeneratePairsAreFinite)
{
    const GridWishes wishes{.g = .8, .coloured = true, .albedo = true, .short_lights = true};
    const RandomPairs pairs = degenerate_pairs();
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
        PairStage stage(device(), program(kind, wishes, GetParam(), TRANSMITTANCE_MARCH, 500), pairs.tables);
        double sum = 0;
        for (const double x : gathered(stage, pairs, kind, 1000, 1024)) sum += x;
        EXPECT_TRUE(std::isfinite(sum));
        EXPECT_EQ(stage.ledger().not_finite, 0u) << (kind == EyeKind::segments ? "segments" : "points") << ", eye " << stage.ledger().first_eye << " counter " << stage.ledger().first_counter;
    }
}

TEST(GridPairs, APlantedErrorIsSeen)
{
    const RandomPairs pairs = grid_pairs({.extinction = 8});
    auto wrong = pairs;
    for (float& voxel : wrong.tables.voxels) voxel *= 1.05f;
    const auto oracle = testing::grid_oracle(pairs, EyeKind::points);
    PairStage stage(device(), program(EyeKind::points, {.extinction = 8}, 16, TRANSMITTANCE_MARCH, 1000), wrong.tables);
    const Estimate e = estimate(stage, wrong, EyeKind::points, 1000);
    double squares = 0;
    for (std::size_t i = 0; i < oracle.size(); ++i)
        if (oracle[i] > 0) squares += std::pow((e.mean[i] - oracle[i]) / e.error[i], 2) / double(oracle.size());
    EXPECT_GT(squares, 2.5);
}

}  // namespace
}  // namespace tyndall
