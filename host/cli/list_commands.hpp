#pragma once
/// `tyndall info` and `tyndall devices`. Both return the exit code.
#include <filesystem>
#include <string>

#include "scene/load_scene.hpp"

namespace tyndall {

struct InfoCommand {
    std::filesystem::path scene;
    LoadOptions load;
    bool json = false;
};

/// Prints what was read from a scene file to standard output; its warnings to stderr. Throws SceneError.
int run_info(const InfoCommand& command);

struct DevicesCommand {
    bool json = false;
    bool prebuild = false;  ///< build the kernels of everyday scenes on `device`
    bool calibrate = false; ///< measure lane widths on `device` and keep the best
    std::string device;
};

/// Prints every OpenCL device to standard output. Throws NoDeviceError if none is usable. With `prebuild` it builds kernels instead, so that the driver's cache
/// has them, and says how many and how long it took. Throws BuildError.
/// With `calibrate` it measures lane widths (cli/bench_command.hpp).
int run_devices(const DevicesCommand& command);

}  // namespace tyndall
