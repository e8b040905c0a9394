// The two commands of the README, with the system's package tools replaced by ones that only write down how they were called.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "source_tree.hpp"

using namespace tyndall::house;
using testing::HasSubstr;

namespace {

const fs::path root = TYNDALL_SOURCE_DIR;

struct Outcome {
    int exit_code = -1;
    std::string output, calls;
};

std::string read(const fs::path& file)
{
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write_tool(const TemporaryFolder& folder, const std::string& name, const std::string& body)
{
    folder.write("bin/" + name, "#!/bin/bash\n" + body + "\n");
    fs::permissions(folder.path() / "bin" / name, fs::perms::owner_all);
}

std::string quoted(const fs::path& path) { return std::string("'").append(path.string()).append("'"); }

/// Runs a bash command where dpkg-query knows only the package "there", and apt-get and sudo note their arguments.
Outcome run(const TemporaryFolder& folder, const std::string& command)
{
    const std::string calls = quoted(folder.path() / "calls");
    write_tool(folder, "dpkg-query", "[[ ${!#} == there ]] && echo -n installed");
    write_tool(folder, "apt-get", "echo \"apt-get $*\" >>" + calls);
    write_tool(folder, "sudo", "echo \"sudo $*\" >>" + calls + "; exec \"$@\"");
    const std::string shell = "PATH=" + quoted(folder.path() / "bin") + ":$PATH; " + command;
    folder.write("script.sh", shell + "\n");
    const std::string line = "bash " + quoted(folder.path() / "script.sh") + " >" + quoted(folder.path() / "output") + " 2>&1";
    const int status = std::system(line.c_str());
    return {WEXITSTATUS(status), read(folder.path() / "output"), read(folder.path() / "calls")};
}

const std::string helper = "set -euo pipefail; source " + quoted(root / "host/cmake/install_and_build.sh") + "; ";

}  // namespace

TEST(Scripts, NothingMissingMeansNoPackageTool)
{
    const TemporaryFolder folder;
    const Outcome outcome = run(folder, helper + "install_packages there");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.calls, "");
}

TEST(Scripts, OnlyMissingPackagesAreInstalledAfterAnUpdate)
{
    const TemporaryFolder folder;
    const Outcome outcome = run(folder, helper + "install_packages away there gone");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("away gone"));
    EXPECT_EQ(outcome.calls, "apt-get update --quiet\napt-get install --yes --quiet --no-install-recommends away gone\n");
}

TEST(Scripts, FailedUpdateStopsTheScript)
{
    const TemporaryFolder folder;
    const Outcome outcome = run(folder, helper + "apt-get() { :; }; as_root() { return 100; }; install_packages away; echo went on");
    EXPECT_EQ(outcome.exit_code, 100) << outcome.output;
    EXPECT_THAT(outcome.output, testing::Not(HasSubstr("went on")));
}

TEST(Scripts, OthersThanRootInstallThroughSudo)
{
    const TemporaryFolder folder;
    const Outcome outcome = run(folder, helper + "id() { echo 1000; }; install_packages away");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_THAT(outcome.calls, testing::StartsWith("sudo env DEBIAN_FRONTEND=noninteractive apt-get update"));
}

TEST(Scripts, WithoutRootAndSudoASentenceSaysSo)
{
    const TemporaryFolder folder;
    const Outcome outcome = run(folder, helper + "id() { echo 1000; }; command() { return 1; }; install_packages away");
    EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("needs root"));
    EXPECT_EQ(outcome.calls, "");
}

TEST(Scripts, UnknownSceneIsRefusedBeforeAnythingIsInstalled)
{
    const TemporaryFolder folder;
    const Outcome outcome = run(folder, "bash " + quoted(root / "scenes/render.sh") + " no_such_scene");
    EXPECT_EQ(outcome.exit_code, 3) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("fruit_juice"));
    EXPECT_EQ(outcome.calls, "");
}

TEST(Scripts, ContinuousIntegrationRunsTheTestsCommand)
{
    const fs::path ci = root / ".ci/run";
    EXPECT_NE(fs::status(ci).permissions() & fs::perms::owner_exec, fs::perms::none);
    EXPECT_THAT(read(ci), HasSubstr("tests/run.sh"));
}

