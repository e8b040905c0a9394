#include "cli/bench_command.hpp"

#include <optional>

#include "cli/calibrated_lanes.hpp"
#include "cli/compare_command.hpp"
#include "cli/exit_code.hpp"
#include "cli/outputs.hpp"
#include "cli/say.hpp"
#include "cli/version.hpp"
#include "film/atomic_file.hpp"
#include "report/readable.hpp"
#include "throughput/clocks.hpp"
#include "throughput/lane_store.hpp"
#include "throughput/throughput_output.hpp"
#include "tyndall/error.hpp"

namespace tyndall {

int run_accuracy(const BenchCommand& command)
{
    const BenchScene& scene = bench_scenes().front();
    make_folder(command.output);
    write_atomically(command.output / "scene.xml", std::string(scene.text, scene.size));
    CompareCommand compare{.inputs = {command.output / "scene.xml"}, .invocation = command.invocation, .layers = {"media_to_media"}, .json = command.json, .every_dial = true,
                           .repeats = command.repeats, .output = command.output, .resolution = {{64, 64}}};
    compare.settings.device = command.request.device;
    constexpr int values = 36, reference = 30;  // of which each run is one share: the usual settings and what is turned, and the reference that every_dial's comparisons have
    compare.times = {command.seconds.value_or(300) / (values * command.repeats + reference)};
    return run_compare(compare);
}

int run_bench(const BenchCommand& command)
{
    if (command.accuracy) return run_accuracy(command);
    ThroughputRequest request = command.request;
    request.seconds = command.seconds.value_or(request.seconds);
    std::optional<OneCore> one_core;
    if (request.cores == Cores::one) one_core.emplace();
    const DeviceInfo device = choose_device(request.device);
    request.default_lanes = kept_lanes(device);
    if (command.usual_lanes) request.lanes = usual_widths(device);
    one_core.reset();
    const ThroughputResult result = measure_throughput(request);
    say("{}", command.json ? to_json(result, version()) : to_table(result));
    return static_cast<int>(ExitCode::ok);
}

int run_calibrate(const std::string& device)
{
    std::optional<OneCore> one_core(std::in_place);
    prepare_lane_file(choose_device(device));
    one_core.reset();
    const ThroughputResult result = measure_throughput(lane_request(device));
    const LaneChoice choice = choose_lanes(result, result.device.default_lanes);
    say("{}", to_table(choice, result));
    const auto file = store_lanes(result.device, choice);
    say("kept in {}: renders on this device take {} lanes from now on, unless --lanes says otherwise\n", terminal_safe(file.string()), choice.lanes);
    return static_cast<int>(ExitCode::ok);
}

}  // namespace tyndall
