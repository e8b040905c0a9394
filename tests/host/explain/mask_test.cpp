/// A feature removes work, it never changes an image: shipped and reference scenes with their own masks, with single further features, which the scenes share out between them
/// (EVERY_VARIANT: with each), and with all of them.
#include <gtest/gtest.h>

#include <bit>

#include "kernels/shared/host_features.hpp"
#include "pipeline/pass_renderer.hpp"
#include "scene/load_scene.hpp"
#include "support/every_variant.hpp"
#include "support/feature_cover.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {
namespace {

constexpr Layer connected[] = {Layer::media_to_media, Layer::media_to_surface};
constexpr const char* scene_files[] = {"scenes/cornell_fog/scene.xml", "scenes/fog_and_slit/scene.xml", "scenes/fruit_juice/scene.xml", "scenes/six_vrls/scene.xml",
                                       "scenes/glossy_medium/scene.xml", "scenes/backlit_smoke/scene.xml", "scenes/plume/scene.xml",
                                       "tests/images/scenes/a_cornell_iso.xml", "tests/images/scenes/b_juice_spot.xml", "tests/images/scenes/i_bounded_fog.xml",
                                       "tests/images/scenes/d_plume_iso.xml"};

/// A scene of the repository on a film of 16 x 16 pixels.
Scene scene_at(const std::string& path)
{
    Scene scene = load_scene(std::string(TYNDALL_SOURCE_DIR) + "/" + path);
    scene.camera.width = scene.camera.height = scene.camera.crop_width = scene.camera.crop_height = 16;
    scene.camera.crop_x = scene.camera.crop_y = 0;
    return scene;
}

PassImage rendered(const Scene& scene, std::uint32_t to_media, std::uint32_t to_surface, GridTransmittance transmittance = GridTransmittance::march)
{
    RenderSettings settings{.layers = LayerSet().add(Layer::media_to_media).add(Layer::media_to_surface), .passes = 1, .lights = 48, .seed = 3};
    settings.transmittance = transmittance;
    PassRenderer renderer(scene, settings, BuildMasks{to_media, to_surface});
    return renderer.render(0).image;
}

/// The largest relative difference of a pixel; pixels below a millionth of the largest one count as that large.
double difference(const PassImage& a, const PassImage& b, Layer layer)
{
    double largest = 0, worst = 0;
    for (const Rgb& value : b[layer]) largest = std::max({largest, value.r, value.g, value.b});
    EXPECT_EQ(a[layer].size(), b[layer].size());
    if (a[layer].size() != b[layer].size()) return 1;
    for (std::size_t i = 0; i < b[layer].size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (a[layer][i][c] != b[layer][i][c]) worst = std::max(worst, std::abs(a[layer][i][c] - b[layer][i][c]) / std::max(b[layer][i][c], 1e-6 * largest));
    return worst;
}

class Mask : public testing::TestWithParam<const char*> {};

// 3e-5: contributions of positive light add up, so a pixel is as exact as its connections. One connection's optical depth is wrong by at most some 4 ulp of
// render space's size, 5e-7, times an extinction of at most 20 per unit; the functions after it add a few ulp of their own.
constexpr double rounding = 3e-5;

TEST_P(Mask, EverySupersetGivesTheSameImage)
{
    const Scene scene = scene_at(GetParam());
    const SceneFeatures features = features_of(scene, false, scene.max_depth);
    const PassImage marched = rendered(scene, features.media_to_media, features.media_to_surface);
    const bool grids = features.media_to_media & feature_bit::heterogeneous;
    const PassImage exact = grids ? rendered(scene, features.media_to_media, features.media_to_surface, GridTransmittance::exact) : marched;
    const auto to_media = supersets_of(features.media_to_media), to_surface = supersets_of(features.media_to_surface);
    const std::size_t number = place_in(scene_files, std::string_view(GetParam())), last = std::max(to_media.size(), to_surface.size()) - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        const std::uint32_t masks[] = {to_media[std::min(i, to_media.size() - 1)], to_surface[std::min(i, to_surface.size() - 1)]};
        const auto feature = static_cast<std::size_t>(std::countr_zero(masks[0] & ~features.media_to_media));
        if (i != last && (feature + number) % 4 != 0 && !every_variant()) continue;
        // The host's walk knows the exact transmittance of a connection; a march through a grid is another estimate of it.
        const bool walked = (masks[0] | masks[1]) & feature_bit::nonconvex_media;
        const PassImage& own = walked ? exact : marched;
        const PassImage image = rendered(scene, masks[0], masks[1], walked ? GridTransmittance::exact : GridTransmittance::march);
        for (int l = 0; l < 2; ++l)
            if (!own[connected[l]].empty()) { EXPECT_LT(difference(image, own, connected[l]), rounding) << name(connected[l]) << " with " << feature_names(masks[l]); }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Mask,
                         testing::ValuesIn(scene_files),
                         [](const auto& info) {
                             std::string words = info.param;
                             for (char& c : words) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                             return words;
                         });

/// Planted errors: a mask that lacks what the scene needs. These are programs that the superset tests build too.
TEST(WrongMask, ChangesTheImageOfTheLayerThatNeedsTheFeature)
{
    const Scene slit = scene_at("scenes/fog_and_slit/scene.xml");
    const SceneFeatures features = features_of(slit);
    const PassImage right = rendered(slit, features.media_to_media, features.media_to_surface);
    const PassImage wrong = rendered(slit, features.media_to_media & ~feature_bit::anisotropic, features.media_to_surface & ~feature_bit::anisotropic);
    for (const Layer layer : connected) EXPECT_GT(difference(wrong, right, layer), 1000 * rounding) << name(layer);
    const Scene box = scene_at("tests/images/scenes/i_bounded_fog.xml");
    const PassImage bounded = rendered(box, features_of(box).media_to_media, features_of(box).media_to_surface);
    const PassImage unbounded = rendered(box, features_of(box).media_to_media, features_of(box).media_to_surface & ~feature_bit::boundaries);
    EXPECT_GT(difference(unbounded, bounded, Layer::media_to_surface), 1000 * rounding);
}

TEST(HandMask, ThatLacksWhatTheSceneNeedsIsRefusedByNameOfTheElement)
{
    const Scene scene = scene_at("scenes/fruit_juice/scene.xml");
    for (const std::uint32_t mask : subsets_of(features_of(scene).mask())) {
        RenderSettings settings{.passes = 1, .features = mask};
        if ((features_of(scene).mask() & ~mask) == feature_bit::boundaries) settings.layers.remove(Layer::media_to_media);
        try {
            PassRenderer(scene, settings);
            ADD_FAILURE() << feature_names(mask) << " was taken";
        } catch (const UsageError& error) {
            EXPECT_NE(std::string(error.what()).find("lacks " + feature_names(features_of(scene).mask() & ~mask)), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find("scene.xml:"), std::string::npos) << error.what();
        }
    }
}

TEST(HandMask, OnlyLayersThatRunHaveASay)
{
    const Scene scene = scene_at("scenes/fruit_juice/scene.xml");
    const RenderSettings settings{.layers = LayerSet().add(Layer::media_to_media), .passes = 1, .features = feature_bit::anisotropic | feature_bit::coloured};
    EXPECT_EQ(PassRenderer(scene, settings).render(0).image[Layer::media_to_media].size(), 256u);  // BOUNDARIES is needed by media_to_surface alone
}

TEST(HandMask, WalkingOnTheHostNeedsOccluders)
{
    const Scene scene = scene_at("scenes/six_vrls/scene.xml");
    EXPECT_THROW(PassRenderer(scene, {.passes = 1, .features = feature_bit::nonconvex_media}), UsageError);
}

}  // namespace
}  // namespace tyndall::test
