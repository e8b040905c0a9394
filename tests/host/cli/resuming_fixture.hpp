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

    /// Kills a render at `kills` random moments, each at most `longest` seconds after a start from the checkpoint of the one before, then lets it end. False if one ended first.
    bool kill_then_finish(int kills, std::mt19937& random, double longest)
    {
        const auto started = render("killed.exr", {"--checkpoint", ".02s", "--resume"});
        for (int kill = 0; kill < kills; ++kill) {
            ChildProcess process(command(started), here());
            std::this_thread::sleep_for(std::chrono::duration<double>(std::uniform_real_distribution<double>(0, longest)(random)));
            process.send(SIGKILL);
            if (process.wait().exit_code == 0) return false;
            EXPECT_FALSE(std::filesystem::exists(folder / "killed.exr")) << "half a render under the final name";
        }
        const auto result = run(started);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return true;
    }

    double seconds_of(int passes)
    {
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(run(render("whole.exr", {}, passes)).exit_code, 0);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    /// Where a render ends before it was killed so often, the moments lie too far apart: it starts over with them closer together.
    void expect_killed_renders_go_on_to_the_same_bytes(int kills)
    {
        ASSERT_EQ(run(render("whole.exr", {}, 2)).exit_code, 0) << "builds the kernels, which is no part of the times below";
        const double start = seconds_of(2), whole = seconds_of(3000);
        double longest = start + 2 * std::max(whole - start, 0.) / kills;
        std::mt19937 random(std::random_device{}());
        while (!kill_then_finish(kills, random, longest)) {
            expect_same_images();
            std::filesystem::remove(folder / "killed.exr");
            longest /= 2;
        }
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
