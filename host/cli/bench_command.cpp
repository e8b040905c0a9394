#include "cli/bench_command.hpp"

#include <fmt/format.h>

#include <optional>

#include "cli/calibrated_lanes.hpp"
#include "cli/exit_code.hpp"
#include "cli/version.hpp"
#include "report/readable.hpp"
#include "throughput/clocks.hpp"
#include "throughput/lane_store.hpp"
#include "throughput/throughput_output.hpp"

namespace tyndall {

int run_bench(const BenchCommand& command)
{
    ThroughputRequest request = command.request;
    std::optional<OneCore> one_core;
    if (request.cores == Cores::one) one_core.emplace();
    request.default_lanes = kept_lanes(choose_device(request.device));
    one_core.reset();
    const ThroughputResult result = measure_throughput(request);
    fmt::print("{}", command.json ? to_json(result, version()) : to_table(result));
    return static_cast<int>(ExitCode::ok);
}

int run_calibrate(const std::string& device)
{
    std::optional<OneCore> one_core(std::in_place);
    prepare_lane_file(choose_device(device));
    one_core.reset();
    const ThroughputResult result = measure_throughput(lane_request(device));
    const LaneChoice choice = choose_lanes(result, result.device.default_lanes);
    fmt::print("{}", to_table(choice, result));
    const auto file = store_lanes(result.device, choice);
    fmt::print("kept in {}: renders on this device take {} lanes from now on, unless --lanes says otherwise\n", terminal_safe(file.string()), choice.lanes);
    return static_cast<int>(ExitCode::ok);
}

}  // namespace tyndall
