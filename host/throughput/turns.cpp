#include "throughput/turns.hpp"

#include <algorithm>

namespace tyndall {

std::vector<std::vector<double>> seconds_in_turns(std::span<const std::function<void()>> tasks, const TurnPlan& plan, const Clock& clock, const Clock& wall)
{
    std::vector<std::vector<double>> seconds(tasks.size());
    const double start = wall();
    double longest = 0, begin = start;
    for (int round = 0; round < plan.most_rounds; ++round) {
        if (round >= plan.least_rounds && begin + longest - start > plan.seconds) break;
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            const std::size_t task = round % 2 ? tasks.size() - 1 - i : i;
            const double before = clock();
            tasks[task]();
            seconds[task].push_back(clock() - before);
        }
        const double end = wall();
        longest = std::max(longest, end - begin), begin = end;
    }
    return seconds;
}

}  // namespace tyndall
