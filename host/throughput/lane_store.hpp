#pragma once
/// The lane width that `tyndall devices --calibrate` found for a device with its driver, kept among the user's settings: it is part of the result of a render, so it must not
/// vanish with a cache.
#include <filesystem>
#include <string>

#include "throughput/lane_choice.hpp"

namespace tyndall {

inline constexpr const char* lane_schema = "tyndall-lanes/1";

/// $XDG_CONFIG_HOME/tyndall, or .config/tyndall in the home folder; empty if neither variable holds an absolute path.
std::filesystem::path config_folder();

/// Where the choice for this device and driver is kept; empty if there is no folder for it.
std::filesystem::path lane_file(const DeviceInfo& device);

/// Makes the folder and finds out, before anything is measured, whether the file can be written; returns it. Throws IoError.
std::filesystem::path prepare_lane_file(const DeviceInfo& device);

/// Writes the choice, whole or not at all; returns the file. Throws IoError.
std::filesystem::path store_lanes(const DeviceInfo& device, const LaneChoice& choice);

struct StoredLanes {
    int lanes = 0;        ///< 0: none are kept
    std::string warning;  ///< why a file that is there does not count, and what to do; empty: nothing to say
};

/// What was kept for this device and driver. Throws nothing: a file that says something else is left alone, and the warning says so.
StoredLanes stored_lanes(const DeviceInfo& device);

}  // namespace tyndall
