/// host/docs/tutorial.md does what it says: its scene is saved, its commands are run.
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

/// The fenced blocks of a kind, one after the other.
std::string blocks(const std::string& document, const std::string& kind)
{
    std::string all;
    const std::string opening = "```" + kind + "\n";
    for (std::size_t at = 0; (at = document.find(opening, at)) != std::string::npos;) {
        at += opening.size();
        const std::size_t end = document.find("```", at);
        all += document.substr(at, end - at);
        at = end;
    }
    return all;
}

TEST_F(Program, TheTutorialDoesWhatItSays)
{
    const std::string document = file_bytes(std::string(TYNDALL_SOURCE_DIR) + "/host/docs/tutorial.md");
    write_file("fog.xml", blocks(document, "xml"));
    const std::string commands = blocks(document, "sh");
    EXPECT_GE(std::ranges::count(commands, '\n'), 7);
    const std::string program = TYNDALL_PROGRAM;
    write_file("commands", "set -e\nPATH=" + program.substr(0, program.rfind('/')) + ":$PATH\n" + commands);
    const ProcessResult ran = run_process({"/bin/bash", "commands"}, here());
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    for (const char* file : {"fog.exr", "fog.png", "fog.json", "thick.exr", "reference.exr", "page/index.html", "page/comparison.json"}) {
        EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
        EXPECT_NE(document.find(std::string(file).substr(0, std::string(file).find('.'))), std::string::npos);
    }
}

}  // namespace
}  // namespace tyndall::test
