#pragma once
/// `tyndall info` and `tyndall devices`. Both return the exit code.
#include <filesystem>

#include "scene/load_scene.hpp"

namespace tyndall {

struct InfoCommand {
    std::filesystem::path scene;
    LoadOptions load;
    bool json = false;
};

/// Prints what was read from a scene file to standard output; its warnings to stderr. Throws SceneError.
int run_info(const InfoCommand& command);

/// Prints every OpenCL device to standard output. Throws NoDeviceError if none is usable.
int run_devices(bool json);

}  // namespace tyndall
