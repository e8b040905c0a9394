/// The length of paths and of lights.
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

std::string room(const Rgb& reflectance)
{
    return medium("fog", Rgb(.5, 1, 2), Rgb(.9), .5) + container(Vec3(-.5), Vec3(.5), "fog") +
           horizontal({0, -.6, 0}, 1.5, true, diffuse(reflectance)) + sphere({.1, .1, .1}, .2, diffuse(reflectance)) +
           point_light({.5, 1, .5}, Rgb(2)) + sensor({.origin = {.3, .6, 3}});
}
const std::string black = room(Rgb(0)), grey = room(Rgb(.6));

TEST(MaxDepth, TwoLeavesNoLightBetweenMedia)
{
    for (const Method method : {Method::vrl, Method::path}) {
        const WholeRender r = render_whole(scene_of(grey), {.method = method, .passes = 20, .lights = 256, .max_depth = 2});
        EXPECT_GT(r(Layer::single).value(), 0);
        EXPECT_GT(r(Layer::surface_direct).value(), 0);
        for (const Layer layer : {Layer::media_to_media, Layer::media_to_surface, Layer::surface_to_media, Layer::surface_indirect})
            EXPECT_EQ(r(layer).value(), 0) << name(layer);
        EXPECT_EQ(r.report().virtual_lights, 0u);
    }
}

TEST(MaxDepth, OneAndZeroLeaveNothingScattered)
{
    for (const int depth : {0, 1})
        for (const Method method : {Method::vrl, Method::path}) {
            const WholeRender r = render_whole(scene_of(grey), {.method = method, .passes = 4, .lights = 256, .max_depth = depth});
            for (std::size_t l = 1; l < layer_count; ++l)
                EXPECT_EQ(r(static_cast<Layer>(l)).value(), 0) << name(static_cast<Layer>(l)) << ", max depth " << depth;
        }
}

// Lights of the first segments end two scattering vertices before the camera, as does max depth 3. The light paths are the same, the
// programs differ by a comparison of integers: the same sums.
TEST(MaxDepth, ThreeIsWhatFirstSegmentsCarry)
{
    const Scene scene = scene_of(black);
    const WholeRender three = render_whole(scene, {.passes = 5, .lights = 256, .max_depth = 3});
    const WholeRender first = render_whole(scene, {.passes = 5, .lights = 256, .light_segments = LightSegments::first});
    EXPECT_GT(three(Layer::media_to_media).value(), 0);
    EXPECT_LE(largest_difference(three.film().mean(Layer::media_to_media), first.film().mean(Layer::media_to_media)), 1e-6);
}

TEST(MaxDepth, KeepsTheSamePathsAsPathTracing)
{
    const Scene scene = scene_of(grey);
    double shallower = 0;
    for (const int depth : {3, 4, 6}) {
        const WholeRender vrl = render_whole(scene, {.passes = 200, .lights = 256, .max_depth = depth});
        const WholeRender path = render_whole(scene, {.method = Method::path, .passes = 4000, .max_depth = depth});
        expect_layers_agree(vrl, path, {Layer::media_to_media, Layer::media_to_surface}, .02);
        EXPECT_GT(path(Layer::media_to_media).value(), shallower);
        shallower = path(Layer::media_to_media).value();
    }
}

TEST(MaxDepth, OfTheSceneIsUsedUnlessTheSettingsHaveOne)
{
    const std::string integrator = R"(<integrator type="volpath"><integer name="max_depth" value="2"/></integrator>)";
    const Scene scene = scene_of(integrator + grey);
    EXPECT_EQ(render_whole(scene, {.passes = 2, .lights = 256})(Layer::media_to_media).value(), 0);
    EXPECT_GT(render_whole(scene, {.passes = 2, .lights = 256, .max_depth = -1})(Layer::media_to_media).value(), 0);
}

TEST(SegmentLength, LongAndShortLightsCarryTheSame)
{
    const Scene scene = scene_of(grey);
    const WholeRender lng = render_whole(scene, {.passes = 300, .lights = 256});
    const WholeRender shrt = render_whole(scene, {.passes = 600, .lights = 256, .seed = 2, .segment_length = SegmentLength::short_});
    for (const int channel : {0, 1, 2}) expect_layers_agree(lng, shrt, {Layer::media_to_media, Layer::media_to_surface}, .02, channel);
}

}  // namespace
