#include "throughput/lane_choice.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace tyndall {

ThroughputRequest lane_request(const std::string& device)
{
    return {.device = device, .kernels = {"henyey_greenstein", "product", "surface_points", "density_grid"}, .baseline = false, .seconds = 5};
}

LaneChoice choose_lanes(const ThroughputResult& result, int by_rule)
{
    std::map<int, std::vector<double>> logs;  // per width and round, summed over kernels
    std::map<int, int> kernels;
    for (const KernelRate& rate : result.rates) {
        if (rate.lanes == 0) continue;
        std::vector<double>& sums = logs[rate.lanes];
        sums.resize(rate.rates.size(), 0.);
        for (std::size_t round = 0; round < sums.size(); ++round) sums[round] += std::log(rate.rates[round]);
        ++kernels[rate.lanes];
    }
    const double unit = spread_of(logs.at(by_rule)).median / kernels.at(by_rule);
    LaneChoice choice{.by_rule = by_rule};
    std::vector<Spread> speeds;
    for (const auto& [lanes, sums] : logs) {
        std::vector<double> values;
        for (const double sum : sums) values.push_back(std::exp(sum / kernels.at(lanes) - unit));
        speeds.push_back(spread_of(values));
        choice.scores.push_back({lanes, speeds.back()});
    }
    const auto best = unbeaten(speeds);
    const bool rule_is_as_fast = std::ranges::any_of(best, [&](std::size_t i) { return choice.scores[i].lanes == by_rule; });
    choice.lanes = rule_is_as_fast ? by_rule : choice.scores[best.front()].lanes;
    choice.rule_is_fastest = rule_is_as_fast && best.size() == 1;
    return choice;
}

}  // namespace tyndall
