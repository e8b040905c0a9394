/// Shards and their merge, as a user runs them: byte-equal to one run, or refused with a reason.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "film/exr.hpp"
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

/// What the scene is rendered with everywhere: 21 passes are six blocks of four, the last of them not full; 25 are seven.
std::vector<std::string> settings(int passes) { return {"scene.xml", "--passes", std::to_string(passes), "--block-passes", "4", "--progress", "none"}; }

class Shards : public Program {
protected:
    std::vector<std::string> with(std::vector<std::string> first, const std::vector<std::string>& more) const
    {
        first.insert(first.end(), more.begin(), more.end());
        return first;
    }

    ProcessResult render(const std::vector<std::string>& more, int other_passes = 0) { return run(with(with({"render"}, settings(other_passes ? other_passes : passes)), more)); }

    void render_whole() { EXPECT_EQ(render({"-o", "whole.exr", "--no-timestamps"}).exit_code, 0); }

    /// Files of the shards of n.
    std::vector<std::string> render_shards(int n, const std::vector<std::string>& more = {})
    {
        std::vector<std::string> names;
        for (int i = 1; i <= n; ++i) {
            names.push_back(fmt::format("part{}.shard", i));
            const auto result = render(with({"--shard", fmt::format("{}/{}", i, n), "-o", names.back()}, more));
            EXPECT_EQ(result.exit_code, 0) << result.err;
            EXPECT_EQ(result.out, names.back() + "\n");
        }
        return names;
    }

    ProcessResult merge(const std::vector<std::string>& names) { return run(with(with({"merge"}, names), {"-o", "merged.exr", "--no-timestamps"})); }

    void expect_merged_like_whole()
    {
        for (const char* ending : {"exr", "png"}) EXPECT_EQ(file_bytes(folder / (std::string("merged.") + ending)), file_bytes(folder / (std::string("whole.") + ending))) << ending;
        EXPECT_FALSE(file_bytes(folder / "merged.exr").empty());
    }

    int passes = 21;

    void expect_refused(const std::vector<std::string>& names, const std::string& reason)
    {
        const auto result = merge(names);
        EXPECT_EQ(result.exit_code, 3) << result.err;
        EXPECT_THAT(result.err, testing::HasSubstr(reason));
        EXPECT_FALSE(std::filesystem::exists(folder / "merged.exr"));
    }
};

/// A report without what the clock, the division into runs and the names of files change.
nlohmann::json without_times(nlohmann::json report)
{
    for (const char* key : {"timings", "stages", "prediction", "seconds_to_error", "outputs", "selftest"}) report.erase(key);
    report["counts"].erase("programs"), report["counts"].erase("launches");
    for (auto& saving : report["savings"]) saving.erase("predicted_processor_seconds");
    return report;
}

TEST_F(Shards, MergedAreByteEqualToOneRun)
{
    passes = 25;  // none of the numbers of shards divides seven blocks
    render_whole();
    for (const int n : {1, 2, 5, 16}) {
        auto names = render_shards(n);
        std::reverse(names.begin(), names.end());  // any order will do
        const auto result = merge(names);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        expect_merged_like_whole();
        const auto json = [&](const char* name) { return without_times(nlohmann::json::parse(file_bytes(folder / name))); };
        EXPECT_EQ(json("merged.json"), json("whole.json")) << n;
    }
}

TEST_F(Shards, OfTwoDivisionsFitTogether)
{
    render_whole();
    ASSERT_EQ(render({"--shard", "1/2", "-o", "half.shard"}).exit_code, 0);
    ASSERT_EQ(render({"--shard", "3/4", "-o", "third.shard"}).exit_code, 0);  // of six blocks: the fourth, after three in the half
    ASSERT_EQ(render({"--shard", "3/3", "-o", "last.shard"}).exit_code, 0);
    const auto result = merge({"half.shard", "third.shard", "last.shard"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    expect_merged_like_whole();
}

TEST_F(Shards, ThatDoNotMakeUpOneRenderAreRefused)
{
    const auto names = render_shards(3);
    expect_refused({names[0], names[2]}, "passes 9 to 16 of 21 are in none of the 2 files");
    expect_refused({names[1], names[2]}, "passes 1 to 8 of 21 are in none");
    expect_refused({names[0], names[1], names[1], names[2]}, "name every shard once");
    const auto other = [&](const std::string& reason, const std::vector<std::string>& more, int other_passes = 0) {
        ASSERT_EQ(render(with({"--shard", "2/3", "-o", "other.shard"}, more), other_passes).exit_code, 0);
        expect_refused({names[0], "other.shard", names[2]}, reason);
    };
    other("seed is 2 here and 1 in part1.shard", {"--seed", "2"});
    other("scene hash is", {"-D", "density=2"});
    other("film is 17 x 12", {"--resolution", "17x12"});
    other("layers is media_to_media here", {"--layer", "media_to_media"});
    other("method is path here and vrl", {"--method", "path"});
    other("lanes is 1 here", {"--lanes", "1"});
    other("passes is 24 here and 21", {}, 24);
}

TEST_F(Shards, ThatAreDamagedAreRefused)
{
    const auto names = render_shards(2);
    const std::string good = file_bytes(folder / names[1]);
    write_file("bad.shard", good.substr(0, good.size() / 2));
    expect_refused({names[0], "bad.shard"}, "bad.shard: is cut short");
    write_file("bad.shard", "");
    expect_refused({names[0], "bad.shard"}, "is no checkpoint or shard");
    write_file("bad.shard", fog_scene);
    expect_refused({names[0], "bad.shard"}, "is no checkpoint or shard");
    expect_refused({names[0], "missing.shard"}, "missing.shard: cannot be read");
    for (const std::size_t at : {std::size_t(30), good.size() / 3, good.size() - 1}) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 1);
        write_file("bad.shard", bad);
        expect_refused({names[0], "bad.shard"}, "is damaged");
    }
    std::string newer = good;
    newer[14] = '2';
    write_file("bad.shard", newer);
    expect_refused({names[0], "bad.shard"}, "another format version");
}

TEST_F(Shards, WrongNumbersAreUsageErrors)
{
    for (const char* wrong : {"17/16", "0/4", "x/y", "4", "1/2/3", "-1/4", "1/0", "1/70000"}) {
        const auto result = render({"--shard", wrong});
        EXPECT_EQ(result.exit_code, 2) << wrong;
        EXPECT_THAT(result.err, testing::HasSubstr("--shard"));
    }
    EXPECT_EQ(run({"render", "scene.xml", "--shard", "1/2", "--time", "1s"}).exit_code, 2);
    EXPECT_EQ(render({"--shard", "1/2", "-o", "a.exr"}).exit_code, 2);
    EXPECT_EQ(run({"merge", "-o", "a.exr"}).exit_code, 2);
    EXPECT_EQ(run({"merge", "a.shard"}).exit_code, 2);
}

}  // namespace
}  // namespace tyndall::test
