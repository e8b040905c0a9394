/// What is said before a render, and the prediction beside the measurement after it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "film/film.hpp"
#include "kernels/shared/host_features.hpp"
#include "pipeline/explain.hpp"
#include "pipeline/forecast.hpp"
#include "pipeline/memory_estimate.hpp"
#include "pipeline/render.hpp"
#include "pipeline/savings.hpp"
#include "scene_parts.hpp"
#include "support/feature_cover.hpp"
#include "tests/support/feature_cover.hpp"

namespace tyndall::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

const std::string far_ball = shape("sphere", "ball", R"(<scale value=".3"/><translate x="1.2"/>)", white);
Scene foggy_room() { return scene_of({medium("fog"), lamp(in_fog), far_ball}, in_fog); }
Scene box_of_fog() { return scene_of({medium("fog"), lamp(), container("cube", "box", here)}); }

Explanation explained(const Scene& scene, RenderSettings settings = {}) { return settings.passes = 4, explain(scene, settings); }

std::vector<std::string> kernel_names(const Explanation& e)
{
    std::vector<std::string> names;
    for (const KernelReport& kernel : e.kernels) names.push_back(kernel.layer + "." + kernel.kernel + ": " + kernel.features);
    return names;
}

const LayerReport& line_of(const Explanation& e, Layer layer) { return e.layers[static_cast<std::size_t>(layer)]; }

TEST(Explain, LeavesOutSurfacesThatNoMediumCanLight)
{
    const Scene behind = scene_of({medium("fog"), lamp(), container("cube", "box", here), shape("rectangle", "table", R"(<rotate x="1" angle="90"/><translate y="-2"/>)", white)});
    EXPECT_TRUE(line_of(explained(behind), Layer::media_to_surface).skipped);
    EXPECT_THAT(line_of(explained(behind), Layer::media_to_surface).why, HasSubstr("faces a medium"));
    const Scene front = scene_of({medium("fog"), lamp(), container("cube", "box", here), shape("rectangle", "table", below, white)});
    EXPECT_FALSE(line_of(explained(front), Layer::media_to_surface).skipped);
}

TEST(Explain, SaysWhyEveryLayerIsRenderedAsItIs)
{
    for (const LayerReport& layer : explained(foggy_room()).layers) EXPECT_FALSE(layer.why.empty()) << layer.layer;
    const Explanation even = explained(box_of_fog()), uneven = explained(scene_of({medium("fog", ".5", ".8", forward), lamp(), container("cube", "box", here)}));
    EXPECT_EQ(line_of(even, Layer::media_to_media).sampler, "paper-isotropic");
    EXPECT_THAT(line_of(even, Layer::media_to_media).sampler_why, HasSubstr("angle alone"));
    EXPECT_EQ(line_of(uneven, Layer::media_to_media).sampler, "paper");
    EXPECT_THAT(line_of(uneven, Layer::media_to_media).sampler_why, AllOf(HasSubstr("\"fog\""), HasSubstr("0.6")));
    EXPECT_THAT(to_text(uneven), HasSubstr("sampler paper: medium"));
    EXPECT_THAT(line_of(uneven, Layer::media_to_media).sampler_why, HasSubstr("nothing stands between"));
    RenderSettings table;
    table.sampler = Sampler::table;
    EXPECT_EQ(line_of(explained(box_of_fog(), table), Layer::media_to_media).sampler, "table");
    RenderSettings path;
    path.method = Method::path;
    EXPECT_EQ(line_of(explained(box_of_fog(), path), Layer::media_to_media).sampler, "") << "a path tracer connects nothing";
}

/// Between the two crossings shadow segments decide; the mask that kernels are built with does not.
TEST(Explain, ChoosesTheSamplerByWhatStandsBetweenMedia)
{
    const std::string mild = R"(<phase type="hg"><float name="g" value="-.4"/></phase>)", block = shape("cube", "block", small, white);
    const Scene open = scene_of({medium("fog", ".5", ".8", mild), lamp(), container("cube", "box", here)}),
                blocked = scene_of({medium("fog", ".5", ".8", mild), lamp(), container("cube", "box", here), block});
    EXPECT_EQ(line_of(explained(open), Layer::media_to_media).sampler, "paper-isotropic");
    EXPECT_EQ(line_of(explained(blocked), Layer::media_to_media).sampler, "paper");
    EXPECT_THAT(line_of(explained(blocked), Layer::media_to_media).sampler_why, HasSubstr("shadow segments"));
    RenderSettings all;
    all.features = test::every_feature;
    EXPECT_EQ(line_of(explained(open, all), Layer::media_to_media).sampler, "paper-isotropic");
    const Scene nearly = scene_of({medium("fog", ".5", ".8", R"(<phase type="hg"><float name="g" value=".54"/></phase>)"), lamp(), container("cube", "box", here)}),
                just = scene_of({medium("fog", ".5", ".8", R"(<phase type="hg"><float name="g" value=".55"/></phase>)"), lamp(), container("cube", "box", here)});
    EXPECT_EQ(line_of(explained(nearly), Layer::media_to_media).sampler, "paper-isotropic");
    EXPECT_EQ(line_of(explained(just), Layer::media_to_media).sampler, "paper");
}

