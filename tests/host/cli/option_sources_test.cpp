/// Flag, then variable, then file, then scene, then default: what wins is what is rendered and what --print-config says.
#include <nlohmann/json.hpp>

#include "film/exr.hpp"
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class OptionSources : public Program {
protected:
    using Variables = std::vector<std::pair<std::string, std::string>>;
    ProcessResult render(std::vector<std::string> options, Variables variables = {})
    {
        options.insert(options.begin(), {"render", "scene.xml", "--method", "path", "--progress", "none"});
        return run(std::move(options), {.environment = std::move(variables)});
    }
    int passes() const { return nlohmann::json::parse(file_bytes(folder / "scene.json")).at("passes"); }
    std::string listed(std::vector<std::string> options, Variables variables = {})
    {
        options.emplace_back("--print-config");
        const ProcessResult ran = render(std::move(options), std::move(variables));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return ran.out;
    }
};

TEST_F(OptionSources, TheFlagWinsThenTheVariableThenTheFile)
{
    write_file("site.conf", "passes = 4\nhalf = true\n[bench]\nrepeats = 3\n");
    ASSERT_EQ(render({"--config", "site.conf"}).exit_code, 0);
    EXPECT_EQ(passes(), 4);
    EXPECT_TRUE(read_exr(folder / "scene.exr").channels.at("R").half);
    ASSERT_EQ(render({"--config", "site.conf"}, {{"TYNDALL_PASSES", "3"}, {"TYNDALL_HALF", "false"}}).exit_code, 0);
    EXPECT_EQ(passes(), 3);
    EXPECT_FALSE(read_exr(folder / "scene.exr").channels.at("R").half);
    ASSERT_EQ(render({"--config=site.conf", "--passes", "2"}, {{"TYNDALL_PASSES", "3"}}).exit_code, 0);
    EXPECT_EQ(passes(), 2);
    ASSERT_EQ(render({}, {{"TYNDALL_CONFIG", "site.conf"}, {"TYNDALL_PASSES", ""}}).exit_code, 0);
    EXPECT_EQ(passes(), 4);
}

TEST_F(OptionSources, EveryValueIsListedWithItsSource)
{
    write_file("site.conf", "passes = 4\nlights = 300\ndefine = density=2\nlayer = single\nlayer = emitted\n");
    const std::string list = listed({"--config", "site.conf", "--seed", "7"}, {{"TYNDALL_LIGHTS", "400"}});
    EXPECT_THAT(list, ContainsRegex("\nmethod = path +# command line\n"));
    EXPECT_THAT(list, ContainsRegex("\nseed = 7 +# command line\n"));
    EXPECT_THAT(list, ContainsRegex("\nlights = 400 +# TYNDALL_LIGHTS\n"));
    EXPECT_THAT(list, ContainsRegex("\npasses = 4 +# site.conf:1\n"));
    EXPECT_THAT(list, ContainsRegex("\nlayer = single +# site.conf:4\nlayer = emitted +# site.conf:4\n"));
    EXPECT_THAT(list, ContainsRegex("\ndefine = density=2 +# site.conf:3\n"));
    EXPECT_THAT(list, ContainsRegex("\n# max-depth = 4 +# scene.xml\n"));
    EXPECT_THAT(list, ContainsRegex("\n# resolution = 16x12 +# scene.xml\n"));
    EXPECT_THAT(list, ContainsRegex("\n# precision = f32 +# default\n"));
    EXPECT_THAT(list, ContainsRegex("\n# half = false +# default\n"));
    EXPECT_THAT(list, ContainsRegex("\n# report +# not given\n"));
    EXPECT_THAT(listed({"--max-depth", "2"}), ContainsRegex("\nmax-depth = 2 +# command line\n"));
    EXPECT_THAT(files(), testing::ElementsAre("scene.xml", "site.conf")) << "nothing is rendered";
}

TEST_F(OptionSources, TheListIsAFileThatMeansTheSame)
{
    const std::vector<std::string> options{"--passes", "2", "--seed", "9", "--define", "density=0.5", "--layer", "single,emitted", "--no-timestamps", "-o", "a b # c.exr"};
    write_file("again.conf", listed(options));
    ASSERT_EQ(render(options).exit_code, 0);
    const std::string first = file_bytes(folder / "a b # c.exr");
    std::filesystem::remove(folder / "a b # c.exr");
    ASSERT_EQ(run({"render", "scene.xml", "--config", "again.conf"}).exit_code, 0);
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(file_bytes(folder / "a b # c.exr"), first);
}

