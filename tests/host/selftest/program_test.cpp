// `tyndall selftest`, and the check before the first render, as a user meets them: with the program, and with one to which every device is broken.
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "../cli/program_fixture.hpp"

namespace tyndall::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class SelftestProgram : public Program {
protected:
    /// A cache of its own for stamps; PoCL's stays where it is, because a cold one takes seconds.
    ProcessSetup own_cache() const
    {
        ProcessSetup setup{.folder = folder.path(), .environment = {{"XDG_CACHE_HOME", (folder / "cache").string()}}};
        const char *set = std::getenv("POCL_CACHE_DIR"), *xdg = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
        const std::string base = xdg ? xdg : std::string(home ? home : "/tmp") + "/.cache";
        setup.environment.emplace_back("POCL_CACHE_DIR", set ? set : base + "/pocl/kcache");
        return setup;
    }
    ProcessResult with(const char* program, std::vector<std::string> arguments) const
    {
        arguments.insert(arguments.begin(), program);
        return run_process(arguments, own_cache());
    }
    json report() const { return json::parse(file_bytes(folder / "scene.json")); }
    const std::vector<std::string> render{"render", "scene.xml", "--passes", "1", "--lights", "16", "--progress", "none"};
};

TEST_F(SelftestProgram, PassesAndPrintsATable)
{
    const ProcessResult result = with(TYNDALL_PROGRAM, {"selftest", "--all-lanes"});
    EXPECT_EQ(result.exit_code, 0) << result.out;
    for (const char* text : {"Row01NearlyParallelLightKeepsItsPotential", "host float", "host double", "device, 1 lane", "device, 16 lanes", "are within their bounds in 6 places"})
        EXPECT_THAT(result.out, HasSubstr(text));
    EXPECT_EQ(result.err, "");
}

TEST_F(SelftestProgram, PrintsJsonAndJunit)
{
    const json result = json::parse(with(TYNDALL_PROGRAM, {"selftest", "--json", "--only", "row01", "--only", "row39"}).out);
    EXPECT_EQ(result["passed"], true);
    EXPECT_EQ(result["cases"].size(), 6u);
    for (const json& one : result["cases"]) EXPECT_GT(one["worst_ulp"], 0);
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(with(TYNDALL_PROGRAM, {"selftest", "--junit", "--only", "row01"}).out.c_str()));
    EXPECT_EQ(document.child("testsuites").attribute("tests").as_int(), 3);
}

TEST_F(SelftestProgram, RefusesWhatMakesNoSenseAndNeedsADevice)
{
    EXPECT_EQ(with(TYNDALL_PROGRAM, {"selftest", "--only", "row77"}).exit_code, 2);
    EXPECT_EQ(with(TYNDALL_PROGRAM, {"selftest", "--json", "--junit"}).exit_code, 2);
    EXPECT_EQ(with(TYNDALL_PROGRAM, {"selftest", "--device", "no such device"}).exit_code, 4);
    EXPECT_EQ(with(TYNDALL_PROGRAM, {"selftest", "--bundle", "scene.xml"}).exit_code, 6);
}

TEST_F(SelftestProgram, WritesNoBundleWhenNothingFails)
{
    const ProcessResult result = with(TYNDALL_PROGRAM, {"selftest", "--only", "row01", "--bundle", "bundle"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("no bundle was written"));
    EXPECT_FALSE(std::filesystem::exists(folder / "bundle"));
}

TEST_F(SelftestProgram, AFailureEndsWithEightAndABundle)
{
    const ProcessResult result = with(TYNDALL_PLANTED, {"selftest", "--bundle", "bundle"});
    EXPECT_EQ(result.exit_code, 8);
    EXPECT_THAT(result.out, HasSubstr("OUTSIDE Row07VeryShortLight (host float)")) << "the table is wrong, so the host fails as well";
    EXPECT_THAT(result.out, HasSubstr("OUTSIDE Row07VeryShortLight (device"));
    EXPECT_THAT(file_bytes(folder / "bundle/README.md"), HasSubstr("Row07VeryShortLight-rod"));
    EXPECT_EQ(with(TYNDALL_PLANTED, {"selftest", "--only", "row14"}).exit_code, 0);
}

TEST_F(SelftestProgram, RunsBeforeTheFirstRenderOnly)
{
    ASSERT_EQ(with(TYNDALL_PROGRAM, render).exit_code, 0);
    EXPECT_EQ(report()["selftest"]["outcome"], "passed");
    EXPECT_GT(report()["selftest"]["outputs"], 3000);
    const std::string stamp = report()["selftest"]["remembered_in"];
    EXPECT_THAT(stamp, HasSubstr((folder / "cache/tyndall").string()));
    ASSERT_EQ(with(TYNDALL_PROGRAM, render).exit_code, 0);
    EXPECT_EQ(report()["selftest"]["outcome"], "passed before");
    EXPECT_EQ(report()["selftest"]["remembered_in"], stamp);
    auto path = render;
    path.insert(path.end(), {"--method", "path"});
    ASSERT_EQ(with(TYNDALL_PROGRAM, path).exit_code, 0);
    EXPECT_EQ(report()["selftest"], nullptr) << "no device was used";
}

TEST_F(SelftestProgram, AFailureStopsTheRenderUnlessAskedNotTo)
{
    const ProcessResult stopped = with(TYNDALL_PLANTED, render);
    EXPECT_EQ(stopped.exit_code, 5);
    EXPECT_THAT(stopped.err, HasSubstr("Row07VeryShortLight"));
    EXPECT_THAT(stopped.err, HasSubstr("tyndall selftest --bundle"));
    EXPECT_FALSE(std::filesystem::exists(folder / "scene.exr"));
    auto anyway = render;
    anyway.push_back("--no-selftest");
    EXPECT_EQ(with(TYNDALL_PLANTED, anyway).exit_code, 0);
    EXPECT_EQ(report()["selftest"]["outcome"], "skipped");
}

TEST_F(SelftestProgram, AnUnusableCacheIsSaidOnceAndFailsNothing)
{
    ProcessSetup setup = own_cache();
    setup.environment.front().second = (folder / "scene.xml").string();
    std::vector<std::string> arguments = render;
    arguments.insert(arguments.begin(), TYNDALL_PROGRAM);
    arguments.back() = "plain";
    const ProcessResult result = run_process(arguments, setup);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::size_t said = result.err.find("cannot be remembered");
    EXPECT_NE(said, std::string::npos) << result.err;
    EXPECT_EQ(result.err.find("cannot be remembered", said + 1), std::string::npos);
}

}  // namespace
}  // namespace tyndall::test