TEST(Explain, NamesTheElementOfEveryEffectThatWasFound)
{
    const Explanation e = explained(foggy_room());
    ASSERT_EQ(e.effects.size(), effect_list().size());
    for (const EffectReport& effect : e.effects) {
        EXPECT_EQ(effect.found, !effect.cause.empty()) << effect.effect;
        if (effect.effect == "OCCLUDERS") { EXPECT_EQ(effect.cause, "scene.xml:4:1: shape \"ball\" may stand in between"); }
    }
}

TEST(Explain, NamesKernelsWithTheirMasks)
{
    using Names = std::vector<std::string>;
    const Names of_all{"media_to_media.sample_pairs: OCCLUDERS", "all layers.accumulate_pairs: none", "media_to_surface.sample_pairs: OCCLUDERS"};
    EXPECT_EQ(kernel_names(explained(foggy_room(), {.selection = Selection::all})), of_all);
    EXPECT_THAT(kernel_names(explained(foggy_room())), testing::IsSupersetOf(Names{"media_to_media.estimate_lights: none", "all layers.weigh_lights: none", "all layers.select_lights: none"}));
    EXPECT_TRUE(explained(foggy_room(), {.method = Method::path}).kernels.empty() && explained(scene_of({lamp(), far_ball})).kernels.empty());
    const Explanation by_hand = explained(foggy_room(), {.features = feature_bit::occluders | feature_bit::anisotropic, .lanes = 8});
    EXPECT_EQ(by_hand.kernels[0].features, "ANISOTROPIC OCCLUDERS");
    EXPECT_THAT(by_hand.kernels[0].options, HasSubstr("-DLANES=8 -DFEATURES=5u"));
}

TEST(Explain, BuildsWhatTheRenderBuilds)
{
    for (const Scene& scene : {foggy_room(), box_of_fog(), scene_of({medium("fog", ".5, .1, .2", ".8", forward), lamp(in_fog)}, in_fog)}) {
        const Report report = render(scene, {.passes = 1, .lights = 16, .lanes = 16}).report;
        const Explanation e = explained(scene, {.lights = 16, .lanes = 16});
        EXPECT_EQ(report.programs, e.kernels.size());
        for (const KernelReport& kernel : e.kernels)
            if (kernel.layer != "all layers" && kernel.kernel != "estimate_lights") { EXPECT_THAT(report.build_options, HasSubstr(kernel.layer + ": " + kernel.options)); }
    }
}

TEST(Explain, FilmMemoryIsWhatAFilmTakes)
{
    const Scene scene = foggy_room();
    for (const int passes : {4, 9}) {
        const RenderSettings settings{.passes = passes, .lights = 16};
        const RenderOutcome outcome = render(scene, settings);
        const Explanation e = explain(scene, settings);
        EXPECT_EQ(e.memory[0].what, "film");
        EXPECT_EQ(e.memory[0].bytes, outcome.film.memory_bytes()) << passes << " passes";
    }
}

/// A scene, and a piece of the only doubt about it.
void expect_doubt(const Scene& scene, const std::string& doubt, const RenderSettings& settings = {})
{
    const Explanation e = explained(scene, settings);
    EXPECT_THAT(e.warnings, Contains(HasSubstr(doubt)));
    EXPECT_EQ(e.warnings.size(), 1u) << ::testing::PrintToString(e.warnings);
}

TEST(Explain, FindsNothingToDoubtInPlainScenes)
{
    for (const Scene& scene : {foggy_room(), box_of_fog(), scene_of({lamp(), far_ball})}) EXPECT_TRUE(explained(scene).warnings.empty()) << explained(scene).warnings[0];
}

TEST(Explain, DoubtsALightThatReachesNothing)
{
    const std::string away = R"(<emitter type="spot" id="torch"><transform name="to_world"><lookat origin="0, 3, 0" target="0, 9, 0" up="0, 0, 1"/></transform></emitter>)";
    expect_doubt(scene_of({lamp(), away, far_ball}), "scene.xml:3:1: emitter \"torch\": of 1024 rays none reaches");
    expect_doubt(scene_of({lamp(), R"(<emitter type="point" id="off"><rgb name="intensity" value="0"/></emitter>)", far_ball}), "emitter \"off\" gives no light");
    expect_doubt(scene_of({lamp(), shape("sphere", "coal", small, black)}), "emitter \"lamp\": of 1024 rays none reaches");
}

