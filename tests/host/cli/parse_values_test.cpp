#include "cli/parse_values.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/render_command.hpp"
#include "kernels/shared/host_features.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

TEST(ParseValues, IntegersAreDecimalWholeAndInRange)
{
    EXPECT_EQ(parse_integer("--passes", "010", 1, 100), 10);
    for (const auto* text : {"", "0", "101", "1.5", "1e1", "0x10", " 5", "5 ", "+5", "five", "99999999999999999999", "-1", "nan"})
        EXPECT_THROW(parse_integer("--passes", text, 1, 100), UsageError) << text;
}

TEST(ParseValues, SeedsReachSixtyFourBits)
{
    EXPECT_EQ(parse_unsigned("--seed", "18446744073709551615"), UINT64_MAX);
    for (const auto* text : {"18446744073709551616", "-1", ""}) EXPECT_THROW(parse_unsigned("--seed", text), UsageError) << text;
}

TEST(ParseValues, NumbersAreFiniteAndNotOfAnotherLocale)
{
    EXPECT_EQ(parse_number("--exposure", "-1.5", -64, 64), -1.5);
    for (const auto* text : {"nan", "inf", "-inf", "1e400", "1,5", "65", "", "0x1p3", "1.5stops"})
        EXPECT_THROW(parse_number("--exposure", text, -64, 64), UsageError) << text;
}

TEST(ParseValues, DurationsHaveUnits)
{
    EXPECT_EQ(parse_share("--skip-thin", "1%"), .01);
    EXPECT_EQ(parse_share("--skip-thin", ".01"), .01);
    EXPECT_EQ(parse_share("--skip-thin", "0"), 0);
    for (const char* text : {"", "%", "1", "100%", "-1%", "-.1", "nan", "1 %", "1%%", "inf"}) EXPECT_THROW(parse_share("--skip-thin", text), UsageError) << text;
    EXPECT_EQ(parse_duration("--time", "60"), 60);
    EXPECT_EQ(parse_duration("--time", "60s"), 60);
    EXPECT_EQ(parse_duration("--time", "2m"), 120);
    EXPECT_EQ(parse_duration("--time", "1.5h"), 5400);
    for (const auto* text : {"", "s", "0", "0s", "-5", "nan", "inf", "2d", "1e9h", "2 m", "m2"})
        EXPECT_THROW(parse_duration("--time", text), UsageError) << text;
}

TEST(ParseValues, ResolutionsAndCrops)
{
    EXPECT_EQ(parse_resolution("--resolution", "640x480"), (std::pair{640, 480}));
    for (const auto* text : {"640", "640x", "x480", "0x480", "640x480x3", "640X480", "65537x1", "-1x5"})
        EXPECT_THROW(parse_resolution("--resolution", text), UsageError) << text;
    const auto crop = parse_crop("--crop", "1,2,3,4");
    EXPECT_EQ(crop.x, 1);
    EXPECT_EQ(crop.y, 2);
    EXPECT_EQ(crop.width, 3);
    EXPECT_EQ(crop.height, 4);
    for (const auto* text : {"1,2,3", "1,2,0,4", "-1,2,3,4", "1,2,3,4,5", "1;2;3;4"})
        EXPECT_THROW(parse_crop("--crop", text), UsageError) << text;
}

TEST(ParseValues, LayersAddUpAndMisspeltOnesGetASuggestion)
{
    LayerSet layers;
    parse_layers("--layer", "single,media_to_media.specular", layers);
    parse_layers("--layer", "emitted", layers);
    EXPECT_EQ(layers.size(), 3u);
    EXPECT_TRUE(layers.contains(Layer::media_to_media_specular));
    parse_layers("--layer", "all", layers);
    EXPECT_EQ(layers, LayerSet::all());
    try {
        parse_layers("--layer", "single,media_to_medai", layers);
        FAIL() << "accepted a misspelt layer";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean \"media_to_media\"?"), std::string::npos) << error.what();
    }
}

TEST(ParseValues, ALayerMayBePathTraced)
{
    LayerWishes one;
    parse_layer_wishes("--layer", "media_to_media=path", one);
    EXPECT_EQ(one.kept(), LayerSet::all()) << "the others are kept";
    EXPECT_EQ(one.by_path, LayerSet().add(Layer::media_to_media));
    LayerWishes two;
    parse_layer_wishes("--layer", "single,media_to_surface=path", two);
    EXPECT_EQ(two.kept(), LayerSet().add(Layer::single).add(Layer::media_to_surface));
    for (const auto* text : {"media_to_media=vpl", "media_to_media=", "media_to_medai=path"}) EXPECT_THROW(parse_layer_wishes("--layer", text, two), UsageError) << text;
}

