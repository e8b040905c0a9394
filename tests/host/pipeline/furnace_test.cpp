/// White furnace: where nothing absorbs and light of radiance 1 comes from everywhere, everything looks 1, and only the sum of all layers
/// shows it.
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

void expect_white(const std::string& body, const RenderSettings& settings)
{
    const WholeRender r = render_whole(scene_of(body + constant_light(Rgb(1))), settings);
    for (int channel = 0; channel < 3; ++channel) {
        const Mean& mean = r.beauty[static_cast<std::size_t>(channel)];
        expect_mean(mean, 1, "beauty");
        EXPECT_LT(mean.error(), .01) << "the test is too weak";
    }
}

std::string fog_box(double g)
{
    return medium("fog", Rgb(.4, .8, 1.6), Rgb(1), g) + container(Vec3(-.5), Vec3(.5), "fog") + sensor({.origin = {0, 0, 2}, .fov = 35});
}

TEST(WhiteFurnaceOfTheWholeRenderer, FogIsInvisibleToVirtualRayLights)
{
    for (const double g : {0., .6, -.3}) expect_white(fog_box(g), {.method = Method::vrl, .passes = 150, .lights = 256});
}

TEST(WhiteFurnaceOfTheWholeRenderer, FogIsInvisibleToPathTracing) { expect_white(fog_box(.6), {.method = Method::path, .passes = 400}); }

TEST(WhiteFurnaceOfTheWholeRenderer, WhiteBallsInFogAreInvisible)
{
    const std::string scene = fog_box(.3) + sphere({0, .1, 0}, .25, diffuse(Rgb(1))) + box({-.6, -.9, -.3}, {.6, -.6, .3}, diffuse(Rgb(1)));
    expect_white(scene, {.method = Method::vrl, .passes = 150, .lights = 256});
    expect_white(scene, {.method = Method::path, .passes = 400});
}

TEST(WhiteFurnaceOfTheWholeRenderer, ShortLightsLoseNothing)
{
    expect_white(fog_box(0), {.method = Method::vrl, .passes = 300, .lights = 256, .segment_length = SegmentLength::short_});
}

}  // namespace
