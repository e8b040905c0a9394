// `tyndall bench` and `tyndall devices --calibrate` as a user meets them.
#include <nlohmann/json.hpp>

#include "../cli/program_fixture.hpp"

namespace tyndall::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class BenchProgram : public Program {
protected:
    ProcessSetup own_config() const { return {.environment = {{"XDG_CONFIG_HOME", (folder / "config").string()}}}; }
    std::filesystem::path kept() const { return std::filesystem::directory_iterator(folder / "config/tyndall")->path(); }
    json report() const { return json::parse(file_bytes(folder / "scene.json")); }
    json first_device() { return json::parse(run({"devices", "--json"}, own_config()).out)["devices"][0]; }
    const std::vector<std::string> render{"render", "scene.xml", "--passes", "1", "--lights", "16", "--progress", "plain"};

    /// As if the device had been calibrated to another width than the rule's.
    int keep_another_width()
    {
        EXPECT_EQ(run({"devices", "--calibrate"}, own_config()).exit_code, 0);
        json choice = json::parse(file_bytes(kept()));
        choice["lanes"] = choice["by_rule"] == 4 ? 8 : 4;
        std::ofstream(kept(), std::ios::binary) << choice.dump();
        return choice["lanes"];
    }
};

TEST_F(BenchProgram, PrintsATableAndJson)
{
    const ProcessResult table = run({"bench", "--lanes", "4", "--time", "1"});
    EXPECT_EQ(table.exit_code, 0) << table.err;
    for (const char* text : {"isotropic", "henyey_greenstein_coloured", "product", "table", "surface_points", "density_grid", "rounds taken in turns", "speed-up over the scalar kernel"})
        EXPECT_THAT(table.out, HasSubstr(text));
    const json out = json::parse(run({"bench", "--lanes", "4,4", "--time", "1", "--json", "--cores", "all"}).out);
    EXPECT_EQ(out["schema"], "tyndall-bench/1");
    EXPECT_EQ(out["cores"], "all");
    EXPECT_EQ(out["kernels"].size(), 7u);
    EXPECT_EQ(out["kernels"][0]["lanes"].size(), 1u);
    EXPECT_TRUE(out.contains("speedup_over_scalar"));
}

TEST_F(BenchProgram, RefusesWhatMakesNoSenseAndNeedsADevice)
{
    for (const char* lanes : {"3", "4,5", "", "16x"}) EXPECT_EQ(run({"bench", "--lanes", lanes}).exit_code, 2) << lanes;
    EXPECT_EQ(run({"bench", "--cores", "two"}).exit_code, 2);
    EXPECT_EQ(run({"bench", "--time", "0"}).exit_code, 2);
    EXPECT_EQ(run({"bench", "--device", "no such device"}).exit_code, 4);
    EXPECT_EQ(run({"devices", "--calibrate", "--device", "no such device"}).exit_code, 4);
    EXPECT_EQ(run({"devices", "--calibrate", "--prebuild"}).exit_code, 2);
    write_file("file", "x");
    EXPECT_EQ(run({"devices", "--calibrate"}, {.environment = {{"XDG_CONFIG_HOME", (folder / "file").string()}}}).exit_code, 6);
}

TEST_F(BenchProgram, CalibrationIsKeptPrintedAndTakenByRenders)
{
    const ProcessResult result = run({"devices", "--calibrate"}, own_config());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr(kept().string()));
    for (const char* text : {" 1 lanes", " 4 lanes", " 8 lanes", "16 lanes", "speed beside"}) EXPECT_THAT(result.out, HasSubstr(text));
    const json device = first_device();
    EXPECT_EQ(device["calibrated_lanes"], json::parse(file_bytes(kept()))["lanes"]);
    ASSERT_EQ(run(render, own_config()).exit_code, 0);
    EXPECT_EQ(report()["device"]["lanes"], device["calibrated_lanes"]);
    EXPECT_EQ(report()["device"]["lanes_from"], "calibration");
}

TEST_F(BenchProgram, ReportAndExplainSayWhereLanesComeFrom)
{
    const int lanes = keep_another_width();
    ASSERT_EQ(run(render, own_config()).exit_code, 0);
    EXPECT_EQ(report()["device"]["lanes"], lanes);
    EXPECT_EQ(report()["device"]["lanes_from"], "calibration");
    const json explained = json::parse(run({"explain", "scene.xml", "--json", "--calibrate", "0"}, own_config()).out);
    EXPECT_EQ(explained["lanes"], lanes);
    EXPECT_EQ(explained["lanes_from"], "calibration");
    auto asked = render;
    asked.insert(asked.end(), {"--lanes", "1"});
    ASSERT_EQ(run(asked, own_config()).exit_code, 0);
    EXPECT_EQ(report()["device"]["lanes"], 1);
    EXPECT_EQ(report()["device"]["lanes_from"], "request");
    ASSERT_EQ(run(render).exit_code, 0);
    EXPECT_EQ(report()["device"]["lanes_from"], "rule") << "tests see no calibration but their own";
    EXPECT_THAT(run({"explain", "scene.xml", "--calibrate", "0"}).out, HasSubstr("lanes by rule"));
}

TEST_F(BenchProgram, ACorruptCalibrationIsSaidAndIgnored)
{
    keep_another_width();
    std::ofstream(kept(), std::ios::binary) << "{\"schema\": \"tyndall-lanes/1\"";
    const ProcessResult result = run(render, own_config());
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("run `tyndall devices --calibrate` again"));
    EXPECT_EQ(report()["device"]["lanes_from"], "rule");
    EXPECT_THAT(report()["warnings"].dump(), HasSubstr("lanes go by the rule"));
    EXPECT_EQ(first_device()["calibrated_lanes"], nullptr);
}

}  // namespace
}  // namespace tyndall::test
