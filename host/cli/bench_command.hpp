#pragma once
/// `tyndall bench` and `tyndall devices --calibrate`: how fast a device evaluates pairs, and which lane width suits it.
#include <string>

#include "throughput/throughput.hpp"

namespace tyndall {

struct BenchCommand {
    ThroughputRequest request;
    bool json = false;
};

/// Measures and prints to standard output, a table or JSON. Throws NoDeviceError, BuildError, DeviceError.
int run_bench(const BenchCommand& command);

/// Measures every lane width of the device, keeps the best for later renders, and prints it with the file that holds it. Throws NoDeviceError, BuildError, DeviceError, IoError.
int run_calibrate(const std::string& device);

}  // namespace tyndall
