#pragma once
/// bench/naive_pairs.cl on a device: the scalar baseline.
#include <memory>
#include <vector>

#include "bench/workload.hpp"
#include "device/device.hpp"

namespace tyndall::bench {

class NaivePairs {
public:
    /// Compiles the kernel and copies the workload to the device. Throws BuildError, DeviceError.
    NaivePairs(Device& device, const Workload& work, std::uint32_t features);
    ~NaivePairs();

    /// Starts the kernel, waits, reads: r, g, b per eye, summed over all lights.
    std::vector<float> sums();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tyndall::bench
