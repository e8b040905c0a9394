/// The manual page and the completion come from the same table as -h: what that lists they know.
#include <gmock/gmock.h>

#include <fstream>
#include <regex>
#include <set>

#include "program_fixture.hpp"

using namespace tyndall::test;
using testing::HasSubstr;

namespace {

const char* const commands[] = {"render", "animate", "explain", "compare", "merge", "info", "selftest", "bench", "devices", "man", "completion"};

std::string said(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), TYNDALL_PROGRAM);
    const ProcessResult ran = run_process(arguments);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return ran.out;
}

/// Long options at the starts of the lines of `tyndall COMMAND -h`.
std::set<std::string> options_of(const std::string& command)
{
    static const std::regex option(R"(\n\s+(?:-\w,)?(--[\w-]+))");
    const std::string help = said({command, "-h"});
    std::set<std::string> names;
    for (std::sregex_iterator match(help.begin(), help.end(), option), end; match != end; ++match) names.insert((*match)[1]);
    return names;
}

/// What bash offers after these words, the last of which is being typed.
std::set<std::string> offered(const std::string& words)
{
    const std::string script = "source <('" TYNDALL_PROGRAM "' completion bash); COMP_WORDS=(" + words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _tyndall; printf '%s\\n' \"${COMPREPLY[@]}\"";
    const ProcessResult ran = run_process({"/bin/bash", "-c", script});
    EXPECT_EQ(ran.err, "");
    std::set<std::string> names;
    std::istringstream lines(ran.out);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty()) names.insert(line);
    return names;
}

TEST(ManualPage, NamesEveryCommandAndOption)
{
    const std::string page = std::regex_replace(said({"man"}), std::regex(R"(\\-)"), "-");
    for (const std::string command : commands) {
        EXPECT_THAT(page, HasSubstr("\n.SS tyndall " + command + "\n"));
        const std::size_t start = page.find("\n.SS tyndall " + command + "\n"), end = page.find("\n.S", start + 5);
        for (const std::string& option : options_of(command)) EXPECT_THAT(page.substr(start, end - start), HasSubstr("\\fB" + option + "\\fR")) << command;
    }
    EXPECT_GT(options_of("render").size(), 30u);
    for (const char* variable : {"TYNDALL_DEVICE", "TYNDALL_THREADS", "XDG_CACHE_HOME"}) EXPECT_THAT(page, HasSubstr(variable));
}

TEST(ManualPage, IsRoffWithoutWarnings)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "tyndall.1") << said({"man"});
    const ProcessResult ran = run_process({"/bin/sh", "-c", "command -v groff >/dev/null || exit 77; groff -man -ww -Tutf8 -z tyndall.1"}, {.folder = folder.path()});
    if (ran.exit_code == 77) GTEST_SKIP() << "there is no groff";
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "");
}

TEST(Completion, OffersCommandsOptionsAndNames)
{
    EXPECT_EQ(offered("tyndall rend"), std::set<std::string>{"render"});
    EXPECT_EQ(offered("tyndall render --target"), std::set<std::string>{"--target-error"});
    EXPECT_EQ(offered("tyndall render --sampler table-"), (std::set<std::string>{"table-3x2", "table-4x4"}));
    EXPECT_THAT(offered("tyndall render --method ''"), testing::IsSupersetOf({"vrl", "vpl", "path"}));
    EXPECT_EQ(offered("tyndall merge --target"), std::set<std::string>{});
    const std::set<std::string> first = offered("tyndall ''"), options = offered("tyndall render --");
    for (const std::string command : commands) EXPECT_TRUE(first.contains(command)) << command;
    for (const std::string& option : options_of("render")) EXPECT_TRUE(options.contains(option)) << option;
}

TEST(Completion, FishKnowsEveryCommandAndOption)
{
    const std::string script = said({"completion", "fish"});
    for (const std::string command : commands) {
        EXPECT_THAT(script, HasSubstr("-a " + command + " -d '")) << command;
        for (const std::string& option : options_of(command))
            EXPECT_THAT(script, testing::ContainsRegex("\n[^\n]*__fish_seen_subcommand_from " + command + "'[^\n]* -l " + option.substr(2) + " ")) << command << option;
    }
    EXPECT_THAT(script, testing::ContainsRegex("-l sampler -x -a 'auto[^\n]* table-3x2'"));
    EXPECT_THAT(script, HasSubstr("-s p -l passes -r -d 'stop after N passes"));
}

TEST(Completion, FishOffersThem)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "tyndall.fish") << said({"completion", "fish"});
    const auto offers = [&](const std::string& line) {
        const ProcessResult ran = run_process({"/bin/sh", "-c", "command -v fish >/dev/null || exit 77; HOME=. XDG_DATA_HOME=. fish --no-config -c 'source tyndall.fish; complete -C \"" + line + "\"'"}, {.folder = folder.path()});
        EXPECT_THAT(ran.exit_code, testing::AnyOf(0, 77)) << ran.err;
        return ran.exit_code == 77 ? std::string() : ran.out + " ";
    };
    if (offers("tyndall rend").empty()) GTEST_SKIP() << "there is no fish";
    EXPECT_THAT(offers("tyndall rend"), testing::StartsWith("render\t"));
    EXPECT_THAT(offers("tyndall render --target-e"), testing::StartsWith("--target-error\t"));
    EXPECT_THAT(offers("tyndall render --sampler table-"), testing::AllOf(HasSubstr("table-3x2"), HasSubstr("table-4x4")));
    EXPECT_EQ(offers("tyndall merge --target-e").find("--target-error"), std::string::npos);
}

TEST(Completion, ZshTakesBashs)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "tyndall.zsh") << said({"completion", "zsh"});
    const std::string script = "command -v zsh >/dev/null || exit 77; zsh -f -c 'autoload -U compinit && compinit -u -D; source ./tyndall.zsh; print -r -- $_comps[tyndall]; _tyndall; print -r -- done'";
    const ProcessResult ran = run_process({"/bin/sh", "-c", script}, {.folder = folder.path()});
    if (ran.exit_code == 77) GTEST_SKIP() << "there is no zsh";
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("_bash_complete -o filenames -F _tyndall\n"));
}

TEST(Completion, AnotherShellIsRefused)
{
    const ProcessResult ran = run_process({TYNDALL_PROGRAM, "completion", "tcsh"});
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_THAT(ran.err, HasSubstr("bash, zsh and fish"));
}

}  // namespace
