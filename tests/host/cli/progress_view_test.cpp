#include "cli/progress_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/child_process.hpp"
#include "support/temporary_folder.hpp"

namespace tyndall {
namespace {

Progress after(int done, int wanted, double seconds, double left)
{
    return {.passes_done = done,
            .passes_wanted = wanted,
            .seconds = seconds,
            .seconds_left = left,
            .error = .0124,
            .pairs_per_second = 41.2e6,
            .shadow_segments_per_second = 3.1e6};
}

/// What a view of that style writes.
std::string written(ProgressStyle style, const std::vector<Progress>& steps, int columns = 80)
{
    test::TemporaryFolder folder;
    std::FILE* stream = std::fopen((folder / "out").c_str(), "w");
    {
        ProgressView view(style, stream, columns);
        for (const auto& step : steps) view.show(step);
    }
    std::fclose(stream);
    return test::file_bytes(folder / "out");
}

std::vector<Progress> passes(int count, double seconds_each)
{
    std::vector<Progress> steps;
    for (int i = 1; i <= count; ++i) steps.push_back(after(i, count, i * seconds_each, (count - i) * seconds_each));
    return steps;
}

std::ptrdiff_t lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(ProgressText, NamesPassesRatesErrorAndTimeLeft)
{
    EXPECT_EQ(progress_text(after(3, 16, 5, 12.3)), "pass 3/16, 41.2 M pairs/s, 3.10 M shadow segments/s, error 1.24 %, 12.3 s left");
    Progress first = after(1, 0, 5, 55);
    first.error = -1, first.pairs_per_second = first.shadow_segments_per_second = 0;
    EXPECT_EQ(progress_text(first), "pass 1, error unknown, 55.0 s left");
}

TEST(ShareDone, IsTheNearerOfPassesAndTime)
{
    EXPECT_DOUBLE_EQ(share_done(after(4, 16, 10, 30)), .25);
    EXPECT_DOUBLE_EQ(share_done(after(4, 16, 30, 10)), .75);
    EXPECT_DOUBLE_EQ(share_done(after(4, 0, 1, 3)), .25);
    EXPECT_DOUBLE_EQ(share_done(after(20, 16, 0, 0)), 1);
}

TEST(ProgressView, PlainIsALinePerTenPercent)
{
    const auto text = written(ProgressStyle::plain, passes(1000, .01));
    EXPECT_EQ(lines(text), 11);  // the first pass, then 10 % to 100 %
    EXPECT_EQ(text.find('\r'), std::string::npos);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
}

TEST(ProgressView, PlainIsALinePerThirtySecondsWhenSlower)
{
    auto steps = passes(1000, 10);
    steps.resize(91);  // below the first 10 %
    EXPECT_EQ(lines(written(ProgressStyle::plain, steps)), 1 + 90 / 3);
}

TEST(ProgressView, BarRewritesOneLineWithinTheTerminal)
{
    const auto text = written(ProgressStyle::bar, passes(5, 1), 40);
    EXPECT_EQ(lines(text), 1);  // at the end only
    EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 5);
    EXPECT_EQ(text.find("\x1b[3"), std::string::npos);  // no colour
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, '\r');)
        EXPECT_LE(part.size(), 3u + 39u + 1u) << part;  // erase, text, final line break
}

TEST(ProgressView, BarFillsWithTheShareDone)
{
    EXPECT_NE(written(ProgressStyle::bar, {after(4, 16, 1, 3)}, 200).find("[#####...............] pass 4/16"), std::string::npos);
}

TEST(ProgressView, JsonIsOneObjectPerLine)
{
    auto steps = passes(3, 1);
    steps[0].error = -1;
    std::istringstream text(written(ProgressStyle::json, steps));
    int count = 0;
    for (std::string line; std::getline(text, line); ++count) {
        const auto json = nlohmann::json::parse(line);
        EXPECT_EQ(json.at("event"), "progress");
        EXPECT_EQ(json.at("passes_done"), count + 1);
        EXPECT_EQ(json.at("error").is_null(), count == 0);
    }
    EXPECT_EQ(count, 3);
}

TEST(ProgressView, NoneIsSilent) { EXPECT_EQ(written(ProgressStyle::none, passes(3, 1)), ""); }

}  // namespace
}  // namespace tyndall
