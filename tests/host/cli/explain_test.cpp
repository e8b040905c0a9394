/// `tyndall explain`, --features and `tyndall devices --prebuild`, as a user runs them.
#include <nlohmann/json.hpp>

#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

TEST_F(Program, ExplainsAsJsonOnStandardOutput)
{
    const auto result = run({"explain", "scene.xml", "--json", "--lights", "8", "--calibrate", "0.2"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json.at("schema"), "tyndall-explain/1");
    EXPECT_EQ(json.at("width"), 16);
    EXPECT_EQ(json.at("lights"), 8);
    EXPECT_EQ(json.at("passes"), 16);
    EXPECT_GT(json.at("calibration").at("pass_seconds"), 0);
    EXPECT_EQ(json.at("effects").at(7).at("cause"), "setting: max_depth = 4");
    EXPECT_EQ(files(), std::vector<std::string>{"scene.xml"}) << "explain writes no files";
}

TEST_F(Program, ExplainsForPeopleAndMeasuresNothingIfToldSo)
{
    const auto result = run({"explain", "scene.xml", "--calibrate", "0"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("scene.xml:4:3: medium \"fog\": albedo above 0"));
    EXPECT_THAT(result.out, HasSubstr("time: not measured: turned off by --calibrate 0"));
}

TEST_F(Program, ExplainsWithoutADevice)
{
    const auto result = run({"explain", "scene.xml", "--json"}, {.environment = {{"OCL_ICD_VENDORS", "/nonexistent"}, {"OCL_ICD_FILENAMES", "/nonexistent"}}});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(Json::parse(result.out).at("calibration").is_null());
    EXPECT_THAT(std::string(Json::parse(result.out).at("why_no_calibration")), HasSubstr("no OpenCL device"));
    EXPECT_EQ(run({"explain", "scene.xml", "--device", "no such device"}).exit_code, 4);
}

TEST_F(Program, RefusesFeaturesThatTheSceneNeedsAndLacks)
{
    const auto result = run({"render", "scene.xml", "-p", "1", "--features", "COLOURED"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("lacks DEPTH_LIMIT, which media_to_media needs: setting: max_depth = 4"));
    EXPECT_EQ(files(), std::vector<std::string>{"scene.xml"});
}

TEST_F(Program, BuildsTheFeaturesThatItIsToldTo)
{
    ASSERT_EQ(run({"render", "scene.xml", "-p", "1", "--lights", "8", "--progress", "none", "--features", "DEPTH_LIMIT,ANISOTROPIC"}).exit_code, 0);
    std::ifstream file(folder / "scene.json");
    EXPECT_THAT(std::string(Json::parse(file).at("device").at("build_options")), HasSubstr("-DFEATURES=129u"));
}

TEST_F(Program, NamesTheNearestFeature)
{
    const auto result = run({"render", "scene.xml", "--features", "COLORED"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_THAT(result.err, HasSubstr("did you mean \"COLOURED\"?"));
}

}  // namespace
}  // namespace tyndall::test
