#include "cli/explain_command.hpp"

#include <fmt/format.h>

#include "cli/calibrated_lanes.hpp"
#include "cli/exit_code.hpp"
#include "device/device_list.hpp"
#include "pipeline/explain.hpp"
#include "tyndall/error.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

/// The device that a render would use; nothing, and why, if there is none.
std::optional<DeviceInfo> device_for(const RenderSettings& settings, std::string& why_not)
{
    if (settings.method == Method::path) return std::nullopt;
    try {
        return choose_devices(settings.device).front();
    } catch (const NoDeviceError& error) {
        if (!settings.device.empty()) throw;
        why_not = error.what();
        return std::nullopt;
    }
}

}  // namespace

int run_explain(ExplainCommand command)
{
    RenderSettings& settings = command.render.settings;
    give_default_budget(settings);
    Scene scene = load_scene(command.render.scene, command.render.load);
    override_film(scene.camera, command.render.resolution, command.render.crop);
    std::string why_not;
    const auto device = device_for(settings, why_not);
    if (const std::string warning = take_calibrated_lanes(settings); !warning.empty()) scene.warnings.push_back(warning);
    const std::string_view from = lanes_from(settings);
    if (device && settings.lanes == 0) settings.lanes = device->default_lanes;
    Explanation explanation = explain(scene, settings);
    explanation.lanes_from = from;
    const bool ready = explanation.kernels.empty() || device;
    if (!explanation.kernels.empty() && device) explanation.device = device->platform + ": " + device->name;
    if (!ready) explanation.why_no_calibration = why_not;
    else if (command.calibration_seconds <= 0) explanation.why_no_calibration = "turned off by --calibrate 0";
    else explanation.calibration = calibrate(scene, settings, command.calibration_seconds);
    fmt::print("{}", command.json ? to_json(explanation) : to_text(explanation));
    return static_cast<int>(ExitCode::ok);
}

}  // namespace tyndall
