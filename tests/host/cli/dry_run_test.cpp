/// `render --dry-run`: everything that can be wrong before the first pass is found, and nothing is written.
#include <nlohmann/json.hpp>

#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const ProcessSetup no_platform{.environment = {{"OCL_ICD_VENDORS", "/nonexistent"}}};

TEST_F(Program, ADryRunSaysWhatWouldBeDoneAndWritesNothing)
{
    const ProcessResult text = run({"render", "scene.xml", "--dry-run", "--method", "path"}, no_platform);
    EXPECT_EQ(text.exit_code, 0) << text.err;
    for (const char* part : {"16 x 12 pixels, method path", "effects found", "layers", "kernels to be built: none", "memory, estimated", "this is a dry run"}) EXPECT_THAT(text.out, HasSubstr(part));
    EXPECT_THAT(files(), ElementsAre("scene.xml"));
}

TEST_F(Program, ADryRunNamesLightsProgramsAndDevice)
{
    const ProcessResult ran = run({"render", "scene.xml", "--dry-run", "--progress", "json", "--lights", "300", "--lanes", "4"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(std::ranges::count(ran.out, '\n'), 1);
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json.at("schema"), "tyndall-explain/1");
    EXPECT_EQ(json.at("lights"), 300);
    EXPECT_EQ(json.at("lanes"), 4);
    EXPECT_EQ(json.at("lanes_from"), "request");
    EXPECT_FALSE(json.at("device").get<std::string>().empty());
    EXPECT_FALSE(json.at("kernels").empty());
    EXPECT_FALSE(json.at("memory").empty());
    EXPECT_THAT(files(), ElementsAre("scene.xml"));
}

TEST_F(Program, ADryRunEndsAsTheRenderWould)
{
    write_file("bad.xml", "<scene version=\"3.0.0\"><shape type=\"sphre\"/></scene>");
    write_file("scene.exr.checkpoint", "not a checkpoint");
    const std::pair<std::vector<std::string>, int> cases[] = {
        {{"scene.xml", "--features", "none"}, 2}, {{"scene.xml", "--crop", "10,0,7,5"}, 2}, {{"bad.xml"}, 3},
        {{"scene.xml", "--resume"}, 3},           {{"scene.xml", "--device", "no such device"}, 4},
        {{"scene.xml", "-o", "no/such/folder/a.exr"}, 6},
    };
    for (auto [options, code] : cases) {
        options.insert(options.begin(), "render");
        const std::string name = options.back();
        const ProcessResult real = options.back() == "--resume" ? run(options) : ProcessResult{.exit_code = code};
        options.emplace_back("--dry-run");
        const ProcessResult dry = run(options);
        EXPECT_EQ(dry.exit_code, code) << name << '\n' << dry.err;
        EXPECT_EQ(real.exit_code, code) << name;
        EXPECT_EQ(dry.out, "") << name;
    }
    EXPECT_EQ(run({"render", "scene.xml", "--dry-run"}, no_platform).exit_code, 4);
    EXPECT_THAT(files(), ElementsAre("bad.xml", "scene.exr.checkpoint", "scene.xml"));
}

}  // namespace
}  // namespace tyndall::test
