#pragma once
/// Where the seconds of a render went, in words that mean the same for every method.
#include <string>
#include <vector>

#include "report/report.hpp"

namespace tyndall {

struct StageCost {
    std::string stage;
    double seconds = 0;
};

/// "prepare" (acceleration structures, kernels, pilot), "trace" (light, eye and path tracing), "sample" (where on light and eye, tables included), "shadow", "accumulate",
/// "transfer" (what connecting takes beyond those: copying, waiting, tiles) and "rest" (the film: sums and error estimates). They sum to the report's seconds unless stages overlap in time, in
/// which case the last two are 0.
std::vector<StageCost> stage_costs(const Report& report);

}  // namespace tyndall