TEST(Explain, DoubtsAMediumThatNobodySees)
{
    expect_doubt(scene_of({medium("fog"), lamp(), container("cube", "box", R"(<translate z="9"/>)"), far_ball}), "scene.xml:2:1: medium \"fog\": no camera ray crosses it");
}

TEST(Explain, DoubtsVirtualRayLightsInThickMediaOnly)
{
    const auto box = [](const char* sigma_t) { return scene_of({medium("fog", sigma_t), lamp(), container("cube", "box", here)}); };  // its diagonal is 3.46
    expect_doubt(box("10"), "is 34.6 mean free paths thick: above 20, path tracing tends to reach");
    EXPECT_TRUE(explained(box("5")).warnings.empty());
    for (const RenderSettings& paths : {RenderSettings{.method = Method::path}, {.path_layers = LayerSet().add(Layer::media_to_media)}}) EXPECT_TRUE(explained(box("10"), paths).warnings.empty());
}

TEST(Explain, DoubtsMeanFreePathsOnAnotherScale)
{
    expect_doubt(scene_of({medium("fog", "1e-6"), lamp(in_fog), far_ball}, in_fog), "medium \"fog\": its mean free path is");
    const Explanation thick = explained(scene_of({medium("fog", "1e5"), lamp(), container("cube", "box", here)}));
    EXPECT_THAT(thick.warnings, AllOf(Contains(HasSubstr("check the units of sigma_t")), Contains(HasSubstr("path tracing tends to reach"))));
}

/// The box of fog with a grid of 8^3 voxels in it, one of them `densest`, the others 1.
Scene box_of_smoke(float densest)
{
    Scene scene = box_of_fog();
    Volume volume{.name = "smoke.vol", .size_x = 8, .size_y = 8, .size_z = 8, .values = std::vector<float>(512, 1.f), .where = scene.media[0].where};
    const Bounds box = bounds_of(scene.shapes[0]);
    for (int axis = 0; axis < 3; ++axis) volume.to_world[axis][axis] = box.high[axis] - box.low[axis], volume.to_world[3][axis] = box.low[axis];
    volume.values[77] = densest;
    scene.volumes.push_back(volume), scene.media[0].density = 0;
    return scene;
}

TEST(Explain, GridsTakeMemoryOnHostAndDevice)
{
    const auto bytes = [](const Scene& scene, bool on_device) {
        std::uint64_t sum = 0;
        for (const MemoryReport& m : explained(scene).memory)
            if (m.what.starts_with("grids of voxels") && m.on_device == on_device) sum += m.bytes;
        return sum;
    };
    EXPECT_EQ(bytes(box_of_smoke(1), false), 2048u);
    EXPECT_EQ(bytes(box_of_smoke(1), true), 2048u);  // of its one kind of eye
    EXPECT_EQ(bytes(box_of_fog(), false) + bytes(box_of_fog(), true), 0u);
}

TEST(Explain, DensityEstimationTakesMemoryAndSavesShadowSegments)
{
    const Explanation e = explained(foggy_room(), {.method = Method("talk"), .passes = 1, .lights = 1000});
    for (const char* lights : {"photon beams", "photons", "media_to_media"})
        for (const char* what : {": eyes and their sums", ": lights"})
            EXPECT_THAT(e.memory, Contains(testing::Truly([&](const MemoryReport& m) { return m.bytes > 0 && m.on_device && m.what.starts_with(lights) && m.what.find(what[2] == 'e' ? "eyes" : "lights") != std::string::npos; }))) << lights << what;
    EXPECT_THAT(e.memory, Contains(testing::Truly([](const MemoryReport& m) { return m.what == "photons: lights" && m.bytes == 64000; })));
    EXPECT_THAT(e.savings, Contains(testing::Field(&SavingReport::because, HasSubstr("photon beams: eyes take from light paths that come near"))));
    EXPECT_THAT(e.savings, Contains(testing::Field(&SavingReport::because, HasSubstr("and photon beams without COLOURED"))));
}

TEST(Explain, DoubtsGoByTheDensestVoxel)
{
    EXPECT_THAT(explained(box_of_smoke(11)).warnings, Not(Contains(HasSubstr("mean free paths thick"))));  // .5 x 11 x sqrt(12) = 19.05
    EXPECT_THAT(explained(box_of_smoke(12)).warnings, Contains(HasSubstr("medium \"fog\" is up to 20.8 mean free paths thick: above 20")));
}

