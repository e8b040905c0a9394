/// What must not change an image, or change it only within a documented rounding: tiles, threads, lane width, layers that nobody asked for.
#include <future>

#include "support/every_variant.hpp"
#include "tyndall/error.hpp"
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

const std::string view = sensor({.origin = {.3, .6, 3}, .pixels = 13});  // 169 pixels: no multiple of any group
const std::string lamp = horizontal({0, 1.2, 0}, .3, false, diffuse(Rgb(0)) + glow(Rgb(4, 3, 2)));
const std::string floor_below = horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75)));

/// Nothing can occlude: one fused kernel.
const std::string clear_fog =
    medium("fog", Rgb(.5, 1, 2), Rgb(.9, .7, .5), .5) + container(Vec3(-.5), Vec3(.5), "fog") + point_light({.5, 1, .5}, Rgb(2)) + view;
/// Shadow segments, surfaces that receive.
const std::string shadowed_fog = clear_fog + floor_below + lamp + sphere({.1, .1, .1}, .2, diffuse(Rgb(.5)));
/// A medium within a medium: connections are walked on the host.
const std::string nested_fog = shadowed_fog + medium("smoke", Rgb(3), Rgb(.6)) + container({-.4, -.4, -.4}, {-.1, 0, 0}, "smoke", "fog");

struct NamedScene {
    std::string name, body;
    int lanes;  ///< the width that is compared with the usual one; EVERY_VARIANT: each
    Selection selection = Selection::tile;
};
void PrintTo(const NamedScene& scene, std::ostream* out) { *out << scene.name; }

class Sameness : public testing::TestWithParam<NamedScene> {
protected:
    const Scene scene = scene_of(GetParam().body);
    const RenderSettings settings{.passes = 3, .lights = 600, .selection = GetParam().selection, .selected_lights = 600};  // two blocks and a part of one
    const WholeRender original = render_whole(scene, settings);
};

TEST_P(Sameness, TheSizeOfATileChangesNoByte)
{
    for (const std::uint32_t pairs : {1u, 5000u, 1u << 17, 1u << 26}) {
        RenderSettings other = settings;
        other.tile_pairs = pairs;
        expect_same_bytes(render_whole(scene, other).film(), original.film());
    }
}

TEST_P(Sameness, TheBoundOnLaunchesChangesNoByte)
{
    RenderSettings other = settings;
    other.launch_seconds = .001;
    const WholeRender r = render_whole(scene, other);
    expect_same_bytes(r.film(), original.film());
    EXPECT_GT(r.report().largest_launch_seconds, 0);
}

TEST_P(Sameness, TheNumberOfThreadsChangesNoByte)
{
    for (const int threads : {1, 2}) {
        RenderSettings other = settings;
        other.threads = threads;
        expect_same_bytes(render_whole(scene, other).film(), original.film());
    }
}

TEST_P(Sameness, TwoAtOnceGiveTheBytesOfOne)
{
    const auto again = [&] { return render_whole(scene, settings); };
    std::future<WholeRender> two[] = {std::async(std::launch::async, again), std::async(std::launch::async, again)};
    for (std::future<WholeRender>& render : two) expect_same_bytes(render.get().film(), original.film());
}

TEST_P(Sameness, RenderingAgainGivesTheSameBytesAndAnotherSeedDoesNot)
{
    expect_same_bytes(render_whole(scene, settings).film(), original.film());
    RenderSettings other = settings;
    other.seed = 2;
    EXPECT_NE(render_whole(scene, other).film().beauty(), original.film().beauty());
}

