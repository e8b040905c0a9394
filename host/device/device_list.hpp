#pragma once
/// Which OpenCL devices this machine has, and which one a name means. Includes no OpenCL header.
#include <cstdint>
#include <string>
#include <vector>

namespace tyndall {

struct DeviceInfo {
    int index = 0;                       ///< position in the list, over all platforms
    std::string platform, name, vendor, driver, version;
    bool usable = false;
    std::string why_not;                 ///< if not usable: what it lacks
    unsigned compute_units = 0, native_float_width = 0;
    std::uint64_t global_memory = 0, max_allocation = 0;  ///< bytes
    bool fp64 = false, native_kernels = false, is_cpu = false;
    std::string build_options;           ///< that this device's compiler gets beside those of a program, with a leading blank; empty on CPUs
    int default_lanes = 1;               ///< lane width chosen by fixed rule from type, vendor and native width (never by timing)
};

/// Every device of every platform; a platform without devices or with a broken driver is passed over. Empty if there is none. Throws nothing.
std::vector<DeviceInfo> list_devices();

/// The device that `request` names: an index, part of a name (case ignored), or "platform:device" with parts of both; "" is the first usable one that is not a CPU,
/// or else the first usable one. Throws NoDeviceError naming what there is and which environment variables matter.
DeviceInfo choose_device(const std::string& request);

/// Several: names as above with commas between them (one may come twice, and then is used twice), or "all": every usable device.
std::vector<DeviceInfo> choose_devices(const std::string& request);

}  // namespace tyndall