TEST(Explain, SavesWhatKernelsAreBuiltWithout)
{
    const auto saved = [](const Explanation& e) {
        std::set<std::string> lines;
        for (const SavingReport& s : e.savings) lines.insert(s.because);
        return lines;
    };
    EXPECT_TRUE(saved(explained(foggy_room())).contains("media_to_media and media_to_surface without COLOURED"));
    EXPECT_FALSE(saved(explained(foggy_room())).contains("media_to_media and media_to_surface without OCCLUDERS"));
    EXPECT_TRUE(saved(explained(box_of_fog())).contains("media_to_media without OCCLUDERS"));
    EXPECT_TRUE(saved(explained(box_of_fog())).contains("no surface of the scene scatters light"));
    EXPECT_TRUE(explained(foggy_room(), {.method = Method::path}).savings.empty());
    const Explanation general = explained(foggy_room(), {.features = every_feature});
    EXPECT_TRUE(general.savings.empty()) << general.savings[0].because;
}

TEST(Explain, JsonHasItsSchemaAndNullForWhatIsNotKnown)
{
    const auto json = nlohmann::json::parse(to_json(explained(foggy_room())));
    EXPECT_EQ(json.at("schema"), "tyndall-explain/1");
    for (const char* key : {"scene", "method", "device", "lanes", "lights", "effects", "layers", "kernels", "memory", "savings", "calibration", "warnings"}) EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_TRUE(json.at("calibration").is_null());
    EXPECT_EQ(json.at("layers").size(), layer_count);
}

TEST(Explain, TextNamesEffectsKernelsAndReasons)
{
    const std::string text = to_text(explained(foggy_room()));
    for (const char* part : {"shape \"ball\" may stand in between", "skipped: the scene has no mirror or glass", "sample_pairs", "on the device", "without ANISOTROPIC"}) EXPECT_THAT(text, HasSubstr(part));
}

TEST(Calibration, ShrinksAFilmThatWouldTakeTooLong)
{
    Scene scene = foggy_room();
    const Calibration whole = calibrate(scene, {.passes = 24, .lights = 256}, 60);
    EXPECT_EQ(whole.film_share, 1);
    EXPECT_GE(whole.passes, 2);
    EXPECT_GT(whole.seconds_to_one_percent, whole.pass_seconds);
    scene.camera.width = scene.camera.crop_width = 480, scene.camera.height = scene.camera.crop_height = 320;
    EXPECT_LT(calibrate(scene, {.passes = 2, .lights = 64}, .01).film_share, .9);
}

TEST(Forecast, ComesFromTheSecondPass)
{
    Forecast forecast;
    const RenderSettings settings{.passes = 10};
    const auto error = [] { return .3; };
    forecast.after_pass(settings, 1, 5, error);
    EXPECT_FALSE(forecast.prediction());
    forecast.after_pass(settings, 2, 6, error);
    forecast.after_pass(settings, 3, 60, error);  // does not move it
    ASSERT_TRUE(forecast.prediction());
    EXPECT_EQ(forecast.prediction()->passes, 10);
    EXPECT_DOUBLE_EQ(forecast.prediction()->seconds, 6 + 8);
    EXPECT_DOUBLE_EQ(forecast.prediction()->error, .3 * std::sqrt(.2));
}

TEST(Forecast, TakesTheShorterOfPassesAndTime)
{
    const auto passes = [](RenderSettings settings) {
        Forecast forecast;
        forecast.after_pass(settings, 1, 5, [] { return -1.; });
        forecast.after_pass(settings, 2, 7, [] { return -1.; });
        return forecast.prediction() ? forecast.prediction()->passes : 0;
    };
    EXPECT_EQ(passes({.passes = 0, .seconds = 18}), 2 + 5);
    EXPECT_EQ(passes({.passes = 4, .seconds = 18}), 4);
    EXPECT_EQ(passes({.passes = 100, .seconds = 18}), 7);
    EXPECT_EQ(passes({.passes = 2}), 0);
    EXPECT_EQ(passes({.passes = 0, .seconds = 8}), 0);
}

TEST(Forecast, StandsInTheReport)
{
    const Report report = render(foggy_room(), {.passes = 5, .lights = 16}).report;
    ASSERT_TRUE(report.prediction);
    EXPECT_EQ(report.prediction->passes, 5);
    EXPECT_GT(report.prediction->seconds, 0);
    EXPECT_FALSE(render(foggy_room(), {.passes = 2, .lights = 16}).report.prediction);
}

}  // namespace
}  // namespace tyndall::test
