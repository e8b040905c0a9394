/// What a terminal shows: the program in a pseudo-terminal.
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <regex>

#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class Terminal : public Program {
protected:
    /// All that the program writes to a terminal of that kind, standard output and error.
    std::string shown(std::vector<std::string> arguments, const char* kind, bool no_colour)
    {
        arguments = command(std::move(arguments));
        std::vector<char*> pointers;
        for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
        pointers.push_back(nullptr);
        int terminal = -1;
        const winsize size{.ws_row = 24, .ws_col = 100, .ws_xpixel = 0, .ws_ypixel = 0};
        const pid_t child = ::forkpty(&terminal, nullptr, nullptr, &size);
        if (child == 0) {
            ::setenv("TERM", kind, 1);
            no_colour ? ::setenv("NO_COLOR", "1", 1) : ::unsetenv("NO_COLOR");
            if (::chdir(folder.path().c_str()) != 0) ::_exit(127);
            ::execv(pointers[0], pointers.data());
            ::_exit(127);
        }
        std::string text;
        char part[4096];
        for (ssize_t count; (count = ::read(terminal, part, sizeof part)) > 0;) text.append(part, static_cast<std::size_t>(count));
        ::close(terminal);
        int status = -1;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0) << text;
        return text;
    }
    const std::vector<std::string> render{"render", "scene.xml", "--method", "path", "--passes", "3"};
};

/// Sequences that choose colours or weights: ESC [ ... m.
bool coloured(const std::string& text) { return std::regex_search(text, std::regex("\x1b\\[[0-9;]*m")); }

TEST_F(Terminal, HasABarAndNoColourWithOrWithoutNoColor)
{
    for (const bool no_colour : {true, false}) {
        const std::string text = shown(render, "xterm-256color", no_colour);
        EXPECT_THAT(text, HasSubstr("[####################] pass 3/3"));
        EXPECT_FALSE(coloured(text)) << text;
    }
    EXPECT_TRUE(coloured("\x1b[31mred\x1b[0m")) << "the test sees colours";
}

TEST_F(Terminal, ThatCannotEraseHasPlainLines)
{
    for (const char* kind : {"dumb", ""}) {
        const std::string text = shown(render, kind, false);
        EXPECT_THAT(text, HasSubstr("100 %  pass 3/3"));
        EXPECT_THAT(text, Not(HasSubstr("\x1b"))) << kind;
    }
    std::vector<std::string> asked = render;
    asked.insert(asked.end(), {"--progress", "bar"});
    EXPECT_THAT(shown(asked, "dumb", false), HasSubstr("[####################] pass 3/3")) << "who asks for it gets it";
}

TEST_F(Terminal, NamesOfFilesAndScenesCarryNoEscapeCodes)
{
    std::string scene = fog_scene;
    scene.replace(scene.find("<integrator"), 0, "<shape type=\"sphere\" id=\"\x7f&#x1b;[31m\"/>");  // refused or told of, not obeyed
    const std::string name = "red\x1b[31m\x1b]0;title\x07.xml";
    write_file(name, scene);
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"info", name}, {"render", name, "--method", "path", "-p", "1"}, {"explain", name, "--method", "path"}, {"render", name + "x"}}) {
        const ProcessResult ran = run(arguments);
        for (const std::string& text : {ran.err, arguments[0] == "render" ? std::string() : ran.out}) EXPECT_EQ(text.find_first_of("\x1b\x07\x7f"), std::string::npos) << arguments[0] << ": " << text;
    }
}

}  // namespace
}  // namespace tyndall::test
