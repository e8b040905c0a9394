#include "selftest/check_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tyndall {
namespace {

template <class Real>
std::vector<SelftestLaunch<Real>> planned(int row, const GoldenTable<Real>& table)
{
    std::vector<SelftestLaunch<Real>> launches;
    for (const GoldenSet<Real>& set : table.sets) {
        if (set.row != row) continue;
        auto launch = std::ranges::find(launches, set.sampler, &SelftestLaunch<Real>::sampler);
        if (launch == launches.end()) launch = launches.insert(launch, SelftestLaunch<Real>{.sampler = set.sampler});
        launch->in.push_back(set.in), launch->sets.push_back(&set);
    }
    for (const GoldenMean<Real>& mean : table.means) {
        if (mean.row != row) continue;
        MeanNodes<Real> nodes = mean_nodes(mean.in, mean.panels);
        launches.push_back({.sampler = mean.sampler, .in = std::move(nodes.in), .mean = &mean, .weight = std::move(nodes.weight)});
    }
    return launches;
}

template <class Real>
std::vector<double> widened(const std::array<Real, 14>& in) { return {in.begin(), in.end()}; }

/// Counts one output and keeps the worst; true if it lies in its interval.
template <class Real>
bool count(SelftestOutcome& outcome, Real got, const GoldenOutput<Real>& expected)
{
    ++outcome.outputs;
    const bool holds = expected.holds(got);
    outcome.misses += !holds;
    if (!std::isfinite(got) || !expected.has_value()) return holds;
    const Real value = expected.value, size = std::abs(value), error = std::abs(got - value);
    const Real bound = got > value ? expected.high - value : value - expected.low, widest = std::max(expected.high - value, value - expected.low);
    if (error > 0) outcome.worst_share = std::max(outcome.worst_share, double(error) / double(bound));
    if (widest > 32 * std::numeric_limits<Real>::epsilon() * size) return holds;
    const Real ulp = std::nextafter(size, std::numeric_limits<Real>::infinity()) - size;
    outcome.worst_ulp = std::max(outcome.worst_ulp, double(error / ulp));
    outcome.worst_relative = std::max(outcome.worst_relative, double(error) / double(size));
    return holds;
}

template <class Real>
SelftestMiss miss_of(const char* set, unsigned sampler, const std::array<Real, 14>& in, std::size_t k, double got, const auto& expected)
{
    return {.set = set, .sampler = sampler, .output = k, .got = got, .value = expected.value, .low = expected.low, .high = expected.high, .in = widened(in)};
}

template <class Real>
void judge_mean(SelftestOutcome& outcome, const SelftestLaunch<Real>& launch)
{
    double mean = 0;
    for (std::size_t i = 0; i < launch.in.size(); ++i) mean += launch.weight[i] * double(launch.out[i][0]);
    // The bound is that of Real, so what double's spacing says of the error is left out.
    SelftestOutcome counted;
    if (!count(counted, mean, launch.mean->out) && !outcome.first) {
        outcome.first = miss_of(launch.mean->name, launch.sampler, launch.mean->in, 0, mean, launch.mean->out);
        outcome.first->is_mean = true;
    }
    outcome.outputs += 1, outcome.misses += counted.misses;
    outcome.worst_share = std::max(outcome.worst_share, counted.worst_share);
}

}  // namespace

template <class Real>
std::vector<SelftestLaunch<Real>> evaluate_row(int row, const GoldenTable<Real>& table, const SelftestEvaluator<Real>& evaluate)
{
    std::vector<SelftestLaunch<Real>> launches = planned(row, table);
    for (SelftestLaunch<Real>& launch : launches) launch.out = evaluate(launch.sampler, launch.in);
    return launches;
}

template <class Real>
SelftestOutcome judge_row(int row, const std::vector<SelftestLaunch<Real>>& launches)
{
    SelftestOutcome outcome{.name = std::string(golden_rows()[static_cast<std::size_t>(row)])};
    for (const SelftestLaunch<Real>& launch : launches) {
        if (launch.mean) judge_mean(outcome, launch);
        for (std::size_t i = 0; i < launch.sets.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k) {
                const GoldenSet<Real>& set = *launch.sets[i];
                if (!count(outcome, launch.out[i][k], set.out[k]) && !outcome.first) outcome.first = miss_of(set.name, launch.sampler, set.in, k, launch.out[i][k], set.out[k]);
            }
    }
    return outcome;
}

template std::vector<SelftestLaunch<float>> evaluate_row(int, const GoldenTable<float>&, const SelftestEvaluator<float>&);
template std::vector<SelftestLaunch<double>> evaluate_row(int, const GoldenTable<double>&, const SelftestEvaluator<double>&);
template SelftestOutcome judge_row(int, const std::vector<SelftestLaunch<float>>&);
template SelftestOutcome judge_row(int, const std::vector<SelftestLaunch<double>>&);

std::string sentence_of(const SelftestMiss& miss)
{
    const std::string what = miss.is_mean ? "the mean" : fmt::format("output {}", miss.output);
    return fmt::format("{} of \"{}\" was {:.9g} and not within [{:.9g}, {:.9g}]", what, miss.set, miss.got, miss.low, miss.high);
}

}  // namespace tyndall
