// The scenes that are shipped load without a complaint, and call for the effects that their README files promise, and no others.
#include <gmock/gmock.h>

#include "kernels/shared/host_features.hpp"
#include "scene/load_scene.hpp"
#include "scene/scene_features.hpp"

using namespace tyndall;

namespace {

Scene shipped(const std::string& name) { return load_scene(std::filesystem::path(TYNDALL_SOURCE_DIR) / "scenes" / name / "scene.xml"); }

}  // namespace

class ShippedScene : public testing::TestWithParam<const char*> {};

TEST_P(ShippedScene, LoadsWithoutWarning)
{
    const Scene scene = shipped(GetParam());
    EXPECT_THAT(scene.warnings, testing::IsEmpty());
    EXPECT_EQ(scene.camera.filter.type, Filter::Type::box);
    EXPECT_TRUE(features_of(scene).scattering_media);
}

TEST_P(ShippedScene, TakesItsDepthFromTheCommandLine)
{
    const auto file = std::filesystem::path(TYNDALL_SOURCE_DIR) / "scenes" / GetParam() / "scene.xml";
    EXPECT_EQ(load_scene(file).max_depth, -1);
    EXPECT_EQ(load_scene(file, {.definitions = {{"max_depth", "3"}}}).max_depth, 3);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, testing::Values("fruit_juice", "cornell_fog", "fog_and_slit", "six_vrls", "glossy_medium", "backlit_smoke", "plume", "crossing_rays", "forward_fog", "glass_of_juice", "smoky_room", "turning_light"),
                         [](const auto& info) { return std::string(info.param); });

TEST(ShippedScenes, NothingBlocksAConnectionInTheFruitJuice)
{
    const SceneFeatures features = features_of(shipped("fruit_juice"));
    EXPECT_EQ(features.media_to_media, feature_bit::anisotropic | feature_bit::coloured);
    EXPECT_EQ(features.media_to_surface, feature_bit::anisotropic | feature_bit::coloured | feature_bit::boundaries);
    ASSERT_EQ(features.containers.size(), 1u);
    EXPECT_EQ(features.containers.front().planes.size(), 48u) << "46 sides and 2 caps: the two triangles of a side must share one plane";
}

TEST(ShippedScenes, SixVirtualRayLightsNeedNoVisibility)
{
    const SceneFeatures features = features_of(shipped("six_vrls"));
    EXPECT_EQ(features.media_to_media, 0u);
    EXPECT_FALSE(features.receiving_surfaces);
}

TEST(ShippedScenes, WallsAndBlocksCastShadowsInFog)
{
    for (const char* name : {"cornell_fog", "fog_and_slit"}) {
        const SceneFeatures features = features_of(shipped(name));
        EXPECT_TRUE(features.media_to_media & feature_bit::occluders) << name;
        EXPECT_TRUE(features.media_to_surface & feature_bit::occluders) << name;
    }
}

TEST(ShippedScenes, NothingBlocksAConnectionInTheGlossyMedium)
{
    const SceneFeatures features = features_of(shipped("glossy_medium"));
    EXPECT_EQ(features.media_to_media, feature_bit::anisotropic + 0u);
    EXPECT_EQ(features.media_to_surface, feature_bit::anisotropic | feature_bit::boundaries);
    ASSERT_EQ(features.containers.size(), 1u);
    EXPECT_EQ(features.containers.front().planes.size(), 12u) << "the three triangles of a face must share one plane";
}

TEST(ShippedScenes, BoardsBlockConnectionsToTheGroundAndNoneInTheSmoke)
{
    const SceneFeatures features = features_of(shipped("backlit_smoke"));
    EXPECT_EQ(features.media_to_media, feature_bit::anisotropic + 0u);
    EXPECT_EQ(features.media_to_surface, feature_bit::anisotropic | feature_bit::boundaries | feature_bit::occluders);
    ASSERT_EQ(features.containers.size(), 1u);
    EXPECT_EQ(features.containers.front().planes.size(), 18u);
}

TEST(ShippedScenes, NothingButDensityStandsInTheWayInThePlume)
{
    const SceneFeatures features = features_of(shipped("plume"));
    EXPECT_EQ(features.media_to_media, feature_bit::heterogeneous | feature_bit::anisotropic);
    EXPECT_EQ(features.media_to_surface, feature_bit::heterogeneous | feature_bit::anisotropic | feature_bit::boundaries);
    ASSERT_EQ(features.containers.size(), 1u);
    EXPECT_EQ(features.containers.front().planes.size(), 6u);
}
