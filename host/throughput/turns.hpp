#pragma once
/// Measuring things in turns, so that a disturbance of the machine meets all of them alike.
#include <functional>
#include <span>
#include <vector>

#include "throughput/clocks.hpp"

namespace tyndall {

struct TurnPlan {
    int least_rounds = 5, most_rounds = 15;
    double seconds = 10;  ///< on the wall; after the least number of rounds none begins that would end later
};

/// Runs every task once per round, in every other round from the last to the first. Returns [task][round], the time that `clock` says the task took; `wall` decides when to stop.
std::vector<std::vector<double>> seconds_in_turns(std::span<const std::function<void()>> tasks, const TurnPlan& plan, const Clock& clock, const Clock& wall);

}  // namespace tyndall
