#pragma once
/// Timed runs of every candidate, taken in turns, so that a disturbance of the machine meets all alike.
#include <functional>
#include <string>
#include <vector>

#include "comparison/candidate.hpp"
#include "comparison/recorder.hpp"

namespace tyndall {

struct MeasuringPlan {
    std::vector<double> times;  ///< seconds, ascending, not empty
    int repeats = 3;            ///< runs of each candidate
    std::uint64_t seed = 1;     ///< run r of candidate c of n has the seed `seed` + 1 + r n + c: no two runs share their noise, and none the reference's
    bool warm_up = true;        ///< one pass of each first, not counted: compiles kernels into the driver's cache, loads libraries
};

struct Measurement {
    Candidate candidate;
    std::vector<Run> runs;
};

struct MeasuringHooks {
    std::function<bool()> stop;                         ///< asked after every pass
    std::function<void(const std::string&)> note;       ///< told what comes next
    RunRecorder::Clock clock;
};

/// All candidates in the order given, every repeat starting with another one. After a stop the repeats that every candidate has finished remain; there may be none. Seconds count from
/// the start of a render: acceleration structures and kernels from the cache included, reading the scene and recording left out.
std::vector<Measurement> measure(const std::vector<Candidate>& candidates, const Reference& reference, const MeasuringPlan& plan, const RenderFunction& render, const MeasuringHooks& hooks);

}  // namespace tyndall
