#pragma once
/// Pairs per second of the fused kernels at every lane width, beside the scalar kernel, in turns.
#include <optional>
#include <string>
#include <vector>

#include "device/device_list.hpp"
#include "throughput/spread.hpp"

namespace tyndall {

/// What is measured. one: processor time while the device has one core of the processor (of other devices: the time on the wall); all: the time on the wall with
/// everything that the device has.
enum class Cores { one, all };

struct ThroughputRequest {
    std::string device;                  ///< as choose_device takes it
    std::vector<int> lanes{1, 4, 8, 16};
    std::vector<std::string> kernels;    ///< names of measured_kernels(); empty: all
    bool baseline = true;                ///< the scalar kernel too
    int default_lanes = 0;               ///< that the speed-up is told for; 0: by rule
    Cores cores = Cores::one;
    double seconds = 10;                 ///< of measuring; building comes before
};

/// The widths to measure where nobody names any: all on CPUs; elsewhere 1 and 4, for wider ones are slower there and their compilers take a minute over them.
std::vector<int> usual_widths(const DeviceInfo& device);

/// One kernel at one lane width.
struct KernelRate {
    std::string kernel;
    int lanes = 0;                       ///< 0: the scalar kernel
    std::vector<double> rates;           ///< pairs per second, one per round; rounds of all kernels took place together
    Spread pairs_per_second;
};

struct ThroughputResult {
    DeviceInfo device;
    Cores cores = Cores::one;
    bool processor_time = true;          ///< false: by the clock on the wall
    int default_lanes = 0, rounds = 0;
    double build_seconds = 0, seconds = 0;  ///< on the wall
    std::vector<KernelRate> rates;
    std::optional<double> agreeing;      ///< least share of sums that agree with the scalar kernel's within 1 %; none: no scalar kernel
};

/// Builds, warms up and measures. Call it before any other OpenCL call of the process if one core is wanted. Throws NoDeviceError, BuildError, and DeviceError if a kernel computes
/// something else than the scalar kernel.
ThroughputResult measure_throughput(const ThroughputRequest& request);

/// The rate of a kernel at a lane width; nullptr if it was not measured.
const KernelRate* rate_of(const ThroughputResult& result, std::string_view kernel, int lanes);

/// Henyey-Greenstein pairs per second at the default lane width over those of the scalar kernel, round by round; nothing if either was not measured or if their ranges overlap.
std::optional<Spread> speedup_over_scalar(const ThroughputResult& result);

/// The measured lane widths of a kernel, fastest first, that no other is measured to be faster than: one, or several between which no difference was measured.
std::vector<int> fastest_lanes(const ThroughputResult& result, std::string_view kernel);

}  // namespace tyndall
