#pragma once
/// Renders of some thousand short passes that are killed and go on.
#include <csignal>
#include <random>
#include <thread>

#include "program_fixture.hpp"

namespace tyndall::test {

class Resuming : public Program {
protected:
    std::vector<std::string> render(const std::string& output, std::vector<std::string> more = {}, int passes = 3000, int lights = 16) const
    {
        more.insert(more.begin(), {"render", "scene.xml", "--passes", std::to_string(passes), "--lights", std::to_string(lights), "--no-timestamps", "--progress", "plain", "-o", output});
        return more;
    }

    void expect_same_images()
    {
        EXPECT_EQ(file_bytes(folder / "killed.exr"), file_bytes(folder / "whole.exr"));
        EXPECT_EQ(file_bytes(folder / "killed.png"), file_bytes(folder / "whole.png"));
    }

    /// Kills a render at random moments until one ends by itself; every one goes on from the checkpoint of the one before. Returns how many were killed.
    int kill_until_done(int most, std::mt19937& random, double longest)
    {
        for (int kills = 0; kills < most; ++kills) {
            ChildProcess process(command(render("killed.exr", {"--checkpoint", ".02s", "--resume"})), here());
            std::this_thread::sleep_for(std::chrono::duration<double>(std::uniform_real_distribution<double>(0, longest)(random)));
            process.send(SIGKILL);
            if (process.wait().exit_code == 0) return kills;
            EXPECT_FALSE(std::filesystem::exists(folder / "killed.exr")) << "half a render under the final name";
        }
        const auto result = run(render("killed.exr", {"--checkpoint", ".02s", "--resume"}));
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return most;
    }

    void expect_killed_renders_go_on_to_the_same_bytes(int most)
    {
        const auto start = std::chrono::steady_clock::now();
        ASSERT_EQ(run(render("whole.exr")).exit_code, 0);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        std::mt19937 random(std::random_device{}());
        EXPECT_GT(kill_until_done(most, random, seconds / 2), most / 2);
        expect_same_images();
        EXPECT_FALSE(std::filesystem::exists(folder / "killed.exr.checkpoint"));
    }

    /// A checkpoint of some passes of killed.exr.
    void stop_early(const std::vector<std::string>& more = {})
    {
        ChildProcess process(command(render("killed.exr", more)), here());
        ASSERT_TRUE(process.wait_for_error_text("pass 1"));
        process.send(SIGINT);
        ASSERT_EQ(process.wait().exit_code, 130);
        ASSERT_TRUE(std::filesystem::exists(folder / "killed.exr.checkpoint"));
    }
};

}  // namespace tyndall::test
