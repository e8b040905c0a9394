#include "resuming_fixture.hpp"

namespace tyndall::test {
namespace {

TEST_F(Resuming, ALongRunSavesEveryThirtySecondsWithoutBeingAsked)
{
    const std::vector<std::string> render{"render", "scene.xml", "--method", "path", "--progress", "none", "-o", "killed.exr", "--time"};
    auto long_one = render, rest = render;
    long_one.emplace_back("10m"), rest.insert(rest.end(), {"1s", "--resume"});
    ChildProcess process(command(long_one), here());
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
    while (!std::filesystem::exists(folder / "killed.exr.checkpoint") && seconds() < 90) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_GT(seconds(), 29);
    process.send(SIGKILL);
    EXPECT_EQ(process.wait().signal, SIGKILL);
    const ProcessResult resumed = run(rest);  // seconds count in all: what there is becomes the image
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_THAT(resumed.err, testing::HasSubstr("going on from killed.exr.checkpoint: "));
    EXPECT_FALSE(std::filesystem::exists(folder / "killed.exr.checkpoint"));
}

TEST_F(Resuming, KilledAtTwentyRandomMomentsGoesOnToTheSameBytes) { expect_killed_renders_go_on_to_the_same_bytes(20); }

}  // namespace
}  // namespace tyndall::test
