#pragma once
/// `tyndall explain`: what a render would do and why.
#include "cli/render_command.hpp"

namespace tyndall {

struct ExplainCommand {
    RenderCommand render;            ///< what would be rendered; its outputs and its progress are not looked at
    bool json = false;
    double calibration_seconds = 3;  ///< about so long may be spent on measuring; 0: not at all
};

/// Prints the explanation to standard output. Without an OpenCL device it explains all but the time, unless the device was asked for by name. Throws SceneError,
/// UsageError, NoDeviceError, DeviceError.
int run_explain(ExplainCommand command);

/// What a render that is about to start would do, printed to standard output as run_explain prints it (JSON: on one line), but without measuring. Devices that it needs must be there. Throws UsageError, NoDeviceError.
int run_dry(const Scene& scene, RenderSettings settings, bool json);

}  // namespace tyndall
