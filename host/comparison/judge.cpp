#include "comparison/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tyndall {
namespace {

constexpr double twice_the_floor = 2;  ///< below it, more than half of what is measured is the reference's noise

template <class Value>
Spread spread_over(const std::vector<Run>& runs, Value&& value)
{
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(value(run));
    return spread_of(values);
}

ErrorAt error_at(const std::vector<Run>& runs, double seconds, double floor)
{
    ErrorAt at{.seconds = seconds};
    std::vector<double> measured;
    for (const Run& run : runs)
        if (const auto value = relative_mse_at(run.curve, seconds)) measured.push_back(*value);
    if (measured.size() < runs.size()) return at;
    at.at_most = std::ranges::any_of(measured, [&](double value) { return value < twice_the_floor * floor; });
    if (!at.at_most)
        for (double& value : measured) value -= floor;
    at.relative_mse = spread_of(measured);
    return at;
}

/// From the slowest first pass to the longest time, some 24 points, and the wanted times.
std::vector<double> grid(const std::vector<Run>& runs, const std::vector<double>& times)
{
    constexpr int intervals = 24;
    double first = 0;
    for (const Run& run : runs) first = std::max(first, run.curve.front().seconds);
    std::vector<double> all(times);
    if (first < times.back())
        for (int i = 0; i < intervals; ++i) all.push_back(first * std::pow(times.back() / first, double(i) / intervals));
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

void add_convergence(Summary& summary, const std::vector<Run>& runs, double floor)
{
    std::vector<double> slopes;
    for (const Run& run : runs)
        if (const auto slope = convergence_slope(run.curve, floor)) slopes.push_back(*slope);
    if (slopes.size() == runs.size()) summary.slope = spread_of(slopes);
    const ErrorAt& last = summary.at_times.back();
    if (!last.relative_mse || last.at_most || !(last.relative_mse->low > 0)) return;
    const auto efficiency = [&](double relative_mse) { return 1 / (relative_mse * last.seconds); };
    summary.efficiency = Spread{efficiency(last.relative_mse->median), efficiency(last.relative_mse->high), efficiency(last.relative_mse->low)};
}

void add_outliers(Summary& summary, const std::vector<Run>& runs)
{
    for (const Run& run : runs) {
        summary.runs_with_outliers += run.last.has_outliers();
        if (run.last.share_of_largest > summary.share_of_largest) summary.share_of_largest = run.last.share_of_largest, summary.worst_pixel = run.last.worst_pixel;
    }
}

Summary summary_of(const std::vector<Run>& runs, const Reference& reference, const std::vector<double>& times)
{
    Summary summary;
    for (const double time : times) summary.at_times.push_back(error_at(runs, time, reference.floor));
    for (const double time : grid(runs, times))
        if (const ErrorAt at = error_at(runs, time, reference.floor); at.relative_mse) summary.curve.push_back(at);
    BlockStatistics passes;
    for (const Run& run : runs) passes.merge(run.passes);
    summary.bias = bias_of(passes.whole(), reference.whole);
    summary.blocks = block_bias(passes, reference.blocks);
    summary.rmse = spread_over(runs, [](const Run& run) { return run.last.rmse; });
    summary.relative_mse = spread_over(runs, [](const Run& run) { return run.last.relative_mse; });
    summary.trimmed_relative_mse = spread_over(runs, [](const Run& run) { return run.last.trimmed_relative_mse; });
    summary.seconds_per_pass = spread_over(runs, [](const Run& run) { return run.curve.back().seconds / run.curve.back().passes; });
    add_convergence(summary, runs, reference.floor);
    add_outliers(summary, runs);
    return summary;
}

/// Mean and spread of log relMSE over the runs at that time; nothing where only a bound is known.
std::optional<MeanEstimate> log_error(const std::vector<Run>& runs, double seconds, double floor)
{
    RunningMean mean;
    for (const Run& run : runs) {
        const auto value = relative_mse_at(run.curve, seconds);
        if (!value || *value < twice_the_floor * floor || !(*value > 0)) return std::nullopt;
        mean.add(std::log(*value - floor));
    }
    return mean.estimate();
}

/// `a` has the lower mean log relMSE, or where that is unknown, any of the two.
Verdict verdict_of_pair(std::size_t a, std::size_t b, const std::vector<Measurement>& all, const Judgement& judgement, std::size_t time, double floor, std::size_t pairs)
{
    const ErrorAt &of_a = judgement.summaries[a].at_times[time], &of_b = judgement.summaries[b].at_times[time];
    Verdict verdict{.better = a, .worse = b, .seconds = of_a.seconds, .ratio = of_b.relative_mse->median / of_a.relative_mse->median};
    const auto log_a = log_error(all[a].runs, of_a.seconds, floor), log_b = log_error(all[b].runs, of_a.seconds, floor);
    if (!log_a || !log_b || log_a->degrees == 0 || log_b->degrees == 0) {
        if (verdict.ratio < 1) std::swap(verdict.better, verdict.worse), verdict.ratio = 1 / verdict.ratio;
        return verdict;
    }
    const MeanEstimate difference{log_b->value - log_a->value, log_a->variance + log_b->variance, welch_degrees(*log_a, *log_b)};
    if (difference.value < 0) return verdict_of_pair(b, a, all, judgement, time, floor, pairs);
    const double width = half_width(difference, 1 - .05 / static_cast<double>(pairs));  // Bonferroni: all intervals of a time hold together
    verdict.ratio = std::exp(difference.value), verdict.low = std::exp(difference.value - width), verdict.high = std::exp(difference.value + width);
    verdict.significant = verdict.low > 1;
    return verdict;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> all_pairs(std::size_t candidates)
{
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < candidates; ++a)
        for (std::size_t b = a + 1; b < candidates; ++b) pairs.emplace_back(a, b);
    return pairs;
}

Judgement judge(const std::vector<Measurement>& measurements, const Reference& reference, const std::vector<double>& times, const std::vector<std::pair<std::size_t, std::size_t>>& pairs)
{
    Judgement judgement;
    for (const Measurement& measurement : measurements) judgement.summaries.push_back(summary_of(measurement.runs, reference, times));
    const auto known = [&](std::size_t c, std::size_t t) { return judgement.summaries[c].at_times[t].relative_mse.has_value(); };
    for (std::size_t t = 0; t < times.size(); ++t)
        for (const auto& [a, b] : pairs)
            if (known(a, t) && known(b, t)) judgement.verdicts.push_back(verdict_of_pair(a, b, measurements, judgement, t, reference.floor, pairs.size()));
    return judgement;
}

std::optional<Price> price(const Judgement& judgement, std::size_t of, std::size_t beside, double seconds)
{
    for (const Verdict& v : judgement.verdicts) {
        if (v.seconds != seconds) continue;
        if (v.worse == of && v.better == beside) return Price{v.ratio, v.low, v.high, v.significant};
        if (v.better == of && v.worse == beside) return v.high > 0 ? Price{1 / v.ratio, 1 / v.high, 1 / v.low, v.significant} : Price{1 / v.ratio, 0, 0, false};
    }
    return {};
}

std::string sentence(const Verdict& verdict, const std::vector<Measurement>& measurements)
{
    const std::string &better = measurements[verdict.better].candidate.name, &worse = measurements[verdict.worse].candidate.name;
    if (verdict.high <= 0)
        return fmt::format("{} and {} at {:g} s: no error bar, from one run each or from errors at the reference's own noise", better, worse, verdict.seconds);
    const auto interval = fmt::format("{:.3g} ({:.3g} to {:.3g})", verdict.ratio, verdict.low, verdict.high);
    if (!verdict.significant) return fmt::format("{} and {} at {:g} s: the bars do not tell them apart, ratio {}", better, worse, verdict.seconds, interval);
    return fmt::format("{} has {} times the relMSE of {} at {:g} s", worse, interval, better, verdict.seconds);
}

std::string sentence(const Bias& bias)
{
    if (!std::isfinite(bias.half_width)) return "unknown: too few passes for an error bar";
    const auto value = fmt::format("{:+.2f} % ± {:.2f} %", 100 * bias.relative, 100 * bias.half_width);
    return bias.significant() ? fmt::format("biased by {} (z {:.1f})", value, bias.z) : fmt::format("no bias found: {} (z {:.1f})", value, bias.z);
}

}  // namespace tyndall
