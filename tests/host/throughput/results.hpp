#pragma once
/// Made-up measurements.
#include "throughput/throughput.hpp"

namespace tyndall::test {

inline KernelRate rate(const std::string& kernel, int lanes, std::vector<double> rates)
{
    const Spread spread = spread_of(rates);
    return {kernel, lanes, std::move(rates), spread};
}

/// Of a device with 16 lanes by rule: 8 and 16 lanes overlap in the first kernel, 16 are fastest in the second.
inline ThroughputResult two_kernels()
{
    ThroughputResult result;
    result.device = {.platform = "Platform", .name = "Name \x1b[31m", .vendor = "Vendor", .driver = "1.0", .is_cpu = true, .default_lanes = 16};
    result.default_lanes = 16, result.rounds = 3, result.agreeing = 1;
    result.rates = {rate("henyey_greenstein", 0, {4e6, 4.2e6, 4e6}), rate("henyey_greenstein", 8, {90e6, 60e6, 70e6}), rate("henyey_greenstein", 16, {80e6, 84e6, 100e6}),
                    rate("surface_points", 8, {100e6, 101e6, 102e6}), rate("surface_points", 16, {150e6, 151e6, 140e6})};
    return result;
}

}  // namespace tyndall::test
