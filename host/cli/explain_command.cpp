#include "cli/explain_command.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/calibrated_lanes.hpp"
#include "cli/exit_code.hpp"
#include "cli/say.hpp"
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

/// What a render would find wrong with its devices. Throws NoDeviceError.
void check_devices(const std::vector<DeviceInfo>& devices, const RenderSettings& settings)
{
    for (const DeviceInfo& device : devices)
        if (settings.precision == Precision::f64 && !device.fp64)
            throw NoDeviceError("\"" + device.name + "\" has no 64-bit numbers (cl_khr_fp64), which --precision f64 needs; name another device, or leave it at f32");
}

/// A warning where a device has less memory than the estimate.
void compare_memory(Explanation& explanation, const std::vector<DeviceInfo>& devices)
{
    std::uint64_t bytes = 0;
    for (const MemoryReport& memory : explanation.memory) bytes += memory.on_device ? memory.bytes : 0;
    constexpr double mib = 1024. * 1024.;
    for (const DeviceInfo& device : devices)
        if (bytes > device.global_memory)
            explanation.warnings.push_back(fmt::format("about {:.0f} MiB would be on {}, which has {:.0f} MiB: it will do less at a time, with the same image", static_cast<double>(bytes) / mib,
                                                       device.name, static_cast<double>(device.global_memory) / mib));
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
    say("{}", command.json ? to_json(explanation) : to_text(explanation));
    return static_cast<int>(ExitCode::ok);
}

int run_dry(const Scene& scene, RenderSettings settings, bool json)
{
    const std::string_view from = lanes_from(settings);
    Explanation explanation = explain(scene, settings);
    if (!explanation.kernels.empty()) {
        const std::vector<DeviceInfo> devices = choose_devices(settings.device);
        check_devices(devices, settings);
        if (settings.lanes == 0) settings.lanes = devices.front().default_lanes;
        explanation = explain(scene, settings);
        explanation.lanes_from = from;
        for (const DeviceInfo& device : devices) explanation.device += (explanation.device.empty() ? "" : "; ") + device.platform + ": " + device.name;
        compare_memory(explanation, devices);
    }
    explanation.why_no_calibration = "this is a dry run; `tyndall explain` measures";
    say("{}", json ? nlohmann::ordered_json::parse(to_json(explanation)).dump() + "\n" : to_text(explanation));
    return static_cast<int>(ExitCode::ok);
}

}  // namespace tyndall
