/// The program in a locale that writes decimal commas: what it reads and writes stays the same, byte for byte.
#include <nlohmann/json.hpp>

#include "../cli/program_fixture.hpp"
#include "support/comma_locale.hpp"

namespace tyndall::test {
namespace {

class CommaLocaleProgram : public Program {
protected:
    static ProcessSetup german()
    {
        return {.environment = {{"LC_ALL", CommaLocaleFiles::name()}, {"LOCPATH", comma_locale_files().folder()}, {"LD_PRELOAD", TYNDALL_COMMA_LOCALE_LIBRARY}, {"ASAN_OPTIONS", "verify_asan_link_order=0"}}};
    }

    /// Runs the same here and there; expects success, the same words on standard output, and the same bytes in these files. Returns the words.
    std::string expect_same(const std::vector<std::string>& arguments, const std::vector<std::string>& written = {})
    {
        const ProcessResult plain = run(arguments);
        EXPECT_EQ(plain.exit_code, 0) << arguments[0] << '\n' << plain.err;
        std::vector<std::string> bytes;
        for (const std::string& file : written) bytes.push_back(file_bytes(folder / file));
        const ProcessResult comma = run(arguments, german());
        EXPECT_EQ(comma.exit_code, 0) << arguments[0] << ", signal " << comma.signal << '\n' << comma.err;
        EXPECT_EQ(comma.out, plain.out) << arguments[0];
        for (std::size_t i = 0; i < written.size(); ++i) {
            EXPECT_FALSE(bytes[i].empty()) << written[i];
            EXPECT_TRUE(file_bytes(folder / written[i]) == bytes[i]) << arguments[0] << ": " << written[i];
        }
        return comma.out;
    }

    static std::vector<std::string> rendering(std::vector<std::string> options)
    {
        options.insert(options.begin(), {"render", "scene.xml", "--lights", "64", "--no-selftest", "--no-timestamps", "--progress", "none"});
        return options;
    }
};

// Density and extinction from the scene, -D, exposure, shares and durations from options; image, picture, kernels' options.
TEST_F(CommaLocaleProgram, RendersTheSameBytes)
{
    expect_same(rendering({"--method", "path", "-p", "1", "--exposure", "1.5", "-D", "density=0.75"}), {"scene.exr", "scene.png"});
    expect_same(rendering({"--method", "vpl-clamped", "--clamp", "12.5", "-p", "2", "--time", "1.5h", "-o", "clamped.exr"}), {"clamped.exr", "clamped.png"});
}

TEST_F(CommaLocaleProgram, ReportsAreJsonWithTheSameNumbers)
{
    std::vector<nlohmann::json> reports;
    for (const ProcessSetup& setup : {here(), german()}) {
        ASSERT_EQ(run(rendering({"--method", "path", "-p", "2"}), setup).exit_code, 0);
        reports.push_back(nlohmann::json::parse(file_bytes(folder / "scene.json")));
    }
    EXPECT_GT(reports[0]["error"].get<double>(), 0);
    EXPECT_EQ(reports[1]["error"], reports[0]["error"]);
    EXPECT_EQ(reports[1]["layers"], reports[0]["layers"]);
}

TEST_F(CommaLocaleProgram, ShardsOfBothMergeToTheSameImage)
{
    ASSERT_EQ(run(rendering({"--method", "path", "-p", "4", "--block-passes", "2"})).exit_code, 0);
    const std::string whole = file_bytes(folder / "scene.exr");
    ASSERT_EQ(run(rendering({"--method", "path", "-p", "4", "--block-passes", "2", "--shard", "1/2", "-o", "1.shard"})).exit_code, 0);
    ASSERT_EQ(run(rendering({"--method", "path", "-p", "4", "--block-passes", "2", "--shard", "2/2", "-o", "2.shard"}), german()).exit_code, 0);
    expect_same({"merge", "1.shard", "2.shard", "-o", "merged.exr", "--no-timestamps"}, {"merged.exr", "merged.png"});
    EXPECT_TRUE(file_bytes(folder / "merged.exr") == whole);
}

TEST_F(CommaLocaleProgram, SaysTheSame)
{
    write_file("site.conf", "target-error = 1.5%\nexposure = 0.5\n");
    expect_same({"info", "scene.xml"});
    expect_same({"render", "scene.xml", "--config", "site.conf", "--print-config"});
    ASSERT_EQ(run(rendering({"--method", "path", "-p", "1"})).exit_code, 0);
    ASSERT_EQ(run(rendering({"--method", "path", "-p", "1", "--seed", "2", "-o", "other.exr"})).exit_code, 0);
    nlohmann::json compared = nlohmann::json::parse(expect_same({"compare", "scene.exr", "other.exr", "--json"}));
    EXPECT_FALSE(compared.empty());
    const ProcessResult checked = run({"selftest", "--only", "row04", "--json"}, german());
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_TRUE(nlohmann::json::parse(checked.out)["passed"].get<bool>());
    EXPECT_EQ(run(rendering({"--exposure", "1,5"}), german()).exit_code, 2) << "a comma stays no number";
}

TEST_F(CommaLocaleProgram, CheckpointsGoOnToTheSameBytes)
{
    ASSERT_EQ(run(rendering({"--method", "path", "-p", "6"})).exit_code, 0);
    const std::string whole = file_bytes(folder / "scene.exr");
    ASSERT_EQ(run(rendering({"--method", "path", "-p", "3", "--checkpoint", "0.001s", "-o", "part.exr"}), german()).exit_code, 0);
    ASSERT_EQ(run(rendering({"--method", "path", "-p", "6", "--checkpoint", "0.001s", "--resume", "-o", "part.exr"}), german()).exit_code, 0);
    EXPECT_TRUE(file_bytes(folder / "part.exr") == whole);
}

TEST_F(CommaLocaleProgram, MeasuresInNumbersThatProgramsRead)
{
    const ProcessResult measured = run({"bench", "--lanes", "4", "--time", "0.2", "--json"}, german());
    ASSERT_EQ(measured.exit_code, 0) << measured.err;
    EXPECT_FALSE(nlohmann::json::parse(measured.out).empty());
}

}  // namespace
}  // namespace tyndall::test