// Stages that a plain .ci/run leaves out have a job of their own, labels too, and what the jobs call is there.
TEST(Scripts, TheWorkflowRunsEveryStageAndLabel)
{
    const std::string workflow = read(root / ".github/workflows/ci.yml"), ci = read(root / ".ci/run");
    EXPECT_THAT(workflow, HasSubstr("- run: bash .ci/run\n"));
    std::smatch known;
    ASSERT_TRUE(std::regex_search(ci, known, std::regex(R"(known=\("\$\{plain\[@\]\}"([a-z ]*)\))")));
    std::istringstream stages(known[1]);
    for (std::string stage; stages >> stage;) EXPECT_THAT(workflow, HasSubstr("- run: bash .ci/run " + stage + "\n"));
    EXPECT_THAT(workflow, HasSubstr("-L slow"));
    const std::regex script(R"(\b(?:tests|bench)/[\w/]+\.sh\b)");
    int scripts = 0;
    for (std::sregex_iterator match(workflow.begin(), workflow.end(), script), end; match != end; ++match, ++scripts) EXPECT_TRUE(fs::exists(root / match->str())) << match->str();
    EXPECT_GE(scripts, 5);
}

// With tools that only say how they were called: packages, CMake, CTest.
TEST(Scripts, TheSanitizersScriptBuildsAndTestsEveryPresetThatHasOne)
{
    const std::string presets = read(root / "CMakePresets.json");
    const std::regex sanitized(R"lit(\{"name": "(\w+)", "inherits": "sanitized", "cacheVariables": \{"TYNDALL_SANITIZE")lit");
    const TemporaryFolder folder;
    folder.write("tests/sanitize.sh", read(root / "tests/sanitize.sh"));
    folder.write("host/cmake/install_and_build.sh", "repository_root=" + quoted(folder.path()) + "; install_packages() { :; }; say() { echo \"$*\"; }\n");
    for (const char* tool : {"cmake", "ctest"}) write_tool(folder, tool, "echo \"" + std::string(tool) + " $*\"");
    write_tool(folder, "llvm-symbolizer", "");
    std::string names;
    for (std::sregex_iterator match(presets.begin(), presets.end(), sanitized), end; match != end; ++match) {
        const std::string name = (*match)[1];
        names += name + " ";
        const Outcome outcome = run(folder, "bash " + quoted(folder.path() / "tests/sanitize.sh") + " " + name);
        EXPECT_EQ(outcome.exit_code, 0) << name << ": " << outcome.output;
        EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("cmake --preset " + name), HasSubstr("cmake --build --preset " + name), HasSubstr("ctest --test-dir build/" + name)));
        EXPECT_THAT(presets, HasSubstr("\"configurePreset\": \"" + name + "\"")) << "a preset to build with";
    }
    EXPECT_EQ(names, "asan ubsan tsan ");
    EXPECT_EQ(run(folder, "bash " + quoted(folder.path() / "tests/sanitize.sh") + " no_such_sanitizer").exit_code, 2);
}

namespace {

/// `.ci/run` among scripts that say their names, of which those that match `failing` fail.
std::string continuous_integration(const TemporaryFolder& folder, const std::string& failing)
{
    for (const char* script : {"build", "fuzz/run", "sanitize", "oclgrind", "rusticl", "variants", "run"})
        folder.write("tests/" + std::string(script) + ".sh", "echo \"$(basename $0) $*\"; [[ $0 != *" + failing + "* ]]\n");
    folder.write(".ci/run", read(root / ".ci/run"));
    return "bash " + quoted(folder.path() / ".ci/run");
}

}  // namespace

