/// What a machine, a user or a stranger's scene can do to the program from outside.
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "../cli/program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;

class Hostile : public Program {
protected:
    ProcessResult render(std::vector<std::string> options, std::vector<std::pair<std::string, std::string>> environment = {})
    {
        options.insert(options.begin(), {"render", "scene.xml", "--passes", "1", "--lights", "64", "--no-selftest", "--no-timestamps", "--progress", "none"});
        return run(std::move(options), {.environment = std::move(environment)});
    }
    /// A folder for OCL_ICD_VENDORS with these .icd files.
    std::string vendors(const std::vector<std::pair<std::string, std::string>>& icds)
    {
        std::filesystem::create_directories(folder / "vendors");
        for (const auto& [name, text] : icds) write_file("vendors/" + name + ".icd", text + "\n");
        return (folder / "vendors").string() + "/";
    }
};

TEST_F(Hostile, ABadDriverIsPassedOverAndNamed)
{
    write_file("garbage.so", "this is no library");
    const std::string folder_of_icds = vendors({{"missing", "libno_such_driver.so.1"}, {"garbage", (folder / "garbage.so").string()}, {"empty", ""}});
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"render", "scene.xml"}, {"devices"}, {"selftest"}}) {
        const ProcessResult r = run(arguments, {.environment = {{"OCL_ICD_VENDORS", folder_of_icds}}});
        EXPECT_EQ(r.exit_code, 4) << r.signal << r.err;
        EXPECT_THAT(r.err, HasSubstr("OCL_ICD_VENDORS=" + folder_of_icds));
        EXPECT_THAT(r.err, HasSubstr("apt-get install pocl-opencl-icd"));
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "scene.exr"));
}

TEST_F(Hostile, TwoRunsOnOneOutputLeaveOneOfThemWhole)
{
    std::string whole[2];
    const auto arguments = [](const char* seed) { return std::vector<std::string>{"render", "scene.xml", "--method", "path", "--passes", "8", "--no-timestamps", "--progress", "none", "-o", "same.exr", "--seed", seed}; };
    for (const int i : {0, 1}) {
        ASSERT_EQ(run(arguments(i ? "2" : "1")).exit_code, 0);
        whole[i] = file_bytes(folder / "same.exr");
    }
    ASSERT_NE(whole[0], whole[1]);
    for (int repeat = 0; repeat < 3; ++repeat) {
        ChildProcess one(command(arguments("1")), here()), two(command(arguments("2")), here());
        EXPECT_EQ(one.wait().exit_code, 0);
        EXPECT_EQ(two.wait().exit_code, 0);
        EXPECT_THAT(file_bytes(folder / "same.exr"), testing::AnyOf(whole[0], whole[1]));
        EXPECT_THAT(files(), testing::ElementsAre("same.exr", "same.json", "same.png", "scene.xml"));
    }
}

TEST_F(Hostile, DumpedKernelsAreWhatTheCompilerSawAndChangeNoByte)
{
    ASSERT_EQ(render({"--lanes", "4"}).exit_code, 0);
    const std::string expected = file_bytes(folder / "scene.exr");
    const ProcessResult r = render({"--lanes", "4", "--dump-kernels", "kernels/of a run"});
    ASSERT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(file_bytes(folder / "scene.exr"), expected);
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "kernels/of a run")) {
        const std::string text = file_bytes(entry.path());
        EXPECT_THAT(text, testing::AllOf(testing::StartsWith("// "), HasSubstr("-DLANES=4"), HasSubstr("#line 1 \"kernels/dialect.h\""), HasSubstr("__kernel"))) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 1);
    const ProcessResult refused = render({"--dump-kernels", "scene.xml/below"});
    EXPECT_EQ(refused.exit_code, 6) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr("scene.xml/below"));
}

TEST_F(Hostile, ACacheThatCannotBeWrittenDoesNotEndTheRender)
{
    ASSERT_EQ(render({}).exit_code, 0);
    const std::string expected = file_bytes(folder / "scene.exr");
    write_file("file", "not a folder");
    const std::filesystem::path temporary = folder / "temporary";
    std::filesystem::create_directory(temporary);
    for (const std::string& cache : {(folder / "file").string(), (folder / "file").string() + "/below", std::string("/proc/no_such_folder"), std::string("/dev/full")}) {
        const ProcessResult r = render({}, {{"POCL_CACHE_DIR", cache}, {"TMPDIR", temporary.string()}});
        EXPECT_EQ(r.exit_code, 0) << cache << ", signal " << r.signal << '\n' << r.err;
        EXPECT_EQ(file_bytes(folder / "scene.exr"), expected) << cache;
        EXPECT_THAT(r.err, HasSubstr("warning: PoCL cannot keep kernels in " + cache)) << "and where they are kept";
        EXPECT_THAT(r.err, HasSubstr("set POCL_CACHE_DIR"));
    }
    for (const auto& entry : std::filesystem::directory_iterator(temporary)) ADD_FAILURE() << entry.path() << " is left";
}

