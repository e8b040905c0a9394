// Planted truths: what is different is called so, and what is not is not.
#include "comparison/judge.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "synthetic_renderer.hpp"

namespace tyndall::test {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;

const std::vector<double> times{2, 10};

struct Compared {
    Reference reference;
    std::vector<Measurement> measurements;
    Judgement judgement;
};

/// The first method makes the reference, for `reference_seconds`; the others are compared.
Compared compare(const std::vector<SyntheticMethod>& methods, double reference_seconds = 2000, int repeats = 4, std::uint64_t seed = 1)
{
    const RenderFunction render = synthetic_renderer(methods);
    RenderSettings settings;
    settings.seed = seed;
    Compared result{.reference = make_reference(render, settings, reference_seconds, [] { return false; }).reference};
    std::vector<Candidate> candidates;
    for (std::uint32_t i = 1; i < methods.size(); ++i) candidates.push_back(candidate("method " + std::to_string(i), i));
    const MeasuringHooks hooks{[] { return false; }, [](const std::string&) {}, [] { return 0.; }};
    result.measurements = measure(candidates, result.reference, {times, repeats, seed, true}, render, hooks);
    result.judgement = judge(result.measurements, result.reference, times, all_pairs(result.measurements.size()));
    return result;
}

const SyntheticMethod plain{}, exact_reference{.noise = .05};

TEST(Judge, FindsThePlantedError)
{
    const auto result = compare({exact_reference, plain});
    const Summary& summary = result.judgement.summaries[0];
    // relMSE of n passes: mean over values of noise^2 x^2 / (x^2 + e) / n; e is small beside x^2
    double share = 0, mean = 0;
    for (std::size_t i = 0; i < film_side * film_side; ++i) mean += sum(truth(i)) / 3 / (film_side * film_side);
    for (std::size_t i = 0; i < film_side * film_side; ++i)
        for (int c = 0; c < 3; ++c) share += truth(i)[c] * truth(i)[c] / (truth(i)[c] * truth(i)[c] + .0025 * mean * mean) / 3 / (film_side * film_side);
    for (const auto& at : summary.at_times) {
        const double expected = .25 * share / (at.seconds / .25);
        EXPECT_THAT(at.relative_mse->median / expected, DoubleNear(1, .1)) << "1728 values: one run is known to 3.4 %";
        EXPECT_FALSE(at.at_most);
    }
    ASSERT_TRUE(summary.efficiency && summary.slope);
    EXPECT_THAT(summary.efficiency->median * .25 * share * .25, DoubleNear(1, .1));
    EXPECT_THAT(summary.slope->median, DoubleNear(-.5, .03));
    EXPECT_FALSE(summary.bias.significant()) << sentence(summary.bias);
    EXPECT_EQ(summary.runs_with_outliers, 0);
}

TEST(Judge, APlantedBiasOfTwoPercentIsBias)
{
    const auto result = compare({exact_reference, {.bias = .02}, {.noise = .5}});
    const Bias& biased = result.judgement.summaries[0].bias;
    EXPECT_TRUE(biased.significant());
    EXPECT_THAT(biased.relative, DoubleNear(.02, biased.half_width * 1.5));
    EXPECT_THAT(sentence(biased), HasSubstr("biased by +"));
    EXPECT_FALSE(result.judgement.summaries[1].bias.significant());
    EXPECT_THAT(sentence(result.judgement.summaries[1].bias), HasSubstr("no bias found"));
    EXPECT_EQ(result.judgement.summaries[0].runs_with_outliers, 0) << "a bias is no outlier";
}

TEST(Judge, NoiseThatAllPixelsShareIsNotTakenForBias)
{
    int found = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed)
        found += compare({exact_reference, {.noise = .2, .common = .3}}, 200, 2, 1000 * seed).judgement.summaries[0].bias.significant();
    EXPECT_LE(found, 2) << "a rate of .27 %: three of 40 have a probability of 2e-4; pixel scatter would find bias in nearly all";
}