TEST(Scripts, AFailedStageFailsTheRunAndKeepsNoOtherFromRunning)
{
    const TemporaryFolder folder;
    const std::string ci = continuous_integration(folder, "rusticl");
    const Outcome all = run(folder, ci + " build rusticl oclgrind tests");
    EXPECT_EQ(all.exit_code, 1) << all.output;
    EXPECT_THAT(all.output, HasSubstr("oclgrind.sh")) << "after the stage that failed";
    EXPECT_TRUE(all.output.ends_with("\nrun.sh \n")) << "the tests' lines come last: " << all.output;
    EXPECT_EQ(run(folder, ci + " fuzz build").exit_code, 0);
    EXPECT_EQ(run(folder, ci + " no_such_stage").exit_code, 2);
}

TEST(Scripts, WithoutArgumentsEveryStageRunsAndTheTestsRunLast)
{
    const TemporaryFolder folder;
    const std::string ci = continuous_integration(folder, "none");
    const Outcome all = run(folder, ci);
    EXPECT_EQ(all.exit_code, 0) << all.output;
    EXPECT_THAT(all.output, testing::AllOf(HasSubstr("\nrun.sh 20\n"), HasSubstr("sanitize.sh asan"), HasSubstr("sanitize.sh tsan"), HasSubstr("\noclgrind.sh \n"), HasSubstr("\nrusticl.sh \n"), HasSubstr("\nvariants.sh \n")));
    EXPECT_TRUE(all.output.ends_with("\nrun.sh \n")) << all.output;
}

TEST(Scripts, WhatFuzzersFindIsToldAmongOtherStagesAndFailsByItself)
{
    const TemporaryFolder folder;
    const std::string ci = continuous_integration(folder, "none");
    folder.write("tests/fuzz/run.sh", "exit 3\n");
    const Outcome among_others = run(folder, ci + " fuzz tests");
    EXPECT_EQ(among_others.exit_code, 0) << among_others.output;
    EXPECT_THAT(among_others.output, testing::ContainsRegex("fuzz .*FOUND SOMETHING"));
    EXPECT_EQ(run(folder, ci + " fuzz").exit_code, 1);
    folder.write("tests/fuzz/run.sh", "exit 1\n");
    EXPECT_EQ(run(folder, ci + " fuzz tests").exit_code, 1) << "a fuzzer that cannot be built";
}

TEST(Scripts, TheRunHasTheMinutesThatDocumentAndWorkflowSay)
{
    const std::string ci = read(root / ".ci/run"), workflow = read(root / ".github/workflows/ci.yml");
    std::smatch minutes, of_the_job;
    ASSERT_TRUE(std::regex_search(ci, minutes, std::regex(R"(TYNDALL_CI_MINUTES:-(\d+))")));
    ASSERT_TRUE(std::regex_search(workflow, of_the_job, std::regex(R"(default:\n(?: .*\n)*?    timeout-minutes: (\d+)\n)")));
    EXPECT_LE(std::stoi(minutes[1]), 75);
    EXPECT_EQ(std::stoi(of_the_job[1]), std::stoi(minutes[1]) + 5);
    EXPECT_THAT(ci, HasSubstr("TYNDALL_CI_MINUTES, " + minutes.str(1) + ":"));
    EXPECT_THAT(read(root / "host/docs/ci.md"), HasSubstr("have " + minutes.str(1) + " minutes (`TYNDALL_CI_MINUTES`), and the job of the workflow five more"));
}

TEST(Scripts, StagesForWhichThereIsNoTimeAreLeftOutAndSaidSo)
{
    const TemporaryFolder folder;
    const std::string ci = continuous_integration(folder, "none");
    const Outcome hurried = run(folder, "TYNDALL_CI_MINUTES=25 " + ci);
    EXPECT_EQ(hurried.exit_code, 0) << hurried.output;
    EXPECT_THAT(hurried.output, testing::ContainsRegex("asan .*SKIPPED: no time"));
    EXPECT_THAT(hurried.output, testing::Not(HasSubstr("sanitize.sh asan\n"))) << "three minutes are left before the tests";
    EXPECT_THAT(hurried.output, HasSubstr("\noclgrind.sh \n"));
    EXPECT_TRUE(hurried.output.ends_with("\nrun.sh \n")) << hurried.output;
    EXPECT_THAT(run(folder, "TYNDALL_CI_MINUTES=1 " + ci + " asan").output, HasSubstr("SKIPPED")) << "without the tests, too";
}
