/// Photon beams and photons in whole renders: their layers approach path tracing as the radius falls, at the rate that is predicted, whatever the media; light behind mirrors and glass that paths
/// cannot find is there; and bytes depend on neither threads nor tiles.
#include <gmock/gmock.h>

#include "lights/light_technique.hpp"
#include "lights/progressive_radius.hpp"
#include "pipeline/explain.hpp"
#include "three_radii.hpp"
#include "tyndall/error.hpp"

using namespace tyndall;
using namespace tyndall::test;
using testing::HasSubstr;

namespace {

const std::string view = sensor({.origin = {.3, .6, 3}});
const std::string lamp = horizontal({.2, 1.2, .1}, .3, false, diffuse(Rgb(0)) + glow(Rgb(4, 3, 2)));
const std::string floor_below = horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75)));
const std::string fog = medium("fog", Rgb(.5, 1, 2), Rgb(.95, .9, .8), .5), fog_cube = fog + container(Vec3(-.5), Vec3(.5), "fog");
const std::string smoke = medium("smoke", Rgb(4, 3, 2), Rgb(.7), -.3);
const std::string puff = R"(<medium type="heterogeneous" id="puff"><volume name="sigma_t" type="gridvolume"><string name="filename" value="plume.vol"/><transform name="to_world"><translate x="-0.5" y="-0.5" z="-0.5"/></transform></volume>
                             <rgb name="albedo" value=".95, .9, .8"/><float name="scale" value="24"/></medium>)";

LayerSet layers_of(std::initializer_list<Layer> layers)
{
    LayerSet set;
    for (const Layer layer : layers) set.add(layer);
    return set;
}

/// `precision`: of both, relative, one standard error.
void expect_agreement(const Scene& scene, RenderSettings settings, const RenderSettings& path, double radius, double precision)
{
    const auto three = at_three_radii(scene, settings, radius);
    const Passes paths = passes_of(scene, path);
    for (std::size_t l = 0; l < layer_count; ++l) {
        const Layer layer = static_cast<Layer>(l);
        if (!settings.layers.contains(layer)) continue;
        for (const int c : {0, 1, 2}) {
            const Mean ours = extrapolated(three, layer, c), theirs = mean_of(paths, layer, c);
            const std::string what = std::string(name(layer)) + ", channel " + std::to_string(c);
            std::printf("%-28s %.5g %.5g %.5g -> %.5g +- %.2g, paths %.5g +- %.2g\n", what.c_str(), mean_of(three[0], layer, c).value(), mean_of(three[1], layer, c).value(),
                        mean_of(three[2], layer, c).value(), ours.value(), ours.error(), theirs.value(), theirs.error());
            expect_same(ours, theirs, what.c_str());
            EXPECT_LT(ours.error(), precision * theirs.value()) << what << ": the test is too weak";
            EXPECT_LT(theirs.error(), precision * theirs.value()) << what << ": the test is too weak";
        }
    }
}

const LayerSet of_beams = layers_of({Layer::single, Layer::surface_to_media, Layer::media_to_media});

TEST(PhotonBeams, ApproachPathTracingInFogAboveAFloor)
{
    const Scene scene = scene_of(fog_cube + floor_below + lamp + view);
    expect_agreement(scene, {.method = Method("beams"), .layers = of_beams, .passes = 100, .lights = 2000}, {.method = Method::path, .layers = of_beams, .passes = 3000, .seed = 2}, .03, .05);
}

TEST(PhotonBeams, ApproachPathTracingInNestedMediaWhenShort)
{
    const Scene scene = scene_of(fog_cube + smoke + container({-.3, -.2, -.2}, {.1, .3, .3}, "smoke", "fog") + floor_below + lamp + view);
    expect_agreement(scene, {.method = Method("beams"), .layers = of_beams, .passes = 100, .lights = 1500, .segment_length = SegmentLength::short_},
                     {.method = Method::path, .layers = of_beams, .passes = 3000, .seed = 2}, .03, .08);
}

TEST(PhotonBeams, ApproachPathTracingInADensityGrid)
{
    const Scene scene = parse_scene("<scene version=\"3.0.0\">" + puff + container(Vec3(-.5), Vec3(.5), "puff") + floor_below + lamp + view + "</scene>", TYNDALL_SOURCE_DIR "/scenes/plume", "scene.xml");
    for (const SegmentLength length : {SegmentLength::long_, SegmentLength::short_})
        expect_agreement(scene, {.method = Method("beams"), .layers = of_beams, .passes = 40, .lights = 1500, .segment_length = length},
                         {.method = Method::path, .layers = of_beams, .passes = 1500, .seed = 2}, .03, .1);
}

TEST(PhotonBeams, SingleAndDoubleScatteringAlone)
{
    const Scene scene = scene_of(fog_cube + floor_below + lamp + view);
    for (const int depth : {2, 3})
        expect_agreement(scene, {.method = Method("beams"), .layers = depth == 2 ? only(Layer::single) : of_beams, .passes = 40, .lights = 1500, .max_depth = depth},
                         {.method = Method::path, .layers = of_beams, .passes = 2000, .seed = 2, .max_depth = depth}, .03, .05);
}

