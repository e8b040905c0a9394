/// Every kind of virtual light that is unbiased against path tracing, layer by layer and channel by channel. A new light is tested here without an edit. Receiving
/// surfaces stand off the media: near contact the variance of points and rays has no bound, and no test of means could judge.
#include "lights/light_technique.hpp"
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

const std::string view = sensor({.origin = {.3, .6, 3}});
const std::string lamp = horizontal({.2, 1.2, .1}, .3, false, diffuse(Rgb(0)) + glow(Rgb(4, 3, 2)));
const std::string floor_below = horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75)));
const std::string fog = medium("fog", Rgb(.5, 1, 2), Rgb(.95, .9, .8), .5), smoke = medium("smoke", Rgb(4, 3, 2), Rgb(.7), -.3);
const std::string around_occluder = fog + container(Vec3(-.5), Vec3(.5), "fog") + box({-.3, .05, -.3}, {.3, .15, .3}, diffuse(Rgb(0)));

std::vector<std::string> unbiased_methods()
{
    std::vector<std::string> methods;
    for (const LightTechnique& technique : light_techniques())
        if (technique.unbiased && !technique.on_surfaces) methods.emplace_back(technique.method);
    return methods;
}

/// `path`: the same scene by path tracing.
void expect_agreement(const Scene& scene, const std::string& method, const WholeRender& path, RenderSettings settings, double precision)
{
    settings.method = Method(method);
    const WholeRender lights = render_whole(scene, settings);
    for (const int channel : {0, 1, 2}) expect_layers_agree(lights, path, {Layer::media_to_media, Layer::media_to_surface}, precision, channel);
}

WholeRender by_paths(const Scene& scene, int passes, int max_depth = -1)
{
    return render_whole(scene, {.method = Method::path, .layers = LayerSet().add(Layer::media_to_media).add(Layer::media_to_surface), .passes = passes, .seed = 2, .max_depth = max_depth});
}

class EveryLight : public testing::TestWithParam<std::string> {
protected:
    const Method method_{GetParam()};
    const LayerSet layers_ = LayerSet().add(Layer::media_to_media).add(Layer::media_to_surface);
};
INSTANTIATE_TEST_SUITE_P(Unbiased, EveryLight, testing::ValuesIn(unbiased_methods()));

TEST_P(EveryLight, FogAroundAnOccluder)
{
    const Scene scene = scene_of(around_occluder + floor_below + lamp + view);
    static const WholeRender path = by_paths(scene, 6000);
    expect_agreement(scene, GetParam(), path, {.layers = layers_, .passes = 500, .lights = 256}, .025);
    expect_agreement(scene, GetParam(), path, {.layers = layers_, .passes = 300, .lights = 1024, .selection = Selection::tile, .selected_lights = 64}, .03);
}

TEST_P(EveryLight, NestedMediaByEverySampler)
{
    const Scene scene = scene_of(fog + smoke + container(Vec3(-.5), Vec3(.5), "fog") + container({-.3, -.2, -.2}, {.1, .3, .3}, "smoke", "fog") + floor_below + lamp + view);
    static const WholeRender path = by_paths(scene, 6000);
    for (const Sampler sampler : {Sampler::paper_isotropic, Sampler::paper, Sampler::table_3x2})
        expect_agreement(scene, GetParam(), path, {.layers = layers_, .passes = 300, .lights = 256, .sampler = sampler}, .035);
}

TEST_P(EveryLight, DoubleScatteringAlone)
{
    const Scene scene = scene_of(fog + container(Vec3(-.5), Vec3(.5), "fog") + floor_below + lamp + view);
    static const WholeRender path = by_paths(scene, 8000, 3);
    expect_agreement(scene, GetParam(), path, {.layers = layers_, .passes = 300, .lights = 256, .max_depth = 3}, .03);
}

TEST_P(EveryLight, ADensityGridMarchedAndExact)
{
    const std::string puff = R"(<medium type="heterogeneous" id="puff"><volume name="sigma_t" type="gridvolume"><string name="filename" value="plume.vol"/><transform name="to_world"><translate x="-0.5" y="-0.5" z="-0.5"/></transform></volume>
                             <rgb name="albedo" value=".95, .9, .8"/><float name="scale" value="24"/></medium>)";
    const std::string body = puff + container(Vec3(-.5), Vec3(.5), "puff") + floor_below + lamp + view;
    const Scene scene = parse_scene("<scene version=\"3.0.0\">" + body + "</scene>", TYNDALL_SOURCE_DIR "/scenes/plume", "scene.xml");
    static const WholeRender path = by_paths(scene, 4000);
    for (const GridTransmittance transmittance : {GridTransmittance::march, GridTransmittance::exact})
        expect_agreement(scene, GetParam(), path, {.layers = layers_, .passes = 200, .lights = 256, .transmittance = transmittance}, .06);
}

TEST(EveryLightTest, ALightOfTheWrongPowerIsSeen)
{
    const Scene scene = scene_of(around_occluder + floor_below + lamp + view);
    const WholeRender path = by_paths(scene, 3000), lights = render_whole(scene, {.method = Method("vpl"), .passes = 300, .lights = 256});
    const Mean &a = lights(Layer::media_to_surface), &b = path(Layer::media_to_surface);
    const double error = std::sqrt(a.variance_of_mean() + b.variance_of_mean());
    EXPECT_GT(std::abs(1.2 * a.value() - b.value()), allowed_sigmas * error) << "a fifth too much is within the error: the comparison is blind";
}

}  // namespace
