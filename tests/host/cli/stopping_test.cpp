#include <csignal>
#include <memory>

#include "film/exr.hpp"
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

class Stopping : public Program, public testing::WithParamInterface<int> {
protected:
    /// Starts a render that would go on for minutes, and waits for its first pass.
    std::unique_ptr<ChildProcess> started()
    {
        const auto arguments = command({"render", "scene.xml", "--method", "path", "--passes", "1000000", "--progress", "plain"});
        auto process = std::make_unique<ChildProcess>(arguments, here());
        EXPECT_TRUE(process->wait_for_error_text("pass 1"));
        return process;
    }
};

TEST_P(Stopping, FirstSignalWritesWhatIsThere)
{
    const auto process = started();
    process->send(GetParam());
    const auto result = process->wait();
    EXPECT_EQ(result.exit_code, 128 + GetParam()) << result.err;
    EXPECT_THAT(files(), testing::ElementsAre("scene.exr", "scene.json", "scene.png", "scene.xml"));
    const auto image = read_exr(folder / "scene.exr");
    const int passes = std::get<int>(image.attributes.at("tyndall.passes"));
    EXPECT_GE(passes, 1);
    EXPECT_LT(passes, 1000000);
    EXPECT_EQ(image.channels.at("samples").values[0], static_cast<float>(passes));
    EXPECT_THAT(file_bytes(folder / "scene.json"), testing::HasSubstr("\"stopped_by\": \"interrupt\""));
}

INSTANTIATE_TEST_SUITE_P(Signals, Stopping, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST_F(Program, SecondSignalEndsAtOnceAndWritesNothing)
{
    // Some ten seconds for a pass, so both signals come within the first one.
    const auto arguments = command({"render", "scene.xml", "--method", "path", "--passes", "2", "--resolution", "2048x2048", "--layer",
                                    "media_to_media", "--progress", "plain"});
    ChildProcess process(arguments, here());
    ASSERT_TRUE(process.wait_for_error_text("rendering"));
    process.send(SIGINT);
    ASSERT_TRUE(process.wait_for_error_text("stopping after this pass"));
    process.send(SIGINT);
    const auto result = process.wait(std::chrono::seconds(5));
    EXPECT_EQ(result.exit_code, 130) << result.err;
    EXPECT_THAT(files(), testing::ElementsAre("scene.xml"));
}

TEST_F(Program, AnIgnoredHangUpStaysIgnored)
{
    const auto arguments = std::vector<std::string>{"/usr/bin/nohup", TYNDALL_PROGRAM, "render", "scene.xml",  "--method",
                                                    "path",           "--time",        "2s",     "--progress", "plain"};
    ChildProcess process(arguments, here());
    ASSERT_TRUE(process.wait_for_error_text("pass 1"));
    process.send(SIGHUP);
    EXPECT_EQ(process.wait().exit_code, 0);
}

}  // namespace
}  // namespace tyndall::test
