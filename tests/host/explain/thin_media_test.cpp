/// How little thin media scatter twice: the bound, and what is left out because of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "pipeline/render.hpp"
#include "scene/scene_features.hpp"
#include "scene/thin_media.hpp"
#include "scene_parts.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;

const double cube_diagonal = 2 * std::sqrt(3.);  // of Mitsuba's cube, [-1, 1]^3

Scene box_of(const std::string& sigma_t, const std::string& albedo = "1") { return scene_of({medium("fog", sigma_t, albedo), lamp(), container("cube", "box", here)}); }

const LayerReport& media_to_media_of(const Report& report)
{
    return *std::find_if(report.layers.begin(), report.layers.end(), [](const LayerReport& l) { return l.layer == "media_to_media"; });
}

TEST(ThinMedia, DepthIsTheScatteringCoefficientTimesTheDiagonal)
{
    const ScatteredAgain again = scattered_again(box_of(".002", ".5"));
    EXPECT_NEAR(again.depth, .002 * .5 * cube_diagonal, 1e-15);
    EXPECT_NEAR(again.share, .002 * .5 * cube_diagonal, 1e-5);
    EXPECT_EQ(again.where.line, 2);
    EXPECT_NEAR(scattered_again(box_of(".001, .002, .004", ".5")).depth, .004 * .5 * cube_diagonal, 1e-15) << "the channel that scatters most";
    EXPECT_NEAR(scattered_again(box_of("1e4")).share, 1, 1e-15);
}

TEST(ThinMedia, MediaAddUpAndShapesOfOneMediumShareABox)
{
    const std::string left = R"(<translate x="-3"/>)", right = R"(<translate x="3"/>)";
    const Scene two = scene_of({medium("fog", ".001", "1"), medium("mist", ".01", "1"), lamp(), container("cube", "left", left), container("cube", "right", right, "mist")});
    EXPECT_NEAR(scattered_again(two).depth, .011 * cube_diagonal, 1e-14);
    EXPECT_EQ(scattered_again(two).where.line, 3) << "the medium that decides";
    const Scene one = scene_of({medium("fog", ".001", "1"), lamp(), container("cube", "left", left), container("cube", "right", right)});
    EXPECT_NEAR(scattered_again(one).depth, .001 * 2 * std::sqrt(16 + 1 + 1.), 1e-14) << "a line may cross both";
}

TEST(ThinMedia, WhatHasNoEndHasNoBound)
{
    const std::string sheet = shape("rectangle", "sheet", here, R"(<bsdf type="null"/><ref name="interior" id="fog"/>)");
    for (const Scene& scene : {scene_of({medium("fog", "1e-9"), lamp(in_fog)}, in_fog), scene_of({medium("fog", "1e-9"), lamp(), sheet})}) {
        EXPECT_EQ(scattered_again(scene).share, 1);
        EXPECT_THAT(scattered_again(scene).why, HasSubstr("no end"));
    }
}

TEST(ThinMedia, NothingScattersNothingAgain)
{
    EXPECT_EQ(scattered_again(box_of("5", "0")).share, 0);
    EXPECT_EQ(scattered_again(scene_of({lamp()})).share, 0);
}

/// The bound beside the truth: light that starts anywhere in the box, in any direction, and scatters before it leaves.
TEST(ThinMedia, IsABoundOfWhatAWalkFinds)
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> in_box(-1, 1), unit(0, 1);
    const double sigma_s = .05;
    double scattered = 0;
    constexpr int walks = 100000;
    for (int i = 0; i < walks; ++i) {
        const double p[3] = {in_box(random), in_box(random), in_box(random)}, z = in_box(random), turn = 6.283185307179586 * unit(random);
        const double d[3] = {std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
        double way = 1e9;
        for (int k = 0; k < 3; ++k) way = std::min(way, ((d[k] > 0 ? 1 : -1) - p[k]) / d[k]);
        scattered += -std::expm1(-sigma_s * way);
    }
    const double bound = scattered_again(box_of(".05")).share;
    EXPECT_LT(scattered / walks, bound);
    EXPECT_GT(scattered / walks, bound / 5) << "of a use";
}

TEST(ThinMedia, AreAFactOfTheScene)
{
    const auto found = [](const Scene& scene) {
        const SceneFeatures features = features_of(scene, false, -1);
        return std::find_if(features.effects.begin(), features.effects.end(), [](const Effect& e) { return e.row.name == "OPTICALLY_THIN"; })->found;
    };
    EXPECT_TRUE(found(box_of(".001")));
    EXPECT_FALSE(found(box_of(".01")));
    EXPECT_FALSE(found(box_of("5", "0"))) << "a medium that does not scatter is not thin: it has nothing to leave out";
}

TEST(ThinMedia, AreLeftOutOnlyWhereTheSettingAllowsIt)
{
    RenderSettings settings;
    settings.passes = 2, settings.lights = 64, settings.layers = {}, settings.layers.add(Layer::media_to_media);
    const Scene scene = box_of(".001");
    const LayerReport kept = media_to_media_of(render(scene, settings).report);
    EXPECT_FALSE(kept.skipped);
    settings.skip_thin = .003;  // below the bound, .00346
    EXPECT_FALSE(media_to_media_of(render(scene, settings).report).skipped);
    settings.skip_thin = .004;
    const Report report = render(scene, settings).report;
    const LayerReport& left_out = media_to_media_of(report);
    EXPECT_TRUE(left_out.skipped);
    EXPECT_FALSE(left_out.unbiased);
    EXPECT_NEAR(left_out.left_out, scattered_again(scene).share, 1e-15);
    EXPECT_THAT(left_out.why, HasSubstr("at most 0.35 % of the light that media scatter is scattered by them again (allowed: 0.4 %)"));
    EXPECT_EQ(report.pairs, 0u);
}

}  // namespace
}  // namespace tyndall::test