const LayerSet of_photons = layers_of({Layer::surface_indirect, Layer::media_to_surface});

TEST(Photons, ApproachPathTracing)
{
    const std::string wall = box({-1.4, -.8, -1.2}, {1.4, 1, -1}, diffuse(Rgb(.8, .6, .4)));
    const Scene scene = scene_of(fog_cube + wall + floor_below + lamp + view);
    expect_agreement(scene, {.method = Method("photons"), .layers = of_photons, .passes = 40, .lights = 8000}, {.method = Method::path, .layers = of_photons, .passes = 3000, .seed = 2}, .03, .03);
}


const std::string mirror = horizontal({0, -1, 0}, 6, true, R"(<bsdf type="conductor"><string name="material" value="none"/></bsdf>)");

/// The light that a point light sends over a large plane mirror is that of its image behind the plane, which connections by straight lines find. `away`: a camera that does not see the mirror.
void expect_image_of_lamp(const std::string& things, Layer layer, const std::string& method)
{
    const std::string away = sensor({.origin = {.3, .2, 3}, .target = {0, .1, 0}, .fov = 20});
    const Scene mirrored = scene_of(things + mirror + point_light({.1, -.7, .2}, Rgb(1, 2, 3)) + away), plain = scene_of(things + point_light({.1, -1.3, .2}, Rgb(1, 2, 3)) + away);
    const auto three = at_three_radii(mirrored, {.method = Method(method), .layers = only(specular(layer)), .passes = 40, .lights = 1500}, .02);
    const Passes twin = passes_of(plain, {.method = Method::vrl, .layers = only(layer), .passes = 400});
    for (const int c : {0, 1, 2}) {
        const Mean ours = extrapolated(three, specular(layer), c), theirs = mean_of(twin, layer, c);
        std::printf("%s.specular: %.5g %.5g %.5g -> %.5g +- %.2g, of the image %.5g +- %.2g\n", std::string(name(layer)).c_str(), mean_of(three[0], specular(layer), c).value(),
                    mean_of(three[1], specular(layer), c).value(), mean_of(three[2], specular(layer), c).value(), ours.value(), ours.error(), theirs.value(), theirs.error());
        expect_same(ours, theirs, "mirror and image");
        EXPECT_LT(ours.error(), .03 * theirs.value()) << "the test is too weak";
    }
}

TEST(PhotonBeams, CarryTheLightOfAPointOverAMirror) { expect_image_of_lamp(fog_cube, Layer::single, "beams"); }

TEST(Photons, CarryTheLightOfAPointOverAMirror)
{
    expect_image_of_lamp(horizontal({0, .6, 0}, .5, false, diffuse(Rgb(.8, .6, .4))) + box({-.4, -.1, -.6}, {.4, .4, -.5}, diffuse(Rgb(.4, .6, .8))), Layer::surface_direct, "photons");
}

TEST(DensityEstimation, GivesTheSameBytesForAnyThreadsAndTiles)
{
    const Scene scene = scene_of(fog_cube + smoke + container({-.3, -.2, -.2}, {.1, .3, .3}, "smoke", "fog") + floor_below + lamp + view);
    for (const char* method : {"beams", "photons", "talk"}) {
        RenderSettings settings{.method = Method(method), .passes = 3, .lights = 600, .threads = 1};
        const WholeRender one = render_whole(scene, settings);
        settings.threads = 2, settings.tile_pairs = 4096;
        const WholeRender other = render_whole(scene, settings);
        expect_same_bytes(one.film(), other.film());
        EXPECT_GT(one.beauty[0].value(), 0);
    }
}

