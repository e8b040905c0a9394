#pragma once
/// The lane width that was measured for a device, where a command line leaves it open.
#include <string>

#include "device/device_list.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

/// If neither `--lanes` nor the method says otherwise, gives the settings the width that `tyndall devices --calibrate` kept for their device. Returns a warning, or nothing.
/// A device that is missing is found out later, where it is needed.
std::string take_calibrated_lanes(RenderSettings& settings);

/// The width that a render on this device takes where `--lanes` is not given: the kept one, or else the rule's. A kept file that says something else goes with a warning to stderr.
int kept_lanes(const DeviceInfo& device);

}  // namespace tyndall
