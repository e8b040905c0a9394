/// Virtual point lights on surfaces against path tracing, layer by layer and channel by channel; what explain and report say of them.
#include <gmock/gmock.h>

#include "pipeline/explain.hpp"
#include "surface_lights.hpp"

using namespace tyndall;
using namespace tyndall::test;
using namespace tyndall::test::surface_lights;
using testing::HasSubstr;

namespace {

/// The connections from floor to wall pass through the fog, those of the fog start outside of it.
TEST(SurfaceLights, FogAroundAnOccluder) { expect_agreement(scene_of(fog_cube + occluder + wall + floor_below + lamp + view), .03); }

/// Neither end of a connection may be glossy: paths carry what has a glossy surface at one, and nothing is missing or counted twice.
TEST(SurfaceLights, GlossySurfacesAreLeftToPaths)
{
    const std::string plastic = R"(<bsdf type="plastic"><rgb name="diffuse_reflectance" value=".1 .4 .6"/></bsdf>)",
                      metal = R"(<bsdf type="roughconductor"><float name="alpha" value=".25"/><rgb name="eta" value=".2 .9 1.1"/><rgb name="k" value="3.9 2.4 2.2"/></bsdf>)";
    const std::string floors = horizontal({-.85, -.8, 0}, .7, true, plastic) + horizontal({.85, -.8, 0}, .7, true, diffuse(Rgb(.5, .25, .75))) + box({-1.2, .3, -1.2}, {1.2, .9, -1}, metal);
    const Scene scene = scene_of(fog_cube + wall + floors + lamp + view);
    expect_agreement(scene, .06);
    const Explanation e = explain(scene, {.method = Method("vpl"), .passes = 1});
    for (const Layer layer : {Layer::surface_to_media, Layer::surface_indirect}) {
        const LayerReport& line = e.layers[static_cast<std::size_t>(layer)];
        EXPECT_EQ(line.technique, "virtual point lights on surfaces, path tracing");
        EXPECT_THAT(line.why, HasSubstr("paths where plastic, rough metal or rough glass reflects"));
        EXPECT_TRUE(line.unbiased);
    }
}

/// What the clamp removes and what it leaves are together what there was.
TEST(SurfaceLights, ClampedLoseWhatTheReportSays)
{
    const Scene scene = scene_of(fog_cube + occluder + wall + floor_below + lamp + view);
    for (const Selection selection : {Selection::all, Selection::tile}) {
        const WholeRender whole = by_points(scene, {.passes = 6, .selection = selection});
        const WholeRender clamped = render_whole(scene, {.method = Method("vpl-clamped"), .layers = both, .passes = 6, .lights = 256, .selection = selection, .clamp = 5});
        for (const Layer layer : {Layer::surface_to_media, Layer::surface_indirect}) {
            double before = 0, after = 0;
            for (const int c : {0, 1, 2}) before += whole(layer, c).value(), after += clamped(layer, c).value();
            const LayerReport& report = clamped.report().layers[static_cast<std::size_t>(layer)];
            EXPECT_FALSE(report.unbiased);
            EXPECT_THAT(report.bias, HasSubstr("over the square of the scene's half diagonal"));
            EXPECT_GT(report.removed, .001) << name(layer);
            EXPECT_LT(report.removed, .999);
            EXPECT_NEAR(after / (1 - report.removed) / before, 1, 1e-5) << name(layer);  // the same places, summed in float
        }
    }
}

TEST(SurfaceLights, ExplainAndReportNameThem)
{
    const std::string mirror = horizontal({0, -1, 0}, 6, true, R"(<bsdf type="conductor"><string name="material" value="none"/></bsdf>)");
    const Scene scene = scene_of(fog_cube + wall + floor_below + mirror + lamp + view);
    const Explanation e = explain(scene, {.method = Method("vpl"), .passes = 1});
    const auto line = [&](Layer layer) { return e.layers[static_cast<std::size_t>(layer)]; };
    for (const Layer layer : {Layer::surface_to_media, Layer::surface_indirect}) EXPECT_EQ(line(layer).technique, "virtual point lights on surfaces") << name(layer);
    for (const Layer layer : {Layer::media_to_media, Layer::media_to_surface}) EXPECT_EQ(line(layer).technique, "virtual point lights") << name(layer);
    EXPECT_EQ(line(Layer::surface_indirect_specular).technique, "path tracing");
    EXPECT_EQ(line(Layer::surface_indirect_specular).why, "connections by straight lines do not pass mirrors and glass");
    EXPECT_EQ(line(Layer::surface_direct).technique, "next-event estimation");
    for (const char* kernels : {"surface_to_media", "surface_indirect"})
        EXPECT_THAT(e.kernels, testing::Contains(testing::Field(&KernelReport::layer, kernels))) << kernels;
}

TEST(SurfaceLights, GiveTheSameBytesForAnyThreadsAndTiles)
{
    const Scene scene = scene_of(fog_cube + occluder + wall + floor_below + lamp + view);
    for (const Selection selection : {Selection::all, Selection::tile}) {
        RenderSettings settings{.method = Method("vpl"), .passes = 3, .lights = 300, .threads = 1, .selection = selection};
        const WholeRender one = render_whole(scene, settings);
        settings.threads = 2, settings.tile_pairs = 4096;
        const WholeRender other = render_whole(scene, settings);
        expect_same_bytes(one.film(), other.film());
    }
}

TEST(SurfaceLightsTest, APowerThatIsWrongByAFifthIsSeen)
{
    const Scene scene = scene_of(fog_cube + occluder + wall + floor_below + lamp + view);
    const WholeRender path = render_whole(scene, {.method = Method::path, .layers = both, .passes = 2000, .seed = 2}), lights = by_points(scene, {.passes = 200});
    for (const Layer layer : {Layer::surface_to_media, Layer::surface_indirect}) {
        const Mean &a = lights(layer), &b = path(layer);
        const double error = std::sqrt(a.variance_of_mean() + b.variance_of_mean());
        EXPECT_GT(std::abs(1.2 * a.value() - b.value()), allowed_sigmas * error) << name(layer) << ": a fifth too much is within the error: the comparison is blind";
    }
}

}  // namespace
