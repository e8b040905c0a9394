#pragma once
/// Golden cases run before a device renders for the first time, and again for another driver or other kernels; a stamp file remembers that they passed.
#include <filesystem>
#include <optional>

#include "device/case_evaluator.hpp"
#include "device/device_list.hpp"
#include "report/report.hpp"

namespace tyndall {

struct FirstUse {
    DeviceInfo device;
    int lanes = 16;                     ///< that it is about to render with
    std::uint32_t families = every_case_family;  ///< of cases: those that the render uses
    std::optional<std::string> source;  ///< a kernel text in place of the program's own: tests plant errors with it
};

/// Runs every row of these families of the golden table on the device at this lane width, unless a stamp says that they passed there before with this platform, device, driver,
/// version and kernels. A stamp that cannot be kept is a sentence in the result's `warning`, nothing more. Throws DeviceError, which names the first case outside
/// its bounds and what to do; BuildError.
SelftestReport check_on_first_use(const FirstUse& use);

/// $XDG_CACHE_HOME/tyndall, or .cache/tyndall in the home folder; empty if neither variable holds an absolute path.
std::filesystem::path cache_folder();

/// The stamp of a device at a lane width: the name of its file depends on all that it says.
struct SelftestStamp {
    std::string name, text;
};
SelftestStamp stamp_of(const FirstUse& use);

}  // namespace tyndall
