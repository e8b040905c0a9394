#pragma once
/// The hard cases (host/docs/hard_cases.md) without a scene and without the source tree: on the host in float and double, and on a device.
#include <optional>
#include <string>
#include <vector>

#include "device/case_evaluator.hpp"
#include "device/device_list.hpp"
#include "selftest/check_row.hpp"

namespace tyndall {

struct SelftestRequest {
    std::string device;             ///< as Device takes it
    std::vector<std::string> only;  ///< rows whose names hold one of these, case ignored; empty: all
    std::vector<int> lanes;         ///< of the device; empty: those that it would render with
    bool host = true;               ///< the host too
    std::uint32_t families = every_case_family;  ///< rows of other families are left out
    std::optional<std::string> source;  ///< a kernel text in place of the program's own: tests plant errors with it
};

/// A launch on the device in which an output missed its interval.
struct FailedLaunch {
    std::string name;               ///< of the row
    int lanes = 0;
    SelftestLaunch<float> launch;
};

/// What the device's compiler was given for one lane width.
struct SelftestProgram {
    int lanes = 0;
    std::string source, options;
};

struct SelftestResult {
    DeviceInfo device;
    std::vector<SelftestOutcome> outcomes;  ///< host float, host double, then the device by lanes; within each the rows in order
    std::vector<SelftestProgram> programs;
    std::vector<FailedLaunch> failed;
    double seconds = 0;

    bool passed() const;
};

/// Runs it. Throws UsageError if `only` selects nothing; NoDeviceError, DeviceError, BuildError.
SelftestResult run_selftest(const SelftestRequest& request);

/// The family (one bit of CASE_FAMILIES) that a sampler belongs to.
std::uint32_t family_of(unsigned sampler);

/// Name of a sampler of kernels/selftest/evaluate.h: "rod", "pair", ...
std::string sampler_name(unsigned sampler);

}  // namespace tyndall