TEST_F(Hostile, AFullDiskUnderTheKernelCacheIsNoCrash)
{
    std::filesystem::create_directories(folder / "cache");
    const ProcessResult r = run({"render", "scene.xml", "--passes", "1", "--lights", "64", "--no-selftest", "--progress", "none"},
                                {.environment = {{"POCL_CACHE_DIR", (folder / "cache").string()}}, .file_size_limit = 100});
    EXPECT_THAT(r.exit_code, testing::AnyOf(5, 6)) << "signal " << r.signal << '\n' << r.err;
    EXPECT_THAT(r.err, HasSubstr("tyndall: "));
    EXPECT_FALSE(std::filesystem::exists(folder / "scene.exr"));
}

/// Waits, then sends; the process has ended within seconds.
TEST_F(Hostile, ADriverThatHangsIsLeftBySignals)
{
    for (const char* hang_at : {"30", "200"}) {  // before the first pass and after it
        ProcessSetup setup = here();
        setup.environment = {{"LD_PRELOAD", TYNDALL_FAULTY_OPENCL_LIBRARY}, {"TYNDALL_FAULTY_OPENCL", std::string("hang=1 say=1 fail_at=") + hang_at}, {"ASAN_OPTIONS", "verify_asan_link_order=0"}};
        ChildProcess process(command({"render", "scene.xml", "--passes", "1000", "--lights", "64", "--no-selftest", "--progress", "plain"}), setup);
        ASSERT_TRUE(process.wait_for_error_text("faulty OpenCL:")) << hang_at;
        process.send(SIGINT);
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        process.send(SIGINT);
        const ProcessResult r = process.wait(std::chrono::seconds(20));
        EXPECT_EQ(r.exit_code, 130) << hang_at << ", signal " << r.signal << '\n' << r.err;
        EXPECT_THAT(files(), testing::ElementsAre("scene.xml"));
    }
}

TEST_F(Hostile, ReferencesOutOfTheFolderEndWith3AtOnce)
{
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::filesystem::create_symlink("/etc/passwd", folder / "link.ply");
    for (const std::string name : {"../../etc/passwd", "/etc/passwd", "link.ply", "pipe", "/dev/zero", "/proc/self/mem", ".", ""}) {
        std::string scene = fog_scene;
        scene.insert(scene.find("<emitter"), "<shape type=\"ply\"><string name=\"filename\" value=\"" + name + "\"/></shape>");
        write_file("hostile.xml", scene);
        ChildProcess process(command({"render", "hostile.xml", "--method", "path", "-p", "1"}), here());
        const ProcessResult r = process.wait(std::chrono::seconds(20));
        EXPECT_EQ(r.exit_code, 3) << name << ", signal " << r.signal << '\n' << r.err;
        EXPECT_THAT(r.err, testing::ContainsRegex("hostile\\.xml:[0-9]+:[0-9]+: ")) << name;
        EXPECT_EQ(r.err.find("root:"), std::string::npos) << "contents of a file outside are told";
    }
}

TEST_F(Hostile, BombsEndWith3AtOnce)
{
    std::string deep, many;
    for (int i = 0; i < 100000; ++i) deep += "<bsdf type=\"twosided\">";
    for (int i = 0; i < 100000; ++i) deep += "</bsdf>";
    for (int i = 0; i < 2000000; ++i) many += "<a/>";
    const std::pair<const char*, std::string> scenes[] = {
        {"DOCTYPE", "<!DOCTYPE scene [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;&a;\">]><scene version=\"3.0.0\">&b;</scene>"},
        {"nested deeper", "<scene version=\"3.0.0\">" + deep + "</scene>"},
        {"more than 1000000 tags", "<scene version=\"3.0.0\">" + many + "</scene>"},
        {"includes itself", "<scene version=\"3.0.0\"><include filename=\"bomb.xml\"/></scene>"},
    };
    for (const auto& [sentence, text] : scenes) {
        write_file("bomb.xml", text);
        ChildProcess process(command({"render", "bomb.xml", "--method", "path", "-p", "1"}), here());
        const ProcessResult r = process.wait(std::chrono::seconds(30));
        EXPECT_EQ(r.exit_code, 3) << sentence << ", signal " << r.signal << '\n' << r.err.substr(0, 500);
        EXPECT_THAT(r.err, HasSubstr(sentence));
    }
}

}  // namespace
}  // namespace tyndall::test
