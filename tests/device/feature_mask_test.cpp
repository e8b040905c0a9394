/// A feature removes work; it never changes an image: every superset of what a scene calls for gives the same sums within rounding.
#include <gtest/gtest.h>

#include <cmath>

#include "device/pair_stage.hpp"
#include "kernels/shared/host_features.hpp"
#include "tests/device/random_pairs.hpp"

namespace tyndall {
namespace {

constexpr std::uint32_t needs_host = feature_bit::occluders | feature_bit::nonconvex_media;

std::vector<double> sums(Device& device, const testing::RandomPairs& pairs, EyeKind kind, std::uint32_t mask, int sampler = SAMPLER_PAPER_ISOTROPIC)
{
    PairStage stage(device, {.eyes = kind, .features = mask, .lanes = 16, .sampler = sampler}, pairs.tables);
    return (mask & feature_bit::occluders) ? testing::sampled_and_accumulated(stage, pairs, kind, 1) : testing::gathered(stage, pairs, kind, 1000, 1024);
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b, const std::string& what)
{
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 2e-5 * b[i]) << what << " at " << i;
}

TEST(FeatureMask, EverySingleSupersetGivesTheSameSums)
{
    Device device;
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
        const auto pairs = testing::random_pairs({.eyes = 32, .lights = 100}, true);  // a container that holds every segment
        const auto own = sums(device, pairs, kind, 0);
        std::uint32_t all = 0;
        for (const SceneFeature& feature : scene_feature_list) {
            if (feature.bit == feature_bit::nonconvex_media) continue;  // leaves transmittance to the host: tested with the pipeline
            expect_same(sums(device, pairs, kind, feature.bit), own, std::string(feature.name));
            all |= feature.bit;
        }
        expect_same(sums(device, pairs, kind, all & ~needs_host), own, "all that the device does alone");
    }
}

TEST(FeatureMask, EverySingleSupersetGivesTheSameSumsByATable)
{
    Device device;
    const auto pairs = testing::random_pairs({.eyes = 32, .lights = 100}, true);
    const auto own = sums(device, pairs, EyeKind::segments, 0, SAMPLER_TABLE_3X2);
    for (const std::uint32_t mask : {feature_bit::anisotropic, feature_bit::coloured, feature_bit::short_lights, feature_bit::boundaries})
        expect_same(sums(device, pairs, EyeKind::segments, mask, SAMPLER_TABLE_3X2), own, "mask " + std::to_string(mask));
}

TEST(FeatureMask, LeavingOutWhatIsNeededChangesTheSums)
{
    Device device;
    const auto pairs = testing::random_pairs({.eyes = 32, .lights = 100, .g = .6, .coloured = true});
    const auto right = sums(device, pairs, EyeKind::segments, feature_bit::anisotropic | feature_bit::coloured);
    for (const std::uint32_t mask : {feature_bit::anisotropic, feature_bit::coloured}) {
        const auto wrong = sums(device, pairs, EyeKind::segments, mask);
        double worst = 0;
        for (std::size_t i = 0; i < right.size(); ++i) worst = std::max(worst, std::abs(wrong[i] / right[i] - 1));
        EXPECT_GT(worst, .01);
    }
    const auto blends = testing::random_pairs({.eyes = 32, .lights = 100, .lobes = true});
    const auto blended = sums(device, blends, EyeKind::segments, feature_bit::anisotropic | feature_bit::phase_lobes);
    const auto one_lobe = sums(device, blends, EyeKind::segments, feature_bit::anisotropic);
    for (std::size_t i = 0; i < blended.size(); i += 3) EXPECT_GT(std::abs(one_lobe[i] / blended[i] - 1), 1e-3) << "one lobe of the mean cosine is no blend";
}

TEST(FeatureMask, NamesAndBitsAreDistinct)
{
    std::uint32_t seen = 0;
    for (const SceneFeature& feature : scene_feature_list) {
        EXPECT_EQ(seen & feature.bit, 0u) << feature.name;
        seen |= feature.bit;
        EXPECT_FALSE(feature.meaning.empty());
    }
}

}  // namespace
}  // namespace tyndall
