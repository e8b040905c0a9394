#pragma once
/// Which lane width suits a device, by what was measured.
#include <vector>

#include "throughput/throughput.hpp"

namespace tyndall {

struct LaneScore {
    int lanes = 0;
    Spread speed;  ///< geometric mean over the kernels of pairs per second, the rule's median being 1
};

struct LaneChoice {
    int lanes = 0, by_rule = 0;
    bool rule_is_fastest = false;  ///< every other width is measured to be slower than the rule's
    std::vector<LaneScore> scores;
};

/// The width of the highest median, unless no difference between it and the rule's was measured: then the rule's. `by_rule` must have been measured.
LaneChoice choose_lanes(const ThroughputResult& result, int by_rule);

/// Everyday kernels at every width: what choose_lanes is asked about.
ThroughputRequest lane_request(const std::string& device);

}  // namespace tyndall
