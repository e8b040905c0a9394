#include <nlohmann/json.hpp>

#include "film/exr.hpp"
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST_F(Program, HelpShowsExamplesBeforeOptions)
{
    for (const auto& arguments : {std::vector<std::string>{"-h"}, {"render", "-h"}}) {
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 0);
        EXPECT_LT(result.out.find("Examples:"), result.out.find("Options:"));
        EXPECT_THAT(result.out, HasSubstr("tyndall render scene.xml"));
        EXPECT_EQ(result.err, "");
    }
    const auto render = run({"render", "-h"}).out;
    for (const auto* option :
         {"--passes",         "--time", "--lights", "--seed",          "--layer",         "--method",   "--threads", "--max-depth",
          "--light-segments", "--long", "--short",  "--resolution",    "--crop",          "--exposure", "--half",    "--lanes",
          "--device",         "--tile", "--define", "--allow-outside", "--no-timestamps", "--progress", "--report",  "--output"})
        EXPECT_THAT(render, HasSubstr(option));
}

TEST_F(Program, VersionNamesCommitAndLibraries)
{
    const auto result = run({"--version"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.out, testing::ContainsRegex("^tyndall [0-9]+\\.[0-9]+\\.[0-9]+ \\([0-9a-z-]+\\)"));
    for (const auto* library : {"Embree 3", "TBB 20[0-9]+", "OpenEXR 3", "libpng 1", "pugixml 1", "OpenVDB ([0-9]+\\.[0-9]+\\.[0-9]+|not built in)", "fmt [0-9]+", "nlohmann_json 3", "CLI11 2"})
        EXPECT_THAT(result.out, testing::ContainsRegex("\n" + std::string(library)));
}

// The loader speaks for itself, without drivers too.
TEST_F(Program, VersionNamesTheOpenCLLoader)
{
    for (const ProcessSetup& setup : {ProcessSetup{}, ProcessSetup{.environment = {{"OCL_ICD_VENDORS", "/nonexistent"}}}}) {
        const auto result = run({"--version"}, setup);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_THAT(result.out, testing::ContainsRegex("\n([^\n]+ [0-9]+\\.[0-9.]+ \\([^\n]+\\), OpenCL [0-9.]+|OpenCL headers [0-9.]+, the loader does not say its version)\n"));
    }
}

TEST_F(Program, RendersIntoThreeFilesNamedAfterTheScene)
{
    const auto result = run({"render", "scene.xml", "--method", "path", "--passes", "3"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "scene.exr\nscene.png\nscene.json\n");
    EXPECT_THAT(files(), ElementsAre("scene.exr", "scene.json", "scene.png", "scene.xml"));
    const auto image = read_exr(folder / "scene.exr");
    EXPECT_EQ(image.width, 16);
    EXPECT_EQ(image.height, 12);
    EXPECT_EQ(image.channels.at("samples").values[0], 3);
    EXPECT_EQ(std::get<int>(image.attributes.at("tyndall.passes")), 3);
    for (const auto* layer :
         {"emitted", "surface_direct", "surface_indirect", "single", "surface_to_media", "media_to_media", "media_to_surface"})
        EXPECT_TRUE(image.channels.contains(std::string(layer) + ".R")) << layer;
    const auto report = nlohmann::json::parse(file_bytes(folder / "scene.json"));
    EXPECT_EQ(report.at("schema"), "tyndall-report/1");
    EXPECT_EQ(report.at("passes"), 3);
    EXPECT_EQ(report.at("stopped_by"), "passes");
}

TEST_F(Program, LayersSumToTheBeauty)
{
    ASSERT_EQ(run({"render", "scene.xml", "--method", "path", "--passes", "2"}).exit_code, 0);
    const auto image = read_exr(folder / "scene.exr");
    double largest = 0;
    for (std::size_t i = 0; i < image.channels.at("G").values.size(); ++i) {
        double sum = 0;
        for (const auto& [name, channel] : image.channels)
            if (name.ends_with(".G") && !name.starts_with("variance") && !name.starts_with("albedo")) sum += channel.values[i];
        EXPECT_NEAR(sum, image.channels.at("G").values[i], 14 * 0x1p-24 * sum) << i;  // one float rounding per layer and one of the beauty
        largest = std::max(largest, sum);
    }
    EXPECT_GT(largest, 0);
}

TEST_F(Program, EqualRendersAreByteEqualWithoutTimestamps)
{
    const std::vector<std::string> render{"render", "scene.xml", "--method", "path", "--passes", "2", "--no-timestamps", "-o"};
    auto a = render, b = render, c = render, d = render;
    a.insert(a.end(), {"a.exr", "--threads", "1"}), b.insert(b.end(), {"b.exr", "--threads", "2"});
    c.insert(c.end(), {"c.exr", "--seed", "2"});
    for (const auto& arguments : {a, b, c}) ASSERT_EQ(run(arguments).exit_code, 0);
    d.erase(std::ranges::find(d, "--no-timestamps")), d.emplace_back("d.exr");
    ASSERT_EQ(run(d, {.environment = {{"SOURCE_DATE_EPOCH", "0"}}}).exit_code, 0);
    EXPECT_EQ(file_bytes(folder / "a.exr"), file_bytes(folder / "b.exr"));
    EXPECT_EQ(file_bytes(folder / "a.exr"), file_bytes(folder / "d.exr"));
    EXPECT_NE(file_bytes(folder / "a.exr"), file_bytes(folder / "c.exr"));
}

TEST_F(Program, CropIsAWindowOfTheResizedFilm)
{
    const auto result =
        run({"render", "scene.xml", "--method", "path", "--passes", "1", "--resolution", "32x24", "--crop", "5,6,7,8", "--half"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto image = read_exr(folder / "scene.exr");
    EXPECT_EQ(image.x, 5);
    EXPECT_EQ(image.y, 6);
    EXPECT_EQ(image.width, 7);
    EXPECT_EQ(image.height, 8);
    EXPECT_EQ(image.display_width, 32);
    EXPECT_TRUE(image.channels.at("R").half);
    EXPECT_FALSE(image.channels.at("variance.R").half);
}

TEST_F(Program, KeepsOnlyTheLayersAskedFor)
{
    ASSERT_EQ(run({"render", "scene.xml", "--method", "path", "--passes", "1", "--layer", "single", "--layer", "media_to_media"}).exit_code,
              0);
    const auto image = read_exr(folder / "scene.exr");
    EXPECT_TRUE(image.channels.contains("single.R"));
    EXPECT_TRUE(image.channels.contains("media_to_media.R"));
    EXPECT_FALSE(image.channels.contains("emitted.R"));
}

TEST_F(Program, DefinitionsReachTheScene)
{
    ASSERT_EQ(run({"render", "scene.xml", "--method", "path", "--passes", "1", "-D", "density=0.01", "-o", "thin.exr"}).exit_code, 0);
    ASSERT_EQ(run({"render", "scene.xml", "--method", "path", "--passes", "1", "-o", "thick.exr"}).exit_code, 0);
    EXPECT_NE(read_exr(folder / "thin.exr").channels.at("R").values, read_exr(folder / "thick.exr").channels.at("R").values);
}

TEST_F(Program, PlainProgressHasNoCarriageReturnAndNoColour)
{
    for (const auto* style : {"auto", "plain"}) {  // standard error is no terminal here
        const auto result = run({"render", "scene.xml", "--method", "path", "--passes", "4", "--progress", style});
        ASSERT_EQ(result.exit_code, 0);
        EXPECT_THAT(result.err, HasSubstr("100 %  pass 4/4"));
        EXPECT_THAT(result.err, HasSubstr("error"));
        EXPECT_EQ(result.err.find('\r'), std::string::npos);
        EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
    }
}

TEST_F(Program, JsonProgressGoesToStandardOutput)
{
    const auto result = run({"render", "scene.xml", "--method", "path", "--passes", "3", "--progress", "json"});
    ASSERT_EQ(result.exit_code, 0);
    std::istringstream lines(result.out);
    std::vector<nlohmann::json> events;
    for (std::string line; std::getline(lines, line);) events.push_back(nlohmann::json::parse(line));
    ASSERT_EQ(events.size(), 4u);
    EXPECT_EQ(events[1].at("passes_done"), 2);
    EXPECT_EQ(events[3].at("event"), "finished");
    EXPECT_EQ(events[3].at("outputs")[0], "scene.exr");
}

TEST_F(Program, TimeStopsTheRender)
{
    const auto result = run({"render", "scene.xml", "--method", "path", "--time", "1s"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(nlohmann::json::parse(file_bytes(folder / "scene.json")).at("stopped_by"), "time");
}

TEST_F(Program, TargetErrorStopsTheRender)
{
    const auto result = run({"render", "scene.xml", "--method", "path", "--target-error", "60%", "--passes", "4000"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto report = nlohmann::json::parse(file_bytes(folder / "scene.json"));
    EXPECT_EQ(report.at("stopped_by"), "target error");
    EXPECT_GE(report.at("passes"), 8) << "luck does not stop it before";
    EXPECT_LE(report.at("error_below_95"), .6);
    EXPECT_LE(report.at("error"), report.at("error_below_95"));
    EXPECT_GT(report.at("seconds_to_error").at("0.001"), report.at("seconds_to_error").at("0.01"));
}

TEST_F(Program, TargetErrorThatTheBudgetDoesNotReachExitsWith7)
{
    const auto result = run({"render", "scene.xml", "--method", "path", "--target-error", ".0001%", "--passes", "9"});
    EXPECT_EQ(result.exit_code, 7) << result.err;
    EXPECT_EQ(nlohmann::json::parse(file_bytes(folder / "scene.json")).at("stopped_by"), "passes");
    EXPECT_TRUE(files().size() > 1) << "the image is written all the same";
}

TEST_F(Program, UsageErrorsExitWith2AndHelp)
{
    const std::vector<std::pair<std::vector<std::string>, const char*>> cases{
        {{"render", "scene.xml", "--pases", "3"}, "did you mean \"--passes\"?"},
        {{"rendr", "scene.xml"}, "did you mean \"render\"?"},
        {{"scene.xml"}, "did you mean `tyndall render scene.xml`?"},
        {{}, "subcommand"},
        {{"render"}, "scene"},
        {{"render", "scene.xml", "--layer", "singel"}, "did you mean \"single\"?"},
        {{"render", "scene.xml", "--passes", "0"}, "--passes \"0\": must be a whole number"},
        {{"render", "scene.xml", "--time", "soon"}, "--time \"soon\""},
        {{"render", "scene.xml", "--lanes", "5"}, "1, 4, 8, 16"},
        {{"render", "scene.xml", "--layer", "surface_indirect=vrl"}, "virtual ray lights do not carry surface_indirect; --method photons, vpl"},
        {{"render", "scene.xml", "--method", "teapots"}, "must be one of vrl, "},
        {{"render", "scene.xml", "--method", "vpl-clamped", "--clamp", "0"}, "--clamp \"0\": must be a number"},
        {{"render", "scene.xml", "--method", "vpl-clamped", "--clamp", "nan"}, "--clamp \"nan\": must be a number"},
        {{"render", "scene.xml", "--beam-radius", "-1"}, "--beam-radius \"-1\": must be a share"},
        {{"render", "scene.xml", "--method", "photons", "--beam-radius", "0"}, "the beam radius must be above 0"},
        {{"render", "scene.xml", "--method", "vpl-clamped", "--clamp", "-1"}, "--clamp \"-1\": must be a number"},
        {{"render", "scene.xml", "--exposure", "nan"}, "--exposure \"nan\""},
        {{"render", "scene.xml", "-o", "a.png"}, "must end in .exr"},
        {{"render", "scene.xml", "--crop", "10,0,7,5"}, "must lie in the film of 16 x 12"},
        {{"render", "scene.xml", "--long", "--short"}, "--short"},
    };
    for (const auto& [arguments, text] : cases) {
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 2) << text << "\n" << result.err;
        EXPECT_THAT(result.err, HasSubstr(text));
        EXPECT_EQ(result.out, "");
    }
    EXPECT_THAT(files(), ElementsAre("scene.xml"));
}

TEST_F(Program, InvalidScenesExitWith3AndAPlace)
{
    std::string bad = fog_scene;
    write_file("bad.xml", bad.replace(bad.find("sigma_t"), 7, "sigma_q"));  // on line 5
    for (const auto* name : {"bad.xml", "missing.xml", "."}) {
        const auto result = run({"render", name});
        EXPECT_EQ(result.exit_code, 3) << name << "\n" << result.err;
    }
    const auto result = run({"render", "bad.xml"});
    EXPECT_THAT(result.err, testing::ContainsRegex("bad\\.xml:5:[0-9]+"));
    EXPECT_THAT(result.err, HasSubstr("sigma_t"));
    EXPECT_THAT(files(), ElementsAre("bad.xml", "scene.xml"));
}

TEST_F(Program, NoDeviceExitsWith4AndLeavesNothing)
{
    const ProcessSetup no_platform{.environment = {{"OCL_ICD_VENDORS", "/nonexistent"}}};
    for (const auto& arguments : {std::vector<std::string>{"render", "scene.xml"}, {"devices"}, {"devices", "--json"}}) {
        const auto result = run(arguments, no_platform);
        EXPECT_EQ(result.exit_code, 4) << result.err;
        EXPECT_THAT(result.err, HasSubstr("OCL_ICD_VENDORS"));
    }
    EXPECT_THAT(files(), ElementsAre("scene.xml"));
}

TEST_F(Program, PathTracingNeedsNoDevice)
{
    const auto result =
        run({"render", "scene.xml", "--method", "path", "--passes", "1"}, {.environment = {{"OCL_ICD_VENDORS", "/nonexistent"}}});
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST_F(Program, OutputThatCannotBeWrittenExitsWith6BeforeRendering)
{
    for (const auto* output : {"no/such/folder/a.exr", "/proc/a.exr"}) {
        const auto result = run({"render", "scene.xml", "--method", "path", "-o", output});
        EXPECT_EQ(result.exit_code, 6) << output << "\n" << result.err;
        EXPECT_THAT(result.err, HasSubstr(output));
        EXPECT_THAT(result.err, Not(HasSubstr("pass 1")));
    }
    ASSERT_EQ(::mkfifo((folder / "pipe.exr").c_str(), 0600), 0);
    EXPECT_EQ(run({"render", "scene.xml", "--method", "path", "-o", "pipe.exr"}).exit_code, 6);
}

TEST_F(Program, AFullDiskExitsWith6AndKeepsTheOldImage)
{
    write_file("scene.exr", "old");
    const auto result = run({"render", "scene.xml", "--method", "path", "--passes", "1", "--progress", "none"}, {.file_size_limit = 2000});
    EXPECT_EQ(result.exit_code, 6) << result.err << " signal " << result.signal;
    EXPECT_THAT(result.err, HasSubstr("scene.exr"));
    EXPECT_EQ(file_bytes(folder / "scene.exr"), "old");
    EXPECT_THAT(files(), ElementsAre("scene.exr", "scene.xml"));
}

TEST_F(Program, InfoPrintsTheSceneAsTextAndAsJson)
{
    const auto text = run({"info", "scene.xml"});
    EXPECT_EQ(text.exit_code, 0);
    EXPECT_THAT(text.out, HasSubstr("fog"));
    const auto scene = nlohmann::json::parse(run({"info", "scene.xml", "--json", "-D", "density=2"}).out);
    EXPECT_EQ(scene.at("schema"), "tyndall-scene/1");
    EXPECT_EQ(scene.at("film").at("width"), 16);
    EXPECT_EQ(scene.at("max_depth"), 4);
    EXPECT_EQ(scene.at("media")[0].at("name"), "fog");
    EXPECT_NEAR(scene.at("media")[0].at("sigma_t")[0].get<double>(), 2, 1e-12);
    EXPECT_EQ(scene.at("camera_medium"), "fog");
    EXPECT_EQ(scene.at("emitters")[0].at("type"), "point");
}

TEST_F(Program, DevicesListsWhatThereIs)
{
    const auto json = run({"devices", "--json"});
    const auto list = nlohmann::json::parse(json.out).at("devices");
    EXPECT_EQ(json.exit_code, list.empty() ? 4 : 0);
    if (list.empty()) GTEST_SKIP() << "this machine has no OpenCL device";
    EXPECT_THAT(run({"devices"}).out, HasSubstr(list[0].at("platform").get<std::string>()));
}

}  // namespace
}  // namespace tyndall::test
