#include "comparison/every_dial.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "comparison/judge.hpp"
#include "metrics/block_means.hpp"
#include "synthetic_renderer.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> values_of(const EveryDial& all, const std::string& dial)
{
    std::vector<std::string> names;
    for (const DialSweep& sweep : all.sweeps)
        if (sweep.name == dial)
            for (const std::size_t other : sweep.others) names.push_back(all.candidates[other].name);
    return names;
}

TEST(EveryDial, TurnsOneSettingAtATime)
{
    const EveryDial all = every_dial({}, {.lights = 2048, .selected = 64, .lanes = 8, .sampler = Sampler::paper, .anisotropic = true, .grids = true, .fp64 = true});
    EXPECT_EQ(all.candidates.front().name, "vrl");
    EXPECT_THAT(values_of(all, "sampler"), ElementsAre("vrl · paper-isotropic", "vrl · paper-6", "vrl · table"));
    EXPECT_THAT(values_of(all, "virtual lights per pass"), ElementsAre("vrl · 512 lights", "vrl · 8192 lights"));
    EXPECT_THAT(values_of(all, "of which each pixel meets"), ElementsAre("vrl · 16 chosen", "vrl · 256 chosen", "vrl · all connected"));
    EXPECT_THAT(values_of(all, "lane width"), ElementsAre("vrl · 1 lanes", "vrl · 4 lanes", "vrl · 16 lanes"));
    EXPECT_THAT(values_of(all, "transmittance"), ElementsAre("vrl · exact"));
    EXPECT_THAT(values_of(all, "precision"), ElementsAre("vrl · f64"));
    EXPECT_THAT(values_of(all, "kernel arithmetic"), ElementsAre("vrl · fast"));
    EXPECT_THAT(values_of(all, "clamp of vpl-clamped"), ElementsAre("vpl-clamped · clamp 10", "vpl-clamped · clamp 1000"));
    EXPECT_THAT(values_of(all, "radius of vbl"), ElementsAre("vbl · radius 0.02", "vbl · radius 0.1"));
    EXPECT_THAT(values_of(all, "method"), Contains("path"));
    std::set<std::string> names;
    for (const Candidate& c : all.candidates) EXPECT_TRUE(names.insert(c.name).second) << c.name;
}

TEST(EveryDial, SetsWhatItNamesAndLeavesTheRest)
{
    const EveryDial all = every_dial({.samples_per_pair = 1}, {.fp64 = true});
    const auto named = [&](const std::string& name) { return std::ranges::find(all.candidates, name, &Candidate::name)->settings; };
    EXPECT_EQ(named("vrl · f64").precision, Precision::f64);
    EXPECT_EQ(named("vrl · f64").math, KernelMath::strict);
    EXPECT_EQ(named("vrl · fast").math, KernelMath::fast);
    EXPECT_EQ(named("vrl · 4 samples").samples_per_pair, 4);
    EXPECT_EQ(named("vrl · 16 chosen").selected_lights, 16u);
    EXPECT_EQ(named("vrl · all connected").lights, 2048u) << "as many as by rule, whatever the rule says without a choice";
    EXPECT_EQ(named("vpl-clamped · clamp 10").clamp, 10);
    EXPECT_EQ(named("vpl-clamped · clamp 10").method, Method("vpl-clamped"));
    EXPECT_FALSE(named("vrl").clamp);
}

TEST(EveryDial, LeavesOutWhatMeansTheSameHere)
{
    const EveryDial all = every_dial({}, {.lights = 256, .selected = 256, .lanes = 16});
    EXPECT_THAT(values_of(all, "sampler"), ElementsAre("vrl · table")) << "with isotropic media the product of phase functions is the same program";
    EXPECT_THAT(values_of(all, "precision"), IsEmpty());
    EXPECT_THAT(values_of(all, "transmittance"), IsEmpty());
    EXPECT_THAT(values_of(all, "of which each pixel meets"), ElementsAre("vrl · 64 chosen"));
    EXPECT_THROW((void)every_dial({.method = Method::path}, {}), UsageError);
}

TEST(EveryDial, FewerPairsMakeNarrowerIntervals)
{
    const Reference reference = [] {
        Reference r{.width = film_side, .height = film_side};
        for (std::size_t i = 0; i < film_side * film_side; ++i) r.pixels.push_back(truth(i));
        for (const double mean : block_means(r.pixels, film_side)) r.blocks.push_back({mean});
        return r;
    }();
    const MeasuringHooks hooks{[] { return false; }, [](const std::string&) {}, [] { return 0.; }};
    const auto measured = measure({candidate("a", 0), candidate("b", 1), candidate("c", 1), candidate("d", 1)}, reference, {{2}, 4}, synthetic_renderer({{}, {.noise = .3}}), hooks);
    const std::vector<DialSweep> sweeps{{"noise", "a", 0, {1}}};
    const Judgement of_one = judge(measured, reference, {2}, pairs_of(sweeps)), of_all = judge(measured, reference, {2}, all_pairs(4));
    ASSERT_EQ(of_one.verdicts.size(), 1u);
    ASSERT_EQ(of_all.verdicts.size(), 6u);
    EXPECT_EQ(of_one.verdicts[0].ratio, of_all.verdicts[0].ratio);
    EXPECT_LT(of_one.verdicts[0].high, of_all.verdicts[0].high);
    EXPECT_GT(of_one.verdicts[0].low, of_all.verdicts[0].low);
}

TEST(EveryDial, APriceIsAVerdictSeenFromEitherSide)
{
    Judgement judgement;
    judgement.verdicts = {{.better = 0, .worse = 1, .seconds = 2, .ratio = 4, .low = 2, .high = 8, .significant = true}, {.better = 2, .worse = 0, .seconds = 2, .ratio = 5}};
    const auto dear = price(judgement, 1, 0, 2), cheap = price(judgement, 0, 1, 2), unknown = price(judgement, 0, 2, 2);
    ASSERT_TRUE(dear && cheap && unknown);
    EXPECT_EQ(std::vector({dear->ratio, dear->low, dear->high}), std::vector({4., 2., 8.}));
    EXPECT_EQ(std::vector({cheap->ratio, cheap->low, cheap->high}), std::vector({.25, .125, .5}));
    EXPECT_TRUE(dear->significant && cheap->significant);
    EXPECT_EQ(unknown->ratio, 5);
    EXPECT_EQ(unknown->high, 0) << "one run has no interval";
    EXPECT_FALSE(price(judgement, 1, 0, 6) || price(judgement, 1, 2, 2)) << "nobody asked";
    EXPECT_EQ(value_name("vrl", "vrl · 16 lanes"), "16 lanes");
    EXPECT_EQ(value_name("vrl", "vrlx"), "vrlx");
}

}  // namespace
}  // namespace tyndall::test
