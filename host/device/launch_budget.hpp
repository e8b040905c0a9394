#pragma once
/// How much a launch may hold so that it ends in time: a driver that draws a desktop resets a device that is busy for seconds, and nothing can stop a kernel that runs.
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>

namespace tyndall {

/// Sizes of launches from what earlier launches of the same kernel took. Work is counted in whatever a kernel's items are made of: pairs, estimates, records.
class LaunchBudget {
public:
    /// Of a kernel's first launch, when nothing is known: 3 ms at 100 M pairs/s, a quarter of a second on a device a hundred times slower.
    static constexpr double first_work = 1u << 18;
    /// Launches aim at this share of the bound, because places differ.
    static constexpr double aim = .5;

    explicit LaunchBudget(double most_seconds) : most_seconds_(most_seconds) {}

    bool knows(const std::string& kernel) const { return seconds_per_work_.count(kernel) > 0; }

    /// Items of so much work for the next launch, 1 ... wanted; a multiple of 8 if there are more than 8 and more will follow.
    std::uint32_t items(const std::string& kernel, std::uint32_t wanted, double work_per_item) const
    {
        const auto known = seconds_per_work_.find(kernel);
        const double work = known == seconds_per_work_.end() ? first_work : aim * most_seconds_ / known->second;
        const double most = std::max(work / std::max(work_per_item, 1.), 1.);
        if (most >= wanted) return wanted;
        const auto fit = static_cast<std::uint32_t>(most);
        return fit < 8 ? fit : fit / 8 * 8;
    }

    /// A dearer launch counts at once, a cheaper one by a quarter: the next may be as dear again.
    void measured(const std::string& kernel, double work, double seconds)
    {
        if (!(seconds > 0) || !(work > 0)) return;
        const double now = seconds / work;
        const auto [entry, is_new] = seconds_per_work_.try_emplace(kernel, now);
        if (!is_new) entry->second = std::max(now, .75 * entry->second + .25 * now);
    }

private:
    double most_seconds_;
    std::map<std::string, double> seconds_per_work_;
};

}  // namespace tyndall
