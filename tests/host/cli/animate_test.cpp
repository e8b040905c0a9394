/// `tyndall animate`: a render per frame, each as `tyndall render` makes it, and nothing twice.
#include <csignal>

#include <fmt/format.h>

#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;

class Animate : public Program {
protected:
    /// The fog scene whose light moves with the frame.
    Animate()
    {
        std::string scene = fog_scene;
        scene.insert(scene.find("<integrator"), "<default name=\"frame\" value=\"0\"/><default name=\"height\" value=\"1\"/>");
        const std::string place = R"(x="0" y="1" z="0")";
        scene.replace(scene.find(place), place.size(), R"(x="$frame" y="$height" z="0")");
        write_file("moving.xml", scene);
    }
    std::vector<std::string> animate(std::vector<std::string> more, const std::string& frames = "0:3") const
    {
        const std::vector<std::string> all{"animate", "moving.xml", "--frames", frames, "-o", "frames", "--passes", "2", "--lights", "16", "--no-timestamps", "--progress", "none"};
        more.insert(more.begin(), all.begin(), all.end());
        return more;
    }
    std::string image(const std::string& name) const { return file_bytes(folder / name); }
    std::string frame(int number) const { return image(fmt::format("frames/frame_{:04}.exr", number)); }
    std::filesystem::file_time_type written(int number) const { return std::filesystem::last_write_time(folder / fmt::format("frames/frame_{:04}.exr", number)); }
    /// What `tyndall render` makes with these options.
    std::string render(std::vector<std::string> more)
    {
        const std::vector<std::string> all{"render", "moving.xml", "-o", "one.exr", "--passes", "2", "--lights", "16", "--no-timestamps", "--progress", "none"};
        more.insert(more.begin(), all.begin(), all.end());
        const auto result = run(more);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return image("one.exr");
    }
};

TEST_F(Animate, EveryFrameIsWhatRenderMakesOfItsValues)
{
    const auto result = run(animate({}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("frames/frame_0002.exr\n"));
    for (const int number : {0, 1, 2}) EXPECT_EQ(frame(number), render({"-D", fmt::format("frame={}", number), "--seed", std::to_string(1 + number)})) << number;
    for (const char* ending : {"png", "json", "done"}) EXPECT_TRUE(std::filesystem::exists(folder / (std::string("frames/frame_0001.") + ending))) << ending;
    EXPECT_FALSE(std::filesystem::exists(folder / "frames/frame_0003.exr"));
}

TEST_F(Animate, FixedSeedsAndOtherValues)
{
    ASSERT_EQ(run(animate({"--seed-per-frame", "fixed", "--seed", "5", "--vary", "height=1:-.25", "--vary", "density=.5:.5"}, "1:3")).exit_code, 0);
    EXPECT_EQ(frame(2), render({"-D", "height=0.5", "-D", "density=1.5", "--seed", "5"}));
    EXPECT_NE(frame(1), frame(2));
    EXPECT_FALSE(std::filesystem::exists(folder / "frames/frame_0000.exr"));
}

TEST_F(Animate, FramesThatAreDoneAreNotRenderedAgain)
{
    ASSERT_EQ(run(animate({}, "0:2")).exit_code, 0);
    const auto zero = written(0);
    std::filesystem::remove(folder / "frames/frame_0001.png");
    const auto result = run(animate({"--threads", "1"}, "0:3"));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("1 of 3 frames were done before"));
    EXPECT_EQ(written(0), zero);
    EXPECT_TRUE(std::filesystem::exists(folder / "frames/frame_0001.png")) << "a frame without its picture is not done";
}

