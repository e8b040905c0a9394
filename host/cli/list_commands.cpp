#include "cli/list_commands.hpp"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "cli/bench_command.hpp"
#include "cli/calibrated_lanes.hpp"
#include "cli/exit_code.hpp"
#include "cli/say.hpp"
#include "cli/scene_json.hpp"
#include "device/device_list.hpp"
#include "device/prebuild.hpp"
#include "report/readable.hpp"
#include "scene/describe.hpp"
#include "throughput/lane_store.hpp"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const DeviceInfo& device)
{
    const int calibrated = stored_lanes(device).lanes;
    return {{"index", device.index},
            {"platform", device.platform},
            {"name", device.name},
            {"vendor", device.vendor},
            {"driver", device.driver},
            {"version", device.version},
            {"usable", device.usable},
            {"why_not", device.why_not},
            {"is_cpu", device.is_cpu},
            {"compute_units", device.compute_units},
            {"native_float_width", device.native_float_width},
            {"global_memory", device.global_memory},
            {"max_allocation", device.max_allocation},
            {"fp64", device.fp64},
            {"native_kernels", device.native_kernels},
            {"default_lanes", device.default_lanes},
            {"calibrated_lanes", calibrated ? Json(calibrated) : Json(nullptr)}};
}

void print_device(const DeviceInfo& device)
{
    constexpr double gib = 1024. * 1024 * 1024;
    const StoredLanes stored = stored_lanes(device);
    say("{:>3}  {}: {}\n", device.index, terminal_safe(device.platform), terminal_safe(device.name));
    say("     {}, driver {}, {}\n", terminal_safe(device.vendor), terminal_safe(device.driver), terminal_safe(device.version));
    say("     {} compute units, {:.1f} GiB, at most {:.1f} GiB at once, {}, double {}\n", device.compute_units,
        static_cast<double>(device.global_memory) / gib, static_cast<double>(device.max_allocation) / gib, stored.lanes ? readable_lanes(stored.lanes, "calibration") : readable_lanes(device.default_lanes, "rule"),
        device.fp64 ? "yes" : "no");
    if (!stored.warning.empty()) say(stderr, "warning: {}\n", terminal_safe(stored.warning));
    if (!device.usable) say("     not usable: {}\n", terminal_safe(device.why_not));
}

int prebuild_everyday(const std::string& request)
{
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); };
    Device device(request);
    const auto start = Clock::now();
    double slowest = 0;
    for (const PairProgram& program : everyday_programs(kept_lanes(device.info()))) {
        const auto one = Clock::now();
        prebuild(device, program);
        slowest = std::max(slowest, seconds_since(one));
    }
    say("{} programs for {}: {} are ready in the driver's cache after {}, the slowest after {}\n", device.programs_built(), terminal_safe(device.info().platform),
        terminal_safe(device.info().name), readable_seconds(seconds_since(start)), readable_seconds(slowest));
    return static_cast<int>(ExitCode::ok);
}

}  // namespace

int run_info(const InfoCommand& command)
{
    const Scene scene = load_scene(command.scene, command.load);
    for (const auto& warning : scene.warnings) say(stderr, "warning: {}\n", terminal_safe(warning));
    say("{}", command.json ? to_json(scene) : describe(scene));
    return static_cast<int>(ExitCode::ok);
}

int run_devices(const DevicesCommand& command)
{
    if (command.calibrate) return run_calibrate(command.device);
    if (command.prebuild) return prebuild_everyday(command.device);
    const auto devices = list_devices();
    Json list = Json::array();
    for (const auto& device : devices) command.json ? list.push_back(json_of(device)) : print_device(device);
    if (command.json)
        say("{}\n", Json{{"schema", "tyndall-devices/1"}, {"devices", list}}.dump(2, ' ', false, Json::error_handler_t::replace));
    choose_device(command.device);  // none usable: says what was tried
    return static_cast<int>(ExitCode::ok);
}

}  // namespace tyndall