TEST_F(OptionSources, EveryOptionOfRenderHasAVariable)
{
    const std::string list = listed({});
    std::istringstream lines(list);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "[render]");
    int count = 0;
    for (; std::getline(lines, line); ++count) EXPECT_THAT(line, ContainsRegex("^(# )?[a-z-]+.* # ")) << line;
    EXPECT_GT(count, 45);
    EXPECT_THAT(listed({}, {{"TYNDALL_TARGET_ERROR", "1%"}, {"TYNDALL_NO_TIMESTAMPS", "true"}}),
                testing::AllOf(ContainsRegex("\ntarget-error = 1% +# TYNDALL_TARGET_ERROR\n"), ContainsRegex("\nno-timestamps = true +# TYNDALL_NO_TIMESTAMPS\n")));
}

TEST_F(OptionSources, AnOptionOnTheLineKeepsOutWhatItExcludes)
{
    write_file("site.conf", "long = true\n");
    EXPECT_THAT(listed({"--short", "--config", "site.conf"}, {{"TYNDALL_LONG", "true"}}), testing::AllOf(ContainsRegex("\nshort = true +# command line\n"), Not(HasSubstr("\nlong"))));
    EXPECT_EQ(run({"selftest", "--print-config", "--all-lanes"}, {.environment = {{"TYNDALL_LANES", "4"}}}).exit_code, 0);
}

TEST_F(OptionSources, ASectionIsForItsCommandAndWins)
{
    write_file("site.conf", "passes = 4\n[explain]\nseed = 5\n[render]\npasses = 2\n[animate]\nframes = 0:2\n");
    EXPECT_THAT(listed({"--config", "site.conf"}), testing::AllOf(ContainsRegex("\npasses = 2 +# site.conf:5\n"), Not(ContainsRegex("\nseed"))));
    const ProcessResult animate = run({"animate", "scene.xml", "--config", "site.conf", "--print-config"});
    EXPECT_EQ(animate.exit_code, 0) << animate.err;
    EXPECT_THAT(animate.out, testing::AllOf(ContainsRegex("\npasses = 4 +# site.conf:1\n"), ContainsRegex("\nframes = 0:2 +# site.conf:7\n")));
    EXPECT_EQ(run({"bench", "--print-config", "--config", "site.conf"}).exit_code, 0);
}

TEST_F(OptionSources, MistakesNameTheirSource)
{
    write_file("wrong.conf", "pases = 4\n"), write_file("value.conf", "\nlanes = 5\n"), write_file("twice.conf", "passes = 4\npasses = 5\n");
    write_file("section.conf", "[rendr]\npasses = 4\n"), write_file("other.conf", "[merge]\npasses = 4\n"), write_file("flag.conf", "half = perhaps\n");
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"--config", "wrong.conf"}, "wrong.conf:1:1: render has no option \"pases\" (did you mean \"passes\"?)"},
        {{"--config", "value.conf"}, "the value is that of value.conf:2"},
        {{"--config", "twice.conf"}, "twice.conf:2:1: \"passes\" is given before, at twice.conf:1"},
        {{"--config", "section.conf"}, "section.conf:2:1: there is no command \"rendr\" (did you mean \"render\"?)"},
        {{"--config", "other.conf"}, "other.conf:2:1: merge has no option \"passes\""},
        {{"--config", "flag.conf"}, "the value is that of flag.conf:1"},
        {{"--config", "missing.conf"}, "missing.conf"},
        {{"--config", "scene.xml"}, "scene.xml:1:"},
    };
    for (const auto& [options, sentence] : cases) {
        const ProcessResult ran = render(options);
        EXPECT_EQ(ran.exit_code, 2) << sentence << '\n' << ran.err;
        EXPECT_THAT(ran.err, HasSubstr(sentence));
    }
    const ProcessResult ran = render({}, {{"TYNDALL_PASSES", "many"}});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr("--passes \"many\": must be a whole number from 1 to 1073741824; the value is that of TYNDALL_PASSES"));
    EXPECT_THAT(files(), testing::Not(testing::Contains("scene.exr")));
}

TEST_F(OptionSources, FramesKnowWhatFilesAndVariablesSaid)
{
    write_file("site.conf", "passes = 1\nmethod = path\nresolution = 4x4\n[animate]\nframes = 0:1\nvary = density=1:1\n");
    ASSERT_EQ(run({"animate", "scene.xml", "-o", "frames", "--config", "site.conf"}).exit_code, 0);
    EXPECT_THAT(run({"animate", "scene.xml", "-o", "frames", "--config", "site.conf"}).err, HasSubstr("1 of 1 frames were done before"));
    EXPECT_THAT(run({"animate", "scene.xml", "-o", "frames", "--config", "site.conf"}, {.environment = {{"TYNDALL_PASSES", "2"}}}).err, Not(HasSubstr("were done before")));
}

}  // namespace
}  // namespace tyndall::test