TEST(Judge, APlantedOutlierIsAnOutlier)
{
    const auto result = compare({exact_reference, {.outlier = 300}, plain});
    const Summary& spoilt = result.judgement.summaries[0];
    EXPECT_EQ(spoilt.runs_with_outliers, 4);
    EXPECT_EQ(spoilt.worst_pixel, 100u);
    EXPECT_GT(spoilt.share_of_largest, .2);
    EXPECT_LT(spoilt.trimmed_relative_mse.median, .8 * spoilt.relative_mse.median);
    EXPECT_FALSE(spoilt.bias.significant()) << "an outlier is no bias: " << sentence(spoilt.bias);
    EXPECT_EQ(result.judgement.summaries[1].runs_with_outliers, 0);
}

TEST(Judge, EqualMethodsAreNotToldApart)
{
    int apart = 0, verdicts = 0;
    for (std::uint64_t seed = 0; seed < 40; ++seed)
        for (const Verdict& verdict : compare({exact_reference, plain, plain, plain}, 200, 3, 1000 * seed).judgement.verdicts)
            ++verdicts, apart += verdict.significant;
    EXPECT_EQ(verdicts, 40 * 2 * 3);
    EXPECT_LE(apart, 8) << "of 80 families of three, at most 5 % have a false alarm: more than 8 in all has a probability below 3 %";
}

TEST(Judge, AMethodThatIsTwiceAsGoodIsCalledSo)
{
    const auto result = compare({exact_reference, plain, {.pass_seconds = .125}});
    ASSERT_EQ(result.judgement.verdicts.size(), 2u);
    for (const Verdict& verdict : result.judgement.verdicts) {
        EXPECT_EQ(verdict.better, 1u);
        EXPECT_TRUE(verdict.significant) << sentence(verdict, result.measurements);
        EXPECT_LT(verdict.low, 2);
        EXPECT_GT(verdict.high, 2);
        EXPECT_THAT(sentence(verdict, result.measurements), HasSubstr("times the relMSE of method 2"));
    }
}

TEST(Judge, OneRunEachNeverTellsApart)
{
    const auto result = compare({exact_reference, plain, {.pass_seconds = .05}}, 2000, 1);
    for (const Verdict& verdict : result.judgement.verdicts) {
        EXPECT_FALSE(verdict.significant);
        EXPECT_THAT(sentence(verdict, result.measurements), HasSubstr("no error bar"));
    }
}

TEST(Judge, WhatLiesAtTheReferencesNoiseIsABoundAndNotToldApart)
{
    const auto result = compare({plain, plain, {.pass_seconds = .125}}, 10);  // the reference is no better than what it judges
    for (const Summary& summary : result.judgement.summaries) {
        EXPECT_TRUE(summary.at_times.back().at_most);
        EXPECT_FALSE(summary.efficiency);
        EXPECT_FALSE(summary.slope);
    }
    EXPECT_FALSE(result.judgement.verdicts.back().significant);
    EXPECT_THAT(sentence(result.judgement.verdicts.back(), result.measurements), HasSubstr("reference's own noise"));
}

TEST(Judge, TheReferencesShareIsTakenOff)
{
    const auto result = compare({plain, plain}, 40);  // 160 passes against 8 and 40: a fifth and a quarter on top
    const Summary& summary = result.judgement.summaries[0];
    const ErrorAt& late = summary.at_times.back();
    ASSERT_FALSE(late.at_most);
    EXPECT_THAT(result.reference.floor / late.relative_mse->median, DoubleNear(.25, .04));
    EXPECT_THAT(summary.relative_mse.median / late.relative_mse->median, DoubleNear(1.25, .06));
}

TEST(Judge, ATimeBeforeTheFirstPassHasNoError)
{
    const auto result = compare({exact_reference, {.pass_seconds = 3}, plain});
    EXPECT_FALSE(result.judgement.summaries[0].at_times[0].relative_mse);
    EXPECT_TRUE(result.judgement.summaries[0].at_times[1].relative_mse);
    EXPECT_EQ(result.judgement.verdicts.size(), 1u);
}

}  // namespace
}  // namespace tyndall::test