TEST_F(Animate, OtherOptionsSceneOrHalfAFileMeanAnotherRender)
{
    ASSERT_EQ(run(animate({}, "0:1")).exit_code, 0);
    const std::string first = frame(0);
    ASSERT_EQ(run(animate({"--max-depth", "2"}, "0:1")).exit_code, 0);
    EXPECT_NE(frame(0), first);
    ASSERT_EQ(run(animate({}, "0:1")).exit_code, 0);
    EXPECT_EQ(frame(0), first);
    std::filesystem::resize_file(folder / "frames/frame_0000.exr", 100);
    ASSERT_EQ(run(animate({}, "0:1")).exit_code, 0);
    EXPECT_EQ(frame(0), first);
    std::string scene = image("moving.xml");
    scene.replace(scene.find("3, 2, 1"), 7, "3, 2, 2");
    write_file("moving.xml", scene);
    ASSERT_EQ(run(animate({}, "0:1")).exit_code, 0);
    EXPECT_NE(frame(0), first);
}

TEST_F(Animate, AStoppedFrameGoesOnFromItsCheckpoint)
{
    const std::vector<std::string> slow{"animate", "moving.xml", "--frames", "0:2", "-o", "frames", "--passes", "1500", "--lights", "16", "--no-timestamps", "--progress", "plain"};
    {
        ChildProcess process(command(slow), here());
        ASSERT_TRUE(process.wait_for_error_text("pass 1"));
        process.send(SIGTERM);
        ASSERT_EQ(process.wait().exit_code, 143);
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "frames/frame_0000.exr.checkpoint"));
    EXPECT_FALSE(std::filesystem::exists(folder / "frames/frame_0000.done"));
    const auto result = run(slow);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, HasSubstr("going on from frames/frame_0000.exr.checkpoint"));
    EXPECT_FALSE(std::filesystem::exists(folder / "frames/frame_0000.exr.checkpoint"));
    EXPECT_TRUE(std::filesystem::exists(folder / "frames/frame_0001.done"));
}

TEST_F(Animate, AFolderMeansItsSceneAndTheTargetErrorThatWasMissedIsTold)
{
    write_file("scene.xml", image("moving.xml"));
    const auto result = run({"animate", ".", "--frames", "0:1", "--passes", "2", "--lights", "16", "--target-error", "0.01%", "--progress", "none", "-o", "out"});
    EXPECT_EQ(result.exit_code, 7) << result.err;
    EXPECT_TRUE(std::filesystem::exists(folder / "out/frame_0000.png"));
}

TEST_F(Animate, WhatMakesNoSenseIsRefused)
{
    const std::pair<std::vector<std::string>, const char*> cases[] = {{{"--frames", "3"}, "--frames \"3\" must be FIRST:END, for example 0:24"},
                                                                     {{"--frames", "3:3"}, "has no frame"},
                                                                     {{"--frames", "-1:3"}, "--frames"},
                                                                     {{"--frames", "0:2", "--vary", "height"}, "--vary"},
                                                                     {{"--frames", "0:2", "--vary", "height=1"}, "must be NAME=START:STEP"},
                                                                     {{"--frames", "0:2", "--vary", "height=1:2", "-D", "height=3"}, "\"height\" is given by -D and by --vary"},
                                                                     {{"--frames", "0:2", "-D", "frame=3"}, "leave -D frame out"},
                                                                     {{"--frames", "0:2", "--seed-per-frame", "random"}, "--seed-per-frame"},
                                                                     {{"--frames", "0:2", "--shard", "1/2"}, "--shard divides one image"},
                                                                     {{"--frames", "0:2", "--report", "r.json"}, "--report names one file"},
                                                                     {{"--frames", "0:2", "-o", "a.exr"}, "-o is the folder of the frames"}};
    for (const auto& [options, message] : cases) {
        std::vector<std::string> arguments{"animate", "moving.xml", "--passes", "1"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 2) << message;
        EXPECT_THAT(result.err, HasSubstr(message));
    }
    EXPECT_EQ(files(), (std::vector<std::string>{"moving.xml", "scene.xml"}));
    const auto still = run({"animate", "scene.xml", "--frames", "0:2", "--passes", "1"});
    EXPECT_EQ(still.exit_code, 3) << "nothing in the scene is called frame";
    EXPECT_THAT(still.err, HasSubstr("frame"));
}

}  // namespace
}  // namespace tyndall::test
