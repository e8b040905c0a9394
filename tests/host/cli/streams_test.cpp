/// Standard streams that are full, closed or read by nobody.
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;

/// A command line for a shell: the program with these words, then what follows it.
std::string in_shell(const std::string& words, const std::string& then) { return "'" TYNDALL_PROGRAM "' " + words + then; }

TEST_F(Program, FullStandardOutputExitsWith6)
{
    for (const auto& arguments : {std::vector<std::string>{"info", "scene.xml", "--json"}, {"man"}, {"-h"}}) {  // less and more than a stream's buffer
        const ProcessResult result = run(arguments, {.standard_output = "/dev/full"});
        EXPECT_EQ(result.exit_code, 6) << arguments[0] << result.err;
        EXPECT_THAT(result.err, HasSubstr("standard output could not be written"));
    }
}

TEST_F(Program, AReaderThatGoesAwayExitsWith6)
{
    const ProcessResult result = run_process({"/bin/bash", "-c", "{ sleep 1; " + in_shell("man", "; } | true; exit ${PIPESTATUS[0]}")}, here());  // gone by then
    EXPECT_EQ(result.exit_code, 6) << result.err;
    EXPECT_THAT(result.err, HasSubstr("standard output could not be written"));
}

TEST_F(Program, StreamsThatCannotBeWrittenEndNoRender)
{
    const std::string words = "render scene.xml --method path --passes 2 --no-timestamps -o ";
    ASSERT_EQ(run_process({"/bin/bash", "-c", in_shell(words, "told.exr")}, here()).exit_code, 0);
    const std::string expected = file_bytes(folder / "told.exr");
    ASSERT_FALSE(expected.empty());
    const std::pair<const char*, int> cases[] = {{"2>/dev/full", 0}, {"2>&-", 0}, {"<&- 2>&-", 0}, {">/dev/full 2>/dev/full", 6}, {">&- 2>&-", 6}, {">&- <&-", 6}, {"--progress json >/dev/full", 6}};
    for (const auto& [streams, code] : cases) {
        std::filesystem::remove(folder / "untold.exr");
        EXPECT_EQ(run_process({"/bin/bash", "-c", in_shell(words, std::string("untold.exr ") + streams)}, here()).exit_code, code) << streams;
        EXPECT_TRUE(file_bytes(folder / "untold.exr") == expected) << streams;
    }
}

}  // namespace
}  // namespace tyndall::test
