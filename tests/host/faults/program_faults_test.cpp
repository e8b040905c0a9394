/// The program with an OpenCL that fails or lies: exit codes and messages as a user and a farm manager see them.
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../cli/program_fixture.hpp"

namespace tyndall::test {
namespace {

class FaultyProgram : public Program {
protected:
    /// Standard settings, and what goes wrong: TYNDALL_FAULTY_OPENCL, or nothing.
    ProcessResult render(const std::string& faults, std::vector<std::string> options = {}, std::vector<std::pair<std::string, std::string>> environment = {})
    {
        std::vector<std::string> arguments{"render", "scene.xml", "-o", "image.exr", "--passes", "2", "--lights", "300", "--no-selftest", "--no-timestamps"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        ProcessSetup setup = here();
        setup.environment = std::move(environment);
        if (!faults.empty()) {
            setup.environment.emplace_back("LD_PRELOAD", TYNDALL_FAULTY_OPENCL_LIBRARY);
            setup.environment.emplace_back("TYNDALL_FAULTY_OPENCL", faults);
            setup.environment.emplace_back("ASAN_OPTIONS", "verify_asan_link_order=0");
        }
        return run(arguments, setup);
    }
    std::string image() const { return file_bytes(folder / "image.exr"); }
    nlohmann::json report() const { return nlohmann::json::parse(std::ifstream(folder / "image.json")); }
};

TEST_F(FaultyProgram, ADeviceThatFailsIsExitCode5AndASentence)
{
    for (const char* faults : {"fail_at=60 failures=100000 error=-5", "fail_at=60 error=-36", "fail_at=3 error=-6"}) {
        const ProcessResult r = render(faults);
        EXPECT_EQ(r.exit_code, 5) << faults << '\n' << r.err;
        EXPECT_THAT(r.err, testing::HasSubstr("tyndall: ")) << faults;
        EXPECT_THAT(r.err, testing::HasSubstr("CL_")) << faults;
        EXPECT_FALSE(std::filesystem::exists(folder / "image.exr")) << faults;
    }
}

TEST_F(FaultyProgram, NoDeviceAndNoPlatformAreExitCode4)
{
    for (const char* faults : {"no_devices=1", "no_platforms=1"}) {
        const ProcessResult r = render(faults);
        EXPECT_EQ(r.exit_code, 4) << faults << '\n' << r.err;
        EXPECT_THAT(r.err, testing::HasSubstr("apt-get install pocl-opencl-icd")) << faults;
    }
}

TEST_F(FaultyProgram, OdditiesGiveTheSameImage)
{
    ASSERT_EQ(render("").exit_code, 0);
    const std::string expected = image();
    for (const char* faults : {"no_profiling=1", "largest_group=1", "fail_at=70 error=-5"}) {
        const ProcessResult r = render(faults);
        EXPECT_EQ(r.exit_code, 0) << faults << '\n' << r.err;
        EXPECT_EQ(report().at("timings").at("launches_timed_by"), std::string(faults) == "no_profiling=1" ? "wall clock" : "device");
        EXPECT_GT(report().at("timings").at("largest_launch_seconds"), 0) << faults;
        EXPECT_EQ(image(), expected) << faults;
    }
    EXPECT_EQ(render("", {"--launch-ms", "1"}).exit_code, 0);
    EXPECT_EQ(image(), expected) << "--launch-ms";
    EXPECT_EQ(render("", {}, {{"POCL_MEMORY_LIMIT", "1"}}).exit_code, 0);
    EXPECT_EQ(image(), expected) << "a device with a GiB";
}

TEST_F(FaultyProgram, ThreadsOfTheDriverNeverChangeAByte)
{
    ASSERT_EQ(render("").exit_code, 0);
    const std::string expected = image();
    for (const int threads : {1, 2, 3}) {
        const std::vector<std::pair<std::string, std::string>> environment{{"POCL_MAX_PTHREAD_COUNT", std::to_string(threads)}};
        const ProcessResult listed = run({"devices", "--json"}, {.environment = environment});
        const nlohmann::json device = nlohmann::json::parse(listed.out).at("devices").at(0);
        if (device.at("platform") != "Portable Computing Language") GTEST_SKIP() << "the variable is PoCL's";
        ASSERT_EQ(device.at("compute_units"), threads);
        EXPECT_EQ(render("", {}, environment).exit_code, 0);
        EXPECT_TRUE(image() == expected) << threads;
    }
}

TEST_F(FaultyProgram, NumbersThatAreNoneAreLeftOutCountedAndWithStrictNanExitCode1)
{
    ASSERT_EQ(render("", {"--strict-nan"}).exit_code, 0);
    const std::string sums = "poison=3";  // of the first piece; the reads before it are the ledgers
    for (const bool strict : {false, true}) {
        const ProcessResult r = render(sums, strict ? std::vector<std::string>{"--strict-nan"} : std::vector<std::string>{});
        EXPECT_EQ(r.exit_code, strict ? 1 : 0) << r.err;
        EXPECT_EQ(r.err.find("--strict-nan takes for a failure") != std::string::npos, strict);
        EXPECT_GT(report().at("numerics").at("not_finite_pixels"), 0);
        EXPECT_FALSE(report().at("numerics").at("first_cases").empty());
        EXPECT_TRUE(std::filesystem::exists(folder / "image.exr"));
    }
    for (const char* ledger : {"poison=0", "poison=1", "poison=2"}) EXPECT_EQ(render(ledger).exit_code, 0) << ledger;
}

TEST_F(FaultyProgram, TwoDevicesGiveTheImageOfOne)
{
    ASSERT_EQ(render("", {"--device", "0"}).exit_code, 0);
    const auto pairs = report().at("counts").at("pairs");
    for (const char* devices : {"0,1", "all"}) {
        const ProcessResult r = render("", {"--device", devices}, {{"POCL_DEVICES", "pthread pthread"}});
        EXPECT_EQ(r.exit_code, 0) << r.err;
        EXPECT_EQ(report().at("counts").at("pairs"), pairs);
    }
    const ProcessResult r = render("", {"--device", "0,7"}, {{"POCL_DEVICES", "pthread pthread"}});
    EXPECT_EQ(r.exit_code, 4) << r.err;
}

}  // namespace
}  // namespace tyndall::test
