#pragma once
/// One launch of each kernel of the roofline page: those of `tyndall bench`, and the estimate that lights are chosen by.
#include <memory>
#include <string>
#include <vector>

#include "device/pair_stage.hpp"
#include "throughput/workload.hpp"

namespace tyndall::bench {

/// measured_kernels() and "estimate".
std::vector<std::string> pair_work_names();

class PairWork {
public:
    /// On the default device, with so many eyes and lights.
    PairWork(const std::string& kernel, int lanes, std::uint32_t eyes, std::uint32_t lights);

    /// Connects (or estimates) all pairs, and waits.
    void run();
    double pairs() const { return double(work_.eyes.size()) * work_.light_count; }

private:
    bool estimates_;
    Workload work_;
    Device device_;
    std::unique_ptr<PairStage> stage_;
};

}  // namespace tyndall::bench
