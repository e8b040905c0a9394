/// Renders that are killed and go on: byte-equal to those that nothing happened to, or refused with a reason.
#include <fmt/format.h>

#include "film/exr.hpp"
#include "resuming_fixture.hpp"

namespace tyndall::test {
namespace {

TEST_F(Resuming, KilledAtRandomMomentsGoesOnToTheSameBytes) { expect_killed_renders_go_on_to_the_same_bytes(4); }

TEST_F(Resuming, AfterASignalNoPassIsLostAndTheReportCountsAllOfThem)
{
    stop_early();
    const int before = std::get<int>(read_exr(folder / "killed.exr").attributes.at("tyndall.passes"));
    const auto result = run(render("killed.exr", {"--resume"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, testing::HasSubstr(fmt::format("{} passes are done", before)));
    ASSERT_EQ(run(render("whole.exr")).exit_code, 0);
    expect_same_images();
    EXPECT_FALSE(std::filesystem::exists(folder / "killed.exr.checkpoint"));
}

TEST_F(Resuming, MorePassesMayFollowThanWereAskedForFirst)
{
    stop_early();
    ASSERT_EQ(run(render("killed.exr", {"--resume"}, 3500)).exit_code, 0);
    ASSERT_EQ(run(render("whole.exr", {}, 3500)).exit_code, 0);
    expect_same_images();
}

TEST_F(Resuming, AShardGoesOnToo)
{
    const auto shard = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"--shard", "2/3"});
        return render("part.shard", more);
    };
    ASSERT_EQ(run(shard({})).exit_code, 0);
    const auto whole = file_bytes(folder / "part.shard");
    std::filesystem::remove(folder / "part.shard");
    {
        ChildProcess process(command(shard({"--checkpoint", ".02s"})), here());
        ASSERT_TRUE(process.wait_for_error_text("pass 1"));
        process.send(SIGTERM);
        ASSERT_EQ(process.wait().exit_code, 143);
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "part.shard"));
    const auto merged = run({"merge", "part.shard.checkpoint", "-o", "m.exr"});
    EXPECT_EQ(merged.exit_code, 3);
    EXPECT_THAT(merged.err, testing::HasSubstr("is not finished"));
    ASSERT_EQ(run(shard({"--resume"})).exit_code, 0);
    for (const char* number : {"1/3", "3/3"}) ASSERT_EQ(run(render(fmt::format("part{}.shard", number[0]), {"--shard", number})).exit_code, 0);
    ASSERT_EQ(run({"merge", "part1.shard", "part.shard", "part3.shard", "-o", "killed.exr", "--no-timestamps"}).exit_code, 0);
    ASSERT_EQ(run(render("whole.exr")).exit_code, 0);
    expect_same_images();
    EXPECT_FALSE(whole.empty());
}

TEST_F(Resuming, OtherCheckpointsAreRefused)
{
    stop_early();
    const auto refused = [&](const std::string& reason, std::vector<std::string> more, int lights = 16) {
        more.push_back("--resume");
        const auto result = run(render("killed.exr", more, 3000, lights));
        EXPECT_EQ(result.exit_code, 3) << result.err;
        EXPECT_THAT(result.err, testing::HasSubstr(reason));
    };
    refused("seed is 7 here and 1 in killed.exr.checkpoint", {"--seed", "7"});
    refused("scene hash is", {"-D", "density=3"});
    refused("film is 20 x 12", {"--resolution", "20x12"});
    refused("lights is", {}, 32);
    refused("block of passes is 9 here and 8", {"--block-passes", "9"});
    const std::string good = file_bytes(folder / "killed.exr.checkpoint");
    write_file("killed.exr.checkpoint", good.substr(0, good.size() - 7));
    refused("is cut short", {});
    write_file("killed.exr.checkpoint", good + "x");
    refused("is damaged", {});
    write_file("killed.exr.checkpoint", "");
    refused("is no checkpoint", {});
    ASSERT_EQ(run(render("part.shard", {"--shard", "1/2"})).exit_code, 0);
    std::filesystem::copy_file(folder / "part.shard", folder / "killed.exr.checkpoint", std::filesystem::copy_options::overwrite_existing);
    refused("is of shard 1/2", {});
}

TEST_F(Resuming, WithoutACheckpointItStartsFromTheBeginning)
{
    const auto result = run({"render", "scene.xml", "--passes", "2", "--resume", "--progress", "none"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, testing::HasSubstr("starting with the first pass"));
}

TEST_F(Resuming, AShortRunLeavesNoCheckpoint)
{
    EXPECT_EQ(run({"render", "scene.xml", "--passes", "2"}).exit_code, 0);
    EXPECT_THAT(files(), testing::ElementsAre("scene.exr", "scene.json", "scene.png", "scene.xml"));
}

TEST_F(Resuming, AFullDiskKeepsTheOldFilesAndLeavesNoPart)
{
    stop_early({"--method", "path"});
    const auto old_image = file_bytes(folder / "killed.exr"), old_checkpoint = file_bytes(folder / "killed.exr.checkpoint");
    auto setup = here();
    setup.file_size_limit = 4096;
    const auto result = run(render("killed.exr", {"--method", "path", "--resume", "--checkpoint", ".02s"}), setup);
    EXPECT_EQ(result.exit_code, 6) << result.err;
    EXPECT_THAT(result.err, testing::HasSubstr("no checkpoint could be written, the render goes on without"));
    EXPECT_EQ(file_bytes(folder / "killed.exr"), old_image);
    EXPECT_EQ(file_bytes(folder / "killed.exr.checkpoint"), old_checkpoint);
    EXPECT_THAT(files(), testing::ElementsAre("killed.exr", "killed.exr.checkpoint", "killed.json", "killed.png", "scene.xml"));
}

TEST_F(Resuming, ADeviceAsCheckpointIsLeftAlone)
{
    std::filesystem::create_symlink("/dev/full", folder / "killed.exr.checkpoint");
    ChildProcess process(command(render("killed.exr")), here());
    ASSERT_TRUE(process.wait_for_error_text("pass 1"));
    process.send(SIGTERM);
    const auto result = process.wait();
    EXPECT_EQ(result.exit_code, 6) << result.err;
    EXPECT_THAT(result.err, testing::HasSubstr("is not a regular file"));
    EXPECT_FALSE(file_bytes(folder / "killed.exr").empty()) << "the image found room";
}

}  // namespace
}  // namespace tyndall::test
