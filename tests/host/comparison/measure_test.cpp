#include "comparison/measure.hpp"

#include <gmock/gmock.h>

#include <set>

#include "synthetic_renderer.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Reference true_reference()
{
    Reference reference{.width = film_side, .height = film_side};
    for (std::size_t i = 0; i < film_side * film_side; ++i) reference.pixels.push_back(truth(i));
    return reference;
}

MeasuringHooks hooks_noting(std::vector<std::string>& notes)
{
    return {[] { return false; }, [&notes](const std::string& note) { notes.push_back(note); }, [] { return 0.; }};
}

TEST(Measure, TakesCandidatesInTurnsAndNeverASeedTwice)
{
    std::vector<std::string> notes;
    const Reference reference = true_reference();
    const auto measured = measure({candidate("a", 0), candidate("b", 1)}, reference, {{1}, 3, 10}, synthetic_renderer({{}, {}}), hooks_noting(notes));
    EXPECT_THAT(notes, ElementsAre("warming up: a", "warming up: b", "run 1 of 3: a", "run 1 of 3: b", "run 2 of 3: b", "run 2 of 3: a", "run 3 of 3: a", "run 3 of 3: b"));
    std::set<std::uint64_t> seeds{10};
    for (const auto& m : measured)
        for (const auto& run : m.runs) EXPECT_TRUE(seeds.insert(run.seed).second) << run.seed;
    EXPECT_EQ(seeds.size(), 7u);
}

TEST(Measure, RunsEndAtTheFirstPassAfterTheLongestTime)
{
    std::vector<std::string> notes;
    const Reference reference = true_reference();
    const auto measured = measure({candidate("a", 0)}, reference, {{1, 2.1}, 1}, synthetic_renderer({{.pass_seconds = .5}}), hooks_noting(notes));
    const auto& run = measured[0].runs[0];
    EXPECT_EQ(run.curve.back().passes, 5);
    EXPECT_DOUBLE_EQ(run.curve.back().seconds, 2.5);
    EXPECT_EQ(run.passes.images(), 5u);
    ASSERT_EQ(run.snapshots.size(), 2u);
    EXPECT_EQ(run.snapshots[0].passes, 2);
    EXPECT_EQ(run.snapshots[1].passes, 4) << "2.0 s is nearer to 2.1 s than 2.5 s";
    EXPECT_DOUBLE_EQ(run.snapshots[1].seconds, 2);
}

TEST(Measure, SnapshotsAreTheImagesOfTheirPasses)
{
    std::vector<std::string> notes;
    const Reference reference = true_reference();
    const auto measured = measure({candidate("a", 0)}, reference, {{1.2}, 1, 7}, synthetic_renderer({{.pass_seconds = .5}}), hooks_noting(notes));
    std::mt19937_64 random(8);
    Film film(film_side, film_side, LayerSet::all());
    for (int pass = 0; pass < 2; ++pass) film.add_pass(synthetic_pass({}, random, pass));
    EXPECT_EQ(measured[0].runs[0].snapshots[0].image, film.beauty());
}

TEST(Measure, WhatRecordingTakesIsTakenOff)
{
    std::vector<std::string> notes;
    const Reference reference = true_reference();
    MeasuringHooks hooks = hooks_noting(notes);
    double now = 0;
    hooks.clock = [&] { return now += .1; };  // every recording takes .1 s, and the synthetic progress counts none of it
    const auto measured = measure({candidate("a", 0)}, reference, {{1}, 1, 1, false}, synthetic_renderer({{.pass_seconds = .5}}), hooks);
    const ErrorCurve& curve = measured[0].runs[0].curve;
    EXPECT_DOUBLE_EQ(curve[0].seconds, .5);
    EXPECT_DOUBLE_EQ(curve[1].seconds, .9);
    EXPECT_DOUBLE_EQ(curve[2].seconds, 1.3);
}

TEST(Measure, AStopKeepsWholeRepeats)
{
    std::vector<std::string> notes;
    const Reference reference = true_reference();
    MeasuringHooks hooks = hooks_noting(notes);
    hooks.stop = [&] { return notes.size() == 6; };  // in the second run of the second repeat
    const auto measured = measure({candidate("a", 0), candidate("b", 1)}, reference, {{1}, 3}, synthetic_renderer({{}, {}}), hooks);
    EXPECT_EQ(measured[0].runs.size(), 1u);
    EXPECT_EQ(measured[1].runs.size(), 1u);
}

TEST(Candidates, AreEveryCombinationWithoutRepeatingMethodsWithoutVirtualLights)
{
    const Dial lights{{{"64 lights", [](RenderSettings& s) { s.lights = 64; }}, {"256 lights", [](RenderSettings& s) { s.lights = 256; }}}};
    const Dial one{{{"paper", [](RenderSettings& s) { s.sampler = Sampler::paper; }}}};
    const auto all = candidates_of({}, {Method::vrl, Method::path}, {one, lights});
    std::vector<std::string> names;
    for (const auto& c : all) names.push_back(c.name);
    EXPECT_THAT(names, ElementsAre("vrl · 64 lights", "vrl · 256 lights", "path"));
    EXPECT_EQ(all[1].settings.lights, 256u);
    EXPECT_EQ(all[1].settings.sampler, Sampler::paper);
    EXPECT_EQ(all[2].settings.method, Method::path);
}

std::string refusal(const std::vector<Method>& methods, const std::vector<Dial>& dials)
{
    try {
        candidates_of({}, methods, dials);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

TEST(Candidates, NoneTwiceAndTooManyAreRefused)
{
    EXPECT_THAT(refusal({}, {}), HasSubstr("names no method"));
    EXPECT_THAT(refusal({Method::vrl, Method::vrl}, {}), HasSubstr("\"vrl\" is asked for twice"));
    Dial many;
    for (int i = 0; i < 17; ++i) many.values.push_back({std::to_string(i), [](RenderSettings&) {}});
    EXPECT_THAT(refusal({Method::vrl}, {many}), HasSubstr("more than 16"));
}

TEST(Reference, FromAFileTellsWhatItsErrorBarIsFor)
{
    ImageFile file{.file = "ref.exr", .width = 16, .height = 8, .pixels = std::vector<Rgb>(128, Rgb(2)), .variance = std::vector<Rgb>(128, Rgb(.04)), .scene_hash = "aa"};
    const Reference alone = reference_from_file(file, true, "aa"), together = reference_from_file(file, false, "bb");
    EXPECT_NEAR(alone.floor, .04 / (4 + .01), 1e-14);
    EXPECT_NEAR(alone.whole.variance, .04 / 128, 1e-15);
    EXPECT_NEAR(alone.blocks.at(1).variance, .04 / 64, 1e-15);
    EXPECT_NEAR(together.whole.variance, .04, 1e-14) << "noise that all pixels share does not average out";
    EXPECT_NEAR(together.blocks.at(1).variance, .04, 1e-14);
    EXPECT_THAT(alone.warnings, testing::IsEmpty());
    EXPECT_THAT(together.warnings, ElementsAre(HasSubstr("another scene")));
    file.variance.clear();
    EXPECT_THAT(reference_from_file(file, true, "aa").warnings, ElementsAre(HasSubstr("counts as exact")));
}

}  // namespace
}  // namespace tyndall::test
