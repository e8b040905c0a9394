#include <chrono>
#include <csignal>
#include <memory>
#include <thread>

#include "film/exr.hpp"
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

class Stopping : public Program {
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

class StoppingBy : public Stopping, public testing::WithParamInterface<int> {};

TEST_P(StoppingBy, FirstSignalWritesWhatIsThere)
{
    const auto process = started();
    process->send(GetParam());
    const auto result = process->wait();
    EXPECT_EQ(result.exit_code, 128 + GetParam()) << result.err;
    EXPECT_THAT(files(), testing::ElementsAre("scene.exr", "scene.exr.checkpoint", "scene.json", "scene.png", "scene.xml"));
    const auto image = read_exr(folder / "scene.exr");
    const int passes = std::get<int>(image.attributes.at("tyndall.passes"));
    EXPECT_GE(passes, 1);
    EXPECT_LT(passes, 1000000);
    EXPECT_EQ(image.channels.at("samples").values[0], static_cast<float>(passes));
    EXPECT_THAT(file_bytes(folder / "scene.json"), testing::HasSubstr("\"stopped_by\": \"interrupt\""));
}

INSTANTIATE_TEST_SUITE_P(Signals, StoppingBy, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST_F(Program, ASignalEndsALongPassWithinASecond)
{
    // Seconds for a pass.
    const auto arguments = command({"render", "scene.xml", "--method", "path", "--passes", "1000", "--resolution", "512x512", "--max-depth", "-1", "-D", "density=10",
                                    "--layer", "media_to_media", "--progress", "plain"});
    ChildProcess process(arguments, here());
    ASSERT_TRUE(process.wait_for_error_text("pass 1"));
    const auto start = std::chrono::steady_clock::now();
    process.send(SIGTERM);
    ASSERT_TRUE(process.wait_for_error_text("stopping"));
    ASSERT_EQ(process.wait().exit_code, 143);
    // The image is written as well, on a machine that may be busy: under a second where it is not.
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 5);
    EXPECT_EQ(std::get<int>(read_exr(folder / "scene.exr").attributes.at("tyndall.passes")), 1) << "the second pass was abandoned";
}

TEST_F(Program, ASignalBeforeTheFirstPassEndsAtOnceAndWritesNothing)
{
    const auto arguments = command({"render", "scene.xml", "--method", "path", "--passes", "2", "--resolution", "4096x4096", "--layer", "media_to_media", "--progress", "plain"});
    ChildProcess process(arguments, here());
    ASSERT_TRUE(process.wait_for_error_text("rendering"));
    process.send(SIGINT);
    EXPECT_EQ(process.wait(std::chrono::seconds(5)).exit_code, 130);
    EXPECT_THAT(files(), testing::ElementsAre("scene.xml"));
}

TEST_F(Stopping, TwoSignalsEndAtOnceAndWriteNothing)
{
    const auto process = started();
    process->send(SIGSTOP);  // so that both wait for it when it goes on
    process->send(SIGINT), process->send(SIGTERM);
    process->send(SIGCONT);
    const auto result = process->wait(std::chrono::seconds(5));
    EXPECT_THAT(result.exit_code, testing::AnyOf(130, 143)) << result.err;
    EXPECT_THAT(files(), testing::ElementsAre("scene.xml"));
}

TEST_F(Stopping, UserSignalWritesAndGoesOn)
{
    const auto process = started();
    process->send(SIGUSR1);
    ASSERT_TRUE(process->wait_for_error_text("the render goes on"));
    EXPECT_THAT(files(), testing::ElementsAre("scene.exr", "scene.exr.checkpoint", "scene.json", "scene.png", "scene.xml"));
    const auto passes_written = [&] { return std::get<int>(read_exr(folder / "scene.exr").attributes.at("tyndall.passes")); };
    const int passes = passes_written();
    for (int again = 0; again < 400 && passes_written() == passes; ++again) {
        process->send(SIGUSR1);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    EXPECT_GT(passes_written(), passes);
    process->send(SIGTERM);
    EXPECT_EQ(process->wait().exit_code, 143);
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