TEST(DensityEstimation, SaysWhoCarriesWhatAndHowWideItIs)
{
    const Scene scene = scene_of(fog_cube + floor_below + mirror + lamp + view);
    const auto line = [&](const Explanation& e, Layer layer) { return e.layers[static_cast<std::size_t>(layer)]; };
    const Explanation talk = explain(scene, {.method = Method("talk"), .passes = 1});
    for (const Layer layer : {Layer::single, Layer::surface_to_media, Layer::single_specular, Layer::surface_to_media_specular, Layer::media_to_media_specular}) {
        EXPECT_EQ(line(talk, layer).technique, "photon beams") << name(layer);
        EXPECT_FALSE(line(talk, layer).unbiased);
        EXPECT_THAT(line(talk, layer).bias, HasSubstr("photon beams have a radius of 0.02 of the scene's half diagonal in the first pass, which falls as the cube root"));
    }
    for (const Layer layer : {Layer::surface_indirect, Layer::surface_indirect_specular, Layer::surface_direct_specular, Layer::media_to_surface_specular}) {
        EXPECT_EQ(line(talk, layer).technique, "photons") << name(layer);
        EXPECT_THAT(line(talk, layer).bias, HasSubstr("which falls as the sixth root"));
    }
    for (const Layer layer : {Layer::media_to_media, Layer::media_to_surface}) {
        EXPECT_EQ(line(talk, layer).technique, "virtual ray lights") << name(layer);
        EXPECT_TRUE(line(talk, layer).unbiased);
    }
    const Explanation beams = explain(scene, {.method = Method("beams"), .passes = 1, .beam_radius = .1});
    EXPECT_EQ(line(beams, Layer::media_to_media).technique, "photon beams");
    EXPECT_THAT(line(beams, Layer::media_to_media).bias, HasSubstr("radius of 0.1 "));
    EXPECT_EQ(line(beams, Layer::media_to_surface).technique, "path tracing");
    EXPECT_EQ(line(beams, Layer::media_to_surface).why, "photon beams do not carry it");
    const Explanation by_path = explain(scene, {.method = Method("beams"), .path_layers = only(Layer::single), .passes = 1});
    EXPECT_EQ(line(by_path, Layer::single).technique, "path tracing");
    const WholeRender rendered = render_whole(scene, {.method = Method("beams"), .layers = only(Layer::single), .passes = 3, .lights = 200});
    EXPECT_THAT(rendered.report().layers[static_cast<std::size_t>(Layer::single)].bias, HasSubstr(fmt::format("in the last of 3 it was {:.3g} times as wide", progressive_radius(1, 2))));
}

TEST(DensityEstimation, CarriesLightsWithoutSizeOverMirrorsForMethodsOfStraightLines)
{
    const std::string rest = fog_cube + floor_below + lamp + view, point = point_light({.1, -.7, .2}, Rgb(1, 2, 3));
    const Scene without_size = scene_of(rest + mirror + point);
    const Explanation found = explain(without_size, {.passes = 1}), large = explain(scene_of(rest + mirror), {.passes = 1}), no_mirror = explain(scene_of(rest + point), {.passes = 1});
    const auto line = [&](const Explanation& e, Layer layer) { return e.layers[static_cast<std::size_t>(layer)]; };
    for (const Layer layer : {Layer::single_specular, Layer::surface_to_media_specular, Layer::media_to_media_specular, Layer::surface_direct_specular, Layer::surface_indirect_specular, Layer::media_to_surface_specular}) {
        const bool to_media = layer == Layer::single_specular || layer == Layer::surface_to_media_specular || layer == Layer::media_to_media_specular;
        EXPECT_EQ(line(found, layer).technique, to_media ? "photon beams" : "photons") << name(layer);
        EXPECT_THAT(line(found, layer).why, HasSubstr("paths do not find lights without size over mirrors and glass"));
        EXPECT_FALSE(line(found, layer).unbiased);
        EXPECT_THAT(line(found, layer).bias, HasSubstr("radius"));
        EXPECT_EQ(line(large, layer).technique, "path tracing") << name(layer);
        EXPECT_TRUE(line(large, layer).unbiased && line(no_mirror, layer).unbiased);
    }
    for (const Layer layer : {Layer::single, Layer::media_to_media, Layer::media_to_surface}) EXPECT_TRUE(line(found, layer).unbiased) << name(layer);
    const Explanation by_path = explain(without_size, {.path_layers = only(Layer::single_specular), .passes = 1});
    EXPECT_EQ(line(by_path, Layer::single_specular).technique, "path tracing");
    const Scene open = scene_of(fog_cube + mirror + point + view);  // no floor between mirror and fog
    RenderSettings settings{.layers = only(Layer::single_specular), .passes = 3, .lights = 400};
    const WholeRender ours = render_whole(open, settings);
    settings.method = Method("talk");
    expect_same_bytes(ours.film(), render_whole(open, settings).film());
    EXPECT_GT(ours.beauty[0].value(), 0);
}

TEST(DensityEstimation, RefusesARadiusOfNothing)
{
    const Scene scene = scene_of(fog_cube + lamp + view);
    for (const char* method : {"beams", "photons", "talk"})
        for (const double radius : {0., -1., std::nan(""), 2.}) EXPECT_THROW(render(scene, {.method = Method(method), .passes = 1, .beam_radius = radius}), UsageError);
}

TEST(DensityEstimation, GlossySurfacesAreLeftToPaths)
{
    const std::string plastic = R"(<bsdf type="plastic"/>)", half = horizontal({-1, -.8, 0}, .8, true, diffuse(Rgb(.5))) + horizontal({1, -.8, 0}, .8, true, plastic);
    const Scene scene = scene_of(half + box({-1.4, -.8, -1.2}, {1.4, 1, -1}, diffuse(Rgb(.8, .6, .4))) + lamp + view);
    expect_agreement(scene, {.method = Method("photons"), .layers = only(Layer::surface_indirect), .passes = 40, .lights = 4000},
                     {.method = Method::path, .layers = only(Layer::surface_indirect), .passes = 1000, .seed = 2}, .03, .05);
}

}  // namespace