// Lane widths run the same operations; only the libraries' exp, log and tan may differ between widths, by a few ulp: 1e-5 per value of a
// kernel (host/README.md). A sample that crosses an edge of shadow by that much would show as one of 1800 contributions; there is none
// here.
TEST_P(Sameness, TheLaneWidthChangesRoundingOnly)
{
    for (const int lanes : {1, 4, 8, 16}) {
        if (lanes != GetParam().lanes && !every_variant()) continue;
        RenderSettings other = settings;
        other.lanes = lanes;
        const WholeRender r = render_whole(scene, other);
        EXPECT_EQ(r.report().lanes, lanes);
        for (const Layer layer : {Layer::media_to_media, Layer::media_to_surface})
            EXPECT_LE(largest_difference(r.film().mean(layer), original.film().mean(layer)), 1e-5)
                << name(layer) << ", " << lanes << " lanes";
    }
}

TEST_P(Sameness, LayersThatAreTurnedOffLeaveTheOthersAlone)
{
    for (const Layer layer : {Layer::media_to_media, Layer::media_to_surface, Layer::single}) {
        RenderSettings other = settings;
        other.layers = only(layer);
        expect_same_bytes(render_whole(scene, other).film(), original.film(), layer);
        other.layers = LayerSet::all().remove(layer);
        const WholeRender r = render_whole(scene, other);
        EXPECT_FALSE(r.film().has(layer));
        for (std::size_t l = 0; l < layer_count; ++l)
            if (static_cast<Layer>(l) != layer) expect_same_bytes(r.film(), original.film(), static_cast<Layer>(l));
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Sameness,
                         testing::Values(NamedScene{"ClearFog", clear_fog, 1}, NamedScene{"ShadowedFog", shadowed_fog, 4},
                                         NamedScene{"NestedFog", nested_fog, 8}, NamedScene{"ClearFogAllLights", clear_fog, 4, Selection::all},
                                         NamedScene{"ShadowedFogAllLights", shadowed_fog, 1, Selection::all}),
                         [](const auto& info) { return info.param.name; });

TEST(SamplesPerPair, ChangeTheNoiseOnly)
{
    const Scene scene = scene_of(shadowed_fog);
    const WholeRender one = render_whole(scene, {.passes = 200, .lights = 256}),
                      three = render_whole(scene, {.passes = 200, .lights = 256, .seed = 2, .samples_per_pair = 3});
    expect_layers_agree(one, three, {Layer::media_to_media, Layer::media_to_surface}, .03);
    EXPECT_EQ(three.report().pairs % 3, 0u);
}

TEST(SceneWithoutMedium, NeedsNoDeviceAndTracesNoLights)
{
    const Scene scene = scene_of(floor_below + lamp + view);
    const WholeRender r = render_whole(scene, {.passes = 2, .device = "there is no such device"});
    EXPECT_EQ(r.report().virtual_lights, 0u);
    EXPECT_EQ(r.report().pairs, 0u);
    EXPECT_EQ(r.report().launches, 0u);
    EXPECT_EQ(r.report().device, "");
    EXPECT_GT(r(Layer::surface_direct).value(), 0);
    EXPECT_THROW(render(scene_of(clear_fog), {.passes = 2, .device = "there is no such device"}), NoDeviceError);
}

TEST(SceneWithoutMedium, AMediumThatOnlyAbsorbsNeedsNoDeviceEither)
{
    const Scene scene = scene_of(medium("ink", Rgb(1), Rgb(0)) + container(Vec3(-.5), Vec3(.5), "ink") + floor_below + lamp + view);
    const WholeRender r = render_whole(scene, {.passes = 2, .device = "there is no such device"});
    EXPECT_EQ(r.report().virtual_lights, 0u);
    EXPECT_GT(r(Layer::surface_direct).value(), 0);
}

TEST(FogAlone, TracesNoShadowSegmentsAndBuildsOneProgram)
{
    const WholeRender r = render_whole(scene_of(clear_fog), {.passes = 2, .lights = 256});
    EXPECT_GT(r.report().virtual_lights, 0u);
    EXPECT_EQ(r.report().shadow_segments, 0u);
    EXPECT_EQ(r.report().eye_points, 0u);
    EXPECT_FALSE(r.film().has(Layer::media_to_surface));
}

}  // namespace
