/// Photon beams and photons in whole renders: their layers approach path tracing as the radius falls, at the rate that is predicted, whatever the media; light behind mirrors and glass that paths
/// cannot find is there; and bytes depend on neither threads nor tiles.
#include <gmock/gmock.h>

#include "lights/light_technique.hpp"
#include "lights/progressive_radius.hpp"
#include "pipeline/explain.hpp"
#include "tyndall/error.hpp"
#include "whole_renderer.hpp"

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

/// Mean over the pixels of every pass, by layer and channel.
using Passes = std::array<std::vector<Rgb>, layer_count>;

Passes passes_of(const Scene& scene, const RenderSettings& settings)
{
    Passes passes;
    std::array<Rgb, layer_count> before{};
    const RenderOutcome outcome = render(scene, settings, [&](const Progress& progress, const Film& film) {
        for (std::size_t l = 0; l < layer_count; ++l) {
            const Rgb sum = mean_over_pixels(film.mean(static_cast<Layer>(l))) * double(progress.passes_done);
            passes[l].push_back(sum - before[l]), before[l] = sum;
        }
        return true;
    });
    EXPECT_EQ(outcome.report.ledger.not_finite_pairs, 0u);
    return passes;
}

/// Renders at four times, twice and once the radius: the same light paths and eyes, so that differences are the radius's alone.
std::array<Passes, 3> at_three_radii(const Scene& scene, RenderSettings settings, double radius)
{
    std::array<Passes, 3> all;
    for (int k = 0; k < 3; ++k) {
        settings.beam_radius = radius * (4 >> k);
        all[static_cast<std::size_t>(k)] = passes_of(scene, settings);
    }
    return all;
}

/// At radius 0, taking away what grows as the radius (at boundaries) and as its square.
Mean extrapolated(const std::array<Passes, 3>& at, Layer layer, int channel)
{
    Mean mean;
    const auto l = static_cast<std::size_t>(layer);
    for (std::size_t pass = 0; pass < at[0][l].size(); ++pass) mean.add((8 * at[2][l][pass][channel] - 6 * at[1][l][pass][channel] + at[0][l][pass][channel]) / 3);
    return mean;
}
Mean mean_of(const Passes& passes, Layer layer, int channel)
{
    Mean mean;
    for (const Rgb& pass : passes[static_cast<std::size_t>(layer)]) mean.add(pass[channel]);
    return mean;
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
    expect_agreement(scene, {.method = Method("beams"), .layers = of_beams, .passes = 100, .lights = 1500}, {.method = Method::path, .layers = of_beams, .passes = 3000, .seed = 2}, .03, .03);
}

TEST(PhotonBeams, ApproachPathTracingInNestedMediaWhenShort)
{
    const Scene scene = scene_of(fog_cube + smoke + container({-.3, -.2, -.2}, {.1, .3, .3}, "smoke", "fog") + floor_below + lamp + view);
    expect_agreement(scene, {.method = Method("beams"), .layers = of_beams, .passes = 100, .lights = 1500, .segment_length = SegmentLength::short_},
                     {.method = Method::path, .layers = of_beams, .passes = 3000, .seed = 2}, .03, .03);
}

TEST(PhotonBeams, ApproachPathTracingInADensityGrid)
{
    const Scene scene = parse_scene("<scene version=\"3.0.0\">" + puff + container(Vec3(-.5), Vec3(.5), "puff") + floor_below + lamp + view + "</scene>", TYNDALL_SOURCE_DIR "/scenes/plume", "scene.xml");
    for (const SegmentLength length : {SegmentLength::long_, SegmentLength::short_})
        expect_agreement(scene, {.method = Method("beams"), .layers = of_beams, .passes = 60, .lights = 1500, .segment_length = length},
                         {.method = Method::path, .layers = of_beams, .passes = 1500, .seed = 2}, .03, .06);
}

TEST(PhotonBeams, SingleAndDoubleScatteringAlone)
{
    const Scene scene = scene_of(fog_cube + floor_below + lamp + view);
    for (const int depth : {2, 3})
        expect_agreement(scene, {.method = Method("beams"), .layers = depth == 2 ? only(Layer::single) : of_beams, .passes = 60, .lights = 1500, .max_depth = depth},
                         {.method = Method::path, .layers = of_beams, .passes = 2000, .seed = 2, .max_depth = depth}, .03, .04);
}

const LayerSet of_photons = layers_of({Layer::surface_indirect, Layer::media_to_surface});

TEST(Photons, ApproachPathTracing)
{
    const std::string wall = box({-1.4, -.8, -1.2}, {1.4, 1, -1}, diffuse(Rgb(.8, .6, .4)));
    const Scene scene = scene_of(fog_cube + wall + floor_below + lamp + view);
    expect_agreement(scene, {.method = Method("photons"), .layers = of_photons, .passes = 60, .lights = 8000}, {.method = Method::path, .layers = of_photons, .passes = 3000, .seed = 2}, .03, .03);
}

}  // namespace
