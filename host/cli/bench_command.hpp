#pragma once
/// `tyndall bench` and `tyndall devices --calibrate`: how fast a device evaluates pairs, and which lane width suits it.
#include <filesystem>
#include <span>
#include <string>

#include "throughput/throughput.hpp"

namespace tyndall {

struct BenchCommand {
    ThroughputRequest request;
    bool usual_lanes = true;                      ///< usual_widths() of the device in place of request.lanes
    bool json = false;
    bool accuracy = false;                        ///< what every dial is worth, instead of kernel throughput
    std::optional<double> seconds;                ///< of measuring; none: 10 for throughput, 300 for accuracy
    int repeats = 8;                              ///< of accuracy: runs of each value
    std::filesystem::path output = "accuracy";    ///< of accuracy: folder for the page
    std::string invocation;                       ///< the command line, quoted for a shell
};

/// Measures and prints to standard output, a table or JSON. Throws NoDeviceError, BuildError, DeviceError.
int run_bench(const BenchCommand& command);

/// The scene of `bench --accuracy`, scenes/forward_fog, which the program carries.
struct BenchScene {
    const char* path;
    const char* text;
    std::size_t size;
};
const std::span<const BenchScene> bench_scenes();

/// Writes the scene into the folder and compares every dial of the default method there, as `compare --dials` does. Throws what run_compare throws.
int run_accuracy(const BenchCommand& command);

/// Measures every lane width of the device, keeps the best for later renders, and prints it with the file that holds it. Throws NoDeviceError, BuildError, DeviceError, IoError.
int run_calibrate(const std::string& device);

}  // namespace tyndall
