/// Lights that are biased by request: clamped points and thick beams. What a clamp takes away and what it leaves are together what there was; beams approach rays as they thin.
#include <gmock/gmock.h>

#include "lights/light_technique.hpp"
#include "lights/progressive_radius.hpp"
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
const LayerSet layers = LayerSet().add(Layer::media_to_media).add(Layer::media_to_surface);

const LayerReport& line(const WholeRender& render, Layer layer) { return render.report().layers[static_cast<std::size_t>(layer)]; }

/// Mean distance of two images' pixels over the mean of the second.
double mean_difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b)
{
    double difference = 0, sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) difference += std::abs(a[i][c] - b[i][c]), sum += b[i][c];
    return difference / sum;
}

/// Both layers, with and without a choice of lights.
void expect_nothing_lost(const Scene& scene, double clamp)
{
    for (const Selection selection : {Selection::all, Selection::tile}) {
        RenderSettings settings{.method = Method("vpl"), .layers = layers, .passes = 6, .lights = 256, .selection = selection};
        const WholeRender whole = render_whole(scene, settings);
        settings.method = Method("vpl-clamped"), settings.clamp = clamp;
        const WholeRender clamped = render_whole(scene, settings);
        for (const Layer layer : {Layer::media_to_media, Layer::media_to_surface}) {
            double before = 0, after = 0;
            for (const int c : {0, 1, 2}) before += whole(layer, c).value(), after += clamped(layer, c).value();
            const LayerReport& report = line(clamped, layer);
            EXPECT_FALSE(report.unbiased);
            EXPECT_THAT(report.bias, HasSubstr("over the square of the scene's half diagonal"));
            EXPECT_GT(report.removed, .001) << name(layer) << ": the clamp does nothing, and neither does the test";
            EXPECT_LT(report.removed, .999);
            EXPECT_NEAR(after / (1 - report.removed) / before, 1, 1e-5) << name(layer);  // the same places, summed in float
            EXPECT_LT(line(whole, layer).removed, 0);
            EXPECT_TRUE(line(whole, layer).unbiased);
        }
    }
}

TEST(ClampedPoints, LoseWhatTheReportSaysWhereNothingOccludes) { expect_nothing_lost(scene_of(fog_cube + floor_below + lamp + view), 5); }

TEST(ClampedPoints, LoseWhatTheReportSaysAroundAnOccluder)
{
    expect_nothing_lost(scene_of(fog_cube + box({-.3, .05, -.3}, {.3, .15, .3}, diffuse(Rgb(.5))) + floor_below + lamp + view), 20);
}

TEST(ClampedPoints, LoseWhatTheReportSaysAcrossNestedMedia)
{
    expect_nothing_lost(scene_of(fog_cube + medium("smoke", Rgb(4, 3, 2), Rgb(.7), -.3) + container({-.3, -.2, -.2}, {.1, .3, .3}, "smoke", "fog") + floor_below + lamp + view), 10);
}

TEST(ClampedPoints, KnowNoUnitOfLength)
{
    const auto scaled = [](double k) {
        return scene_of(medium("fog", Rgb(.5, 1, 2) / k, Rgb(.95, .9, .8), .5) + container(Vec3(-.5) * k, Vec3(.5) * k, "fog") + horizontal({0, -.8 * k, 0}, 1.5 * k, true, diffuse(Rgb(.5))) +
                        horizontal({.2 * k, 1.2 * k, .1 * k}, .3 * k, false, diffuse(Rgb(0)) + glow(Rgb(4, 3, 2))) + sensor({.origin = Vec3(.3, .6, 3) * k, .near_clip = 1e-4 * k, .far_clip = 1e4 * k}));
    };
    const RenderSettings settings{.method = Method("vpl-clamped"), .layers = layers, .passes = 2, .lights = 128, .clamp = 8};
    const WholeRender one = render_whole(scaled(1), settings), other = render_whole(scaled(1024), settings);
    for (const Layer layer : {Layer::media_to_media, Layer::media_to_surface}) EXPECT_EQ(line(one, layer).removed, line(other, layer).removed);
}

std::vector<std::string> thick_methods()
{
    std::vector<std::string> methods;
    for (const LightTechnique& technique : light_techniques())
        if (technique.is_thick && !technique.gathered()) methods.emplace_back(technique.method);
    return methods;
}

/// Thick lights are rays with a thickness: they have the same places.
class ThickLights : public testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ThickLights);
INSTANTIATE_TEST_SUITE_P(All, ThickLights, testing::ValuesIn(thick_methods()));

TEST_P(ThickLights, ApproachRaysAsTheyThin)
{
    const Scene scene = scene_of(fog_cube + floor_below + lamp + view);
    RenderSettings settings{.method = Method::vrl, .layers = layers, .passes = 60, .lights = 256};
    const WholeRender rays = render_whole(scene, settings);
    settings.method = Method(GetParam());
    double before = 1;
    for (const double radius : {.4, .1, .025}) {
        settings.beam_radius = radius;
        const WholeRender beams = render_whole(scene, settings);
        // The same light paths, places and numbers: what differs is the thickness alone.
        const double difference = mean_difference(beams.film().mean(Layer::media_to_media), rays.film().mean(Layer::media_to_media));
        std::printf("radius %g: %g of the light is elsewhere\n", radius, difference);
        EXPECT_LT(difference, .6 * before) << radius;
        EXPECT_GT(difference, 0);
        before = difference;
        EXPECT_FALSE(line(beams, Layer::media_to_media).unbiased);
        EXPECT_THAT(line(beams, Layer::media_to_media).bias, HasSubstr(fmt::format("radius of {:.3g} of the scene's half diagonal in the first pass", radius)));
        EXPECT_THAT(line(beams, Layer::media_to_media).bias, HasSubstr(fmt::format("in the last of 60 it was {:.3g} times as wide", progressive_radius(1, 59))));
    }
}

TEST(BiasedLights, RefuseWhatMakesNoSense)
{
    const Scene scene = scene_of(fog_cube + lamp + view);
    const auto refusal = [&](RenderSettings settings) -> std::string {
        settings.passes = 1;
        try {
            render(scene, settings);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(refusal({.method = Method("vpl-clamped"), .clamp = 0}), HasSubstr("above 0"));
    EXPECT_THAT(refusal({.method = Method("vpl-clamped"), .clamp = std::nan("")}), HasSubstr("above 0"));
    EXPECT_THAT(refusal({.method = Method::vrl, .clamp = 5}), HasSubstr("use --method vpl-clamped"));
    for (const std::string& method : thick_methods())
        for (const double radius : {0., -1., std::nan(""), 2.}) EXPECT_THAT(refusal({.method = Method(method), .beam_radius = radius}), HasSubstr("above 0"));
    EXPECT_THAT(refusal({.method = Method("vpl"), .beam_radius = .1}), HasSubstr("--beam-radius is for lights that are thick"));
    EXPECT_THAT(refusal({.method = Method("lanterns")}), HasSubstr("unknown method \"lanterns\"; there are: "));
}

}  // namespace
