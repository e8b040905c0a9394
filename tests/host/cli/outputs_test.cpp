#include "cli/outputs.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "film/exr.hpp"
#include "support/child_process.hpp"
#include "support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

TEST(PlanOutputs, NamesFollowTheSceneOrTheOutput)
{
    const auto by_scene = plan_outputs("scenes/fog/scene.xml", "", "");
    EXPECT_EQ(by_scene.exr, "scene.exr");
    EXPECT_EQ(by_scene.png, "scene.png");
    EXPECT_EQ(by_scene.report, "scene.json");
    const auto by_output = plan_outputs("scene.xml", "out/a.b.exr", "r.txt");
    EXPECT_EQ(by_output.exr, "out/a.b.exr");
    EXPECT_EQ(by_output.png, "out/a.b.png");
    EXPECT_EQ(by_output.report, "r.txt");
}

TEST(PlanOutputs, RefusesOtherEndingsAndClashes)
{
    for (const auto* output : {"a.png", "a", "a.EXR", "dir/"}) EXPECT_THROW(plan_outputs("s.xml", output, ""), UsageError) << output;
    EXPECT_THROW(plan_outputs("s.xml", "a.exr", "a.exr"), UsageError);
    EXPECT_THROW(plan_outputs("s.xml", "a.exr", "./b/../a.png"), UsageError);
    EXPECT_THROW(plan_outputs("s.xml", "a.exr", "s.xml"), UsageError);  // would overwrite the scene
}

Film small_film()
{
    LayerSet single;
    Film film(2, 2, single.add(Layer::single));
    PassImage image(2, 2, single);
    image[Layer::single] = {Rgb(1), Rgb(2), Rgb(3), Rgb(4)};
    film.add_pass(image);
    film.add_pass(image);
    return film;
}

Report small_report()
{
    Report report;
    report.version = "0.1.0 (abc)", report.scene = "folder/s.xml", report.scene_hash = 255, report.seed = 7;
    report.virtual_lights = 1000, report.method = "vrl", report.device = "dev", report.driver = "drv", report.build_options = "opt";
    report.seconds = 12, report.error = .5, report.lanes = 4;
    report.effects = {{"A", true}, {"B", false}, {"C", true}};
    report.layers = {{"single", "equi-angular", false, "", true}, {"emitted", "skipped", true, "off", true}};
    return report;
}

constexpr FilmWindow small_window{.x = 3, .y = 2, .full_width = 8, .full_height = 6};

TEST(WriteOutputs, EverythingIsThereAndSaysHowItWasMade)
{
    test::TemporaryFolder folder;
    const auto paths = plan_outputs("s.xml", folder / "a.exr", "");
    auto report = small_report();
    write_outputs(paths, small_film(), small_window, {.exposure = 1.}, {}, report);
    const auto image = read_exr(paths.exr);
    EXPECT_EQ(image.x, 3);
    EXPECT_EQ(image.display_width, 8);
    const auto text = [&](const char* name) { return std::get<std::string>(image.attributes.at(name)); };
    EXPECT_EQ(text("tyndall.version"), "0.1.0 (abc)");
    EXPECT_EQ(text("tyndall.scene"), "s.xml");
    EXPECT_EQ(text("tyndall.scene_hash"), "00000000000000ff");
    EXPECT_EQ(text("tyndall.seed"), "7");
    EXPECT_EQ(text("tyndall.lights"), "1000");
    EXPECT_EQ(text("tyndall.methods"), "single: equi-angular");
    EXPECT_EQ(text("tyndall.effects"), "A C");
    EXPECT_EQ(text("tyndall.device"), "dev");
    EXPECT_EQ(text("tyndall.driver"), "drv");
    EXPECT_EQ(text("tyndall.build_options"), "opt");
    EXPECT_EQ(std::get<int>(image.attributes.at("tyndall.passes")), 2);
    EXPECT_EQ(std::get<int>(image.attributes.at("tyndall.block_passes")), 8);
    EXPECT_EQ(std::get<double>(image.attributes.at("tyndall.seconds")), 12);
    EXPECT_EQ(std::get<double>(image.attributes.at("tyndall.error")), .5);
    const auto json = nlohmann::json::parse(test::file_bytes(paths.report));
    EXPECT_EQ(json.at("exposure"), 1);
    EXPECT_EQ(json.at("outputs").size(), 3u);
    EXPECT_GT(std::filesystem::file_size(paths.png), 50u);
}

TEST(WriteOutputs, WithoutTimestampsTheImageDoesNotDependOnTheClock)
{
    test::TemporaryFolder folder;
    std::string bytes[2];
    for (const int run : {0, 1}) {
        const auto paths = plan_outputs("s.xml", folder / (std::to_string(run) + ".exr"), "");
        auto report = small_report();
        report.seconds = run;
        write_outputs(paths, small_film(), small_window, {.timestamps = false}, {}, report);
        bytes[run] = test::file_bytes(paths.exr);
    }
    EXPECT_FALSE(bytes[0].empty());
    EXPECT_EQ(bytes[0], bytes[1]);
}

TEST(WriteOutputs, ExposureIsAutomaticUnlessGiven)
{
    test::TemporaryFolder folder;
    auto report = small_report();
    write_outputs(plan_outputs("s.xml", folder / "a.exr", ""), small_film(), small_window, {}, {}, report);
    ASSERT_TRUE(report.exposure.has_value());
    EXPECT_NEAR(std::exp2(*report.exposure) * 3, .7, 1e-12);  // of 1 2 3 4, the value at .95 * 3, rounded down
}

}  // namespace
}  // namespace tyndall