TEST(ParseValues, ALayerThatLightsDoNotCarryIsRefusedWithThoseWhoDo)
{
    const auto refusal = [](const std::string& text) -> std::string {
        LayerWishes wishes;
        try {
            parse_layer_wishes("--layer", text, wishes);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(refusal("surface_indirect=vrl"), testing::HasSubstr("virtual ray lights do not carry surface_indirect; --method photons, vpl, vpl-clamped, talk, path does"));
    EXPECT_THAT(refusal("media_to_media.specular=vpl"), testing::HasSubstr("virtual point lights do not carry media_to_media.specular; --method beams, talk, path does"));
    EXPECT_THAT(refusal("single=photons"), testing::HasSubstr("photons do not carry single; --method beams, talk, path does"));
    EXPECT_THAT(refusal("media_to_media=vpl"), testing::HasSubstr("--method vpl sets the kind of light for all layers"));
    EXPECT_THAT(refusal("media_to_media=vlp"), testing::HasSubstr("did you mean \"vpl\"?"));
}

TEST(ParseValues, FeaturesAreNamesOrAllOrNoneOrOwn)
{
    using namespace feature_bit;
    EXPECT_EQ(parse_features("--features", "COLOURED,OCCLUDERS"), coloured | occluders);
    EXPECT_EQ(parse_features("--features", "all"), (1u << scene_feature_list.size()) - 1);
    EXPECT_EQ(parse_features("--features", "none"), 0u);
    EXPECT_FALSE(parse_features("--features", "own"));
    for (const auto* text : {"", "coloured", "COLOURED,", "own,COLOURED", "COLOURED,none", "LIGHTS"}) EXPECT_THROW(parse_features("--features", text), UsageError) << text;
}

TEST(ParseValues, Definitions)
{
    EXPECT_EQ(parse_definition("-D", "a=b=c"), (std::pair<std::string, std::string>{"a", "b=c"}));
    EXPECT_EQ(parse_definition("-D", "a=").second, "");
    for (const auto* text : {"a", "=b", ""}) EXPECT_THROW(parse_definition("-D", text), UsageError) << text;
}

Camera cropped_camera()
{
    Camera camera;
    camera.width = 100, camera.height = 50;
    camera.crop_x = 11, camera.crop_y = 10, camera.crop_width = 30, camera.crop_height = 20;
    return camera;
}

TEST(OverrideFilm, ScalesTheScenesCropOutward)
{
    auto camera = cropped_camera();
    override_film(camera, std::pair{50, 50}, {});
    EXPECT_EQ(camera.width, 50);
    EXPECT_EQ(camera.crop_x, 5);  // 5.5 .. 20.5 becomes 5 .. 21
    EXPECT_EQ(camera.crop_width, 16);
    EXPECT_EQ(camera.crop_y, 10);
    EXPECT_EQ(camera.crop_height, 20);
}

TEST(OverrideFilm, AFullFilmStaysFull)
{
    Camera camera;
    for (const auto& size : {std::pair{3, 7}, std::pair{65536, 1}, std::pair{1, 1}}) {
        override_film(camera, size, {});
        EXPECT_EQ(camera.crop_x, 0);
        EXPECT_EQ(camera.crop_y, 0);
        EXPECT_EQ(camera.crop_width, size.first);
        EXPECT_EQ(camera.crop_height, size.second);
    }
}

TEST(OverrideFilm, CropMustLieInTheFilm)
{
    auto camera = cropped_camera();
    EXPECT_THROW(override_film(camera, {}, Crop{90, 0, 11, 5}), UsageError);
    EXPECT_THROW(override_film(camera, {}, Crop{0, 45, 5, 6}), UsageError);
    override_film(camera, std::pair{200, 100}, Crop{190, 90, 10, 10});
    EXPECT_EQ(camera.crop_x, 190);
    EXPECT_EQ(camera.crop_height, 10);
}

TEST(OverrideFilm, RefusesFilmsThatNoMachineHolds)
{
    auto camera = cropped_camera();
    EXPECT_THROW(override_film(camera, std::pair{65536, 65536}, {}), UsageError);
    override_film(camera, std::pair{65536, 65536}, Crop{5, 5, 64, 64});  // a part of it may be rendered
}

}  // namespace
}  // namespace tyndall
