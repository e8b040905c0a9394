// What a driver developer gets: everything needed to see the failure again, without Tyndall.
#include "selftest/bundle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "planted_kernel.hpp"
#include "selftest/selftest_output.hpp"
#include "support/child_process.hpp"
#include "support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Bundle : public testing::Test {
protected:
    /// Row 1 fails in its sets and row 3 in its sets and its means.
    void write(const std::string& kernel)
    {
        result = run_selftest({.only = {"row01", "row03"}, .lanes = {4}, .host = false, .source = kernel});
        write_bundle(folder.path(), result, to_json(result, "0"));
    }
    int replay(const std::string& launch) { return run_process({(folder / "replay").string(), launch}, {.folder = folder.path()}).exit_code; }
    void compile()
    {
        const ProcessResult compiled = run_process({"/usr/bin/cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "replay.c", "-o", "replay", "-lOpenCL"}, {.folder = folder.path()});
        ASSERT_EQ(compiled.exit_code, 0) << compiled.err;
    }
    TemporaryFolder folder;
    SelftestResult result;
};

std::vector<float> floats(const fs::path& file)
{
    const std::string bytes = file_bytes(file);
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

TEST_F(Bundle, ReplaysTheFailureOfASetAndNoLongerWithTheRightKernel)
{
    write(wrong_potentials());
    EXPECT_FALSE(result.passed());
    compile();
    const std::string launch = "lanes4/Row01NearlyParallelLightKeepsItsPotential-rod";
    EXPECT_EQ(replay(launch), 1);
    std::ofstream(folder / "lanes4/kernel.cl", std::ios::binary) << flattened_kernel("kernels/selftest/evaluate_cases.cl", {});
    EXPECT_EQ(replay(launch), 0);
}

TEST_F(Bundle, ReplaysTheFailureOfAMean)
{
    write(wrong_weights());
    EXPECT_FALSE(fs::exists(folder / "lanes4/Row01NearlyParallelLightKeepsItsPotential-rod")) << "row 1 holds no weight";
    compile();
    for (const char* launch : {"lanes4/Row03ExactlyParallelLightHasTheClosedForm-pair-mean", "lanes4/Row03ExactlyParallelLightHasTheClosedForm-pair-mean2"}) EXPECT_EQ(replay(launch), 1);
    std::ofstream(folder / "lanes4/kernel.cl", std::ios::binary) << flattened_kernel("kernels/selftest/evaluate_cases.cl", {});
    EXPECT_EQ(replay("lanes4/Row03ExactlyParallelLightHasTheClosedForm-pair-mean"), 0);
}

TEST_F(Bundle, HoldsBuffersAsTheDescriptionSays)
{
    write(wrong_potentials());
    const fs::path launch = folder / "lanes4/Row01NearlyParallelLightKeepsItsPotential-rod";
    const auto json = nlohmann::json::parse(file_bytes(launch / "launch.json"));
    const std::size_t count = json["count"], sets = json["sets"];
    EXPECT_EQ(count % 4, 0u);
    EXPECT_EQ(json["names"].size(), sets);
    for (const auto& buffer : json["buffers"]) EXPECT_EQ(fs::file_size(launch / buffer["file"].get<std::string>()), 4 * count * (buffer["file"] == "in.f32" ? 14 : 4));
    const auto in = floats(launch / "in.f32"), out = floats(launch / "out.f32"), low = floats(launch / "low.f32"), high = floats(launch / "high.f32");
    const FailedLaunch& failed = result.failed.front();
    std::size_t outside = 0;
    for (std::size_t i = 0; i < sets; ++i) {
        EXPECT_EQ(in[9 * count + i], failed.launch.in[i][9]);
        EXPECT_EQ(out[count + i], failed.launch.out[i][1]);
        outside += !(low[i] <= out[i] && out[i] <= high[i]);
    }
    EXPECT_GT(outside, 0u);
    EXPECT_THAT(file_bytes(folder / "README.md"), HasSubstr("./replay lanes4/Row01"));
    EXPECT_THAT(file_bytes(folder / "lanes4/build_options.txt"), HasSubstr("-DLANES=4"));
    EXPECT_THAT(file_bytes(folder / "lanes4/kernel.cl"), HasSubstr("1.00001"));
    EXPECT_EQ(nlohmann::json::parse(file_bytes(folder / "selftest.json"))["passed"], false);
}

TEST_F(Bundle, NeedsAnEmptyFolder)
{
    EXPECT_NO_THROW(check_bundle_folder(folder / "new"));
    std::ofstream(folder / "taken") << "x";
    EXPECT_THROW(check_bundle_folder(folder.path()), IoError);
    EXPECT_THROW(check_bundle_folder(folder / "taken" / "below"), IoError);
}

}  // namespace
}  // namespace tyndall::test
