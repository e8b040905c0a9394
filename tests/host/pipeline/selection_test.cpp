/// Lights that are chosen for each pixel give the image that all of them give.
#include <fstream>

#include "tests/support/temporary_folder.hpp"
#include "tests/support/vol_file.hpp"
#include "tyndall/error.hpp"
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

const std::string view = sensor({.origin = {.3, .6, 3}, .pixels = 13});
const std::string lamp = horizontal({.2, 1.2, .1}, .3, false, diffuse(Rgb(0)) + glow(Rgb(4, 3, 2)));
const std::string floor_below = horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75)));
const std::string fog = medium("fog", Rgb(.5, 1, 2), Rgb(.95, .9, .8), .5), smoke = medium("smoke", Rgb(4, 3, 2), Rgb(.7), -.3);
const std::string cube_of_fog = fog + container(Vec3(-.5), Vec3(.5), "fog") + lamp + view;

struct Case {
    std::string name, body;
    RenderSettings chosen;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Selected : public testing::TestWithParam<Case> {};

TEST_P(Selected, GivesTheImageOfAllLights)
{
    const Scene scene = scene_of(GetParam().body);
    RenderSettings all{.passes = 300, .lights = 256, .seed = 2}, chosen = GetParam().chosen;
    all.segment_length = chosen.segment_length, all.max_depth = chosen.max_depth, all.selection = Selection::all;
    chosen.passes = 450, chosen.lights = 600, chosen.selection = Selection::tile, chosen.selected_lights = 32;
    const WholeRender a = render_whole(scene, chosen), b = render_whole(scene, all);
    EXPECT_NE(a.report().selection.find("32 of 600"), std::string::npos) << a.report().selection;
    EXPECT_LT(a.report().pairs, b.report().pairs / 2);
    for (const int channel : {0, 1, 2}) {
        expect_layers_agree(a, b, {Layer::media_to_media}, .02, channel);
        if (GetParam().body.find("diffuse") != std::string::npos) expect_layers_agree(a, b, {Layer::media_to_surface}, .02, channel);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Lights, Selected,
    testing::Values(Case{"Clear", cube_of_fog + floor_below, {}}, Case{"ShortLights", cube_of_fog + floor_below, {.segment_length = SegmentLength::short_}},
                    Case{"DepthLimit", cube_of_fog + floor_below, {.max_depth = 5}},
                    Case{"Occluded", cube_of_fog + floor_below + box({-.3, .05, -.3}, {.3, .15, .3}, diffuse(Rgb(.5))), {.camera_samples = 4}},
                    Case{"Nested", cube_of_fog + smoke + container({-.3, -.2, -.2}, {.1, .3, .3}, "smoke", "fog") + floor_below, {.selection_block = 4}},
                    Case{"AmongCandidates", cube_of_fog + smoke + container({-.3, -.2, -.2}, {.1, .3, .3}, "smoke", "fog") + floor_below, {.candidates = 40}},
                    Case{"ByPowerAlone", cube_of_fog + floor_below, {.selection_block = 16, .selection_defence = 1}}),
    [](const auto& info) { return info.param.name; });

// Estimates stand on the mean density along a light, which of this puff, dense in one corner and empty in another, is far from what is met.
TEST(Selection, InADensityGridGivesTheImageOfAllLights)
{
    const TemporaryFolder folder;
    std::vector<float> values(64);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i % 4 * (i / 16));
    const std::string bytes = vol_bytes({.size = {4, 4, 4}, .values = values});
    std::ofstream(folder / "puff.vol", std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
    const std::string puff = R"(<medium type="heterogeneous" id="puff"><volume name="sigma_t" type="gridvolume"><string name="filename" value="puff.vol"/><transform name="to_world">
        <translate x="-0.5" y="-0.5" z="-0.5"/></transform></volume><float name="albedo" value=".9"/><phase type="hg"><float name="g" value=".5"/></phase></medium>)";
    const Scene scene = parse_scene("<scene version=\"3.0.0\">" + puff + container(Vec3(-.5), Vec3(.5), "puff") + lamp + floor_below + view + "</scene>", folder.path(), "scene.xml");
    const WholeRender chosen = render_whole(scene, {.passes = 900, .lights = 600, .selection = Selection::tile, .selected_lights = 64}),
                      all = render_whole(scene, {.passes = 600, .lights = 200, .seed = 2, .selection = Selection::all});
    expect_layers_agree(chosen, all, {Layer::media_to_media, Layer::media_to_surface}, .03);
}

TEST(Selection, SeveralCameraSamplesOfAllLightsGiveTheSameImage)
{
    const Scene scene = scene_of(cube_of_fog + floor_below);
    const WholeRender several = render_whole(scene, {.passes = 200, .lights = 128, .camera_samples = 3}), one = render_whole(scene, {.passes = 400, .lights = 128, .seed = 2});
    expect_layers_agree(several, one, {Layer::media_to_media, Layer::media_to_surface}, .02);
}

TEST(PathLayers, AreThePathTracersWhateverTheMethod)
{
    const Scene scene = scene_of(cube_of_fog + floor_below);
    const LayerSet two = LayerSet().add(Layer::media_to_media).add(Layer::media_to_surface);
    const WholeRender mixed = render_whole(scene, {.layers = two, .path_layers = LayerSet().add(Layer::media_to_media), .passes = 40}),
                      path = render_whole(scene, {.method = Method::path, .layers = two, .passes = 40}), lights = render_whole(scene, {.layers = two, .passes = 40});
    EXPECT_EQ(mixed(Layer::media_to_media).value(), path(Layer::media_to_media).value());
    EXPECT_EQ(mixed(Layer::media_to_surface).value(), lights(Layer::media_to_surface).value());
    EXPECT_EQ(mixed.report().layers[static_cast<std::size_t>(Layer::media_to_media)].technique, "path tracing");
    EXPECT_EQ(mixed.report().layers[static_cast<std::size_t>(Layer::media_to_media)].why, "--layer media_to_media=path");
}

TEST(Selection, ChoosesByItselfFromManyLightsOnly)
{
    const Scene scene = scene_of(cube_of_fog);
    EXPECT_EQ(render_whole(scene, {.passes = 1, .lights = 511}).report().selection.substr(0, 3), "all");
    EXPECT_EQ(render_whole(scene, {.passes = 1, .lights = 512}).report().selection.substr(0, 9), "64 of 512");
    EXPECT_EQ(render_whole(scene, {.passes = 1, .lights = 512, .selection = Selection::all}).report().selection.substr(0, 3), "all");
    EXPECT_EQ(render_whole(scene, {.passes = 1}).report().selection.substr(0, 10), "64 of 2048");
    EXPECT_EQ(render_whole(scene, {.passes = 1}).report().selection.find("per region"), std::string::npos);
    EXPECT_NE(render_whole(scene, {.passes = 1, .lights = 10000}).report().selection.find("among 4096 per region"), std::string::npos);
    EXPECT_EQ(render_whole(scene, {.passes = 1, .lights = 10000, .candidates = all_lights}).report().selection.find("per region"), std::string::npos);
}

TEST(Selection, RefusesWhatMakesNoSense)
{
    const Scene scene = scene_of(cube_of_fog);
    for (const RenderSettings& bad : {RenderSettings{.passes = 1, .selected_lights = 1u << 17}, RenderSettings{.passes = 1, .selection_block = 5}, RenderSettings{.passes = 1, .candidates = (1u << 20) + 1}, RenderSettings{.passes = 1, .selection_defence = 1.5},
                                      RenderSettings{.passes = 1, .camera_samples = 65}})
        EXPECT_THROW(render(scene, bad), UsageError);
}

}  // namespace
