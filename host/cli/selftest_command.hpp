#pragma once
/// `tyndall selftest`: the hard cases on host and device.
#include <filesystem>

#include "selftest/selftest.hpp"

namespace tyndall {

struct SelftestCommand {
    SelftestRequest request;
    bool all_lanes = false, json = false, junit = false;
    std::filesystem::path bundle;  ///< folder for a report to the makers of a driver, written if something fails on the device; empty: none
};

/// Prints the result to standard output: a table, JSON or JUnit's XML. Returns ExitCode::outside_tolerance if a case is outside its bounds. Throws UsageError,
/// NoDeviceError, DeviceError, IoError.
int run_selftest(const SelftestCommand& command);

}  // namespace tyndall
