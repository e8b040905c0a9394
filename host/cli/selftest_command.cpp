#include "cli/selftest_command.hpp"

#include "cli/calibrated_lanes.hpp"
#include "cli/exit_code.hpp"
#include "cli/say.hpp"
#include "cli/version.hpp"
#include "device/device_list.hpp"
#include "report/readable.hpp"
#include "selftest/bundle.hpp"
#include "selftest/selftest_output.hpp"

namespace tyndall {
namespace {

void finish_bundle(const SelftestCommand& command, const SelftestResult& result)
{
    if (result.failed.empty()) {
        std::error_code ignored;
        std::filesystem::remove(command.bundle, ignored);
        say(stderr, "no case failed on the device: no bundle was written\n");
    } else {
        write_bundle(command.bundle, result, to_json(result, version()));
        say(stderr, "wrote {}: its README.md says how to replay the failed cases\n", terminal_safe(command.bundle.string()));
    }
}

}  // namespace

int run_selftest(const SelftestCommand& command)
{
    if (!command.bundle.empty()) check_bundle_folder(command.bundle);
    SelftestRequest request = command.request;
    if (command.all_lanes) request.lanes = {1, 4, 8, 16};
    else if (request.lanes.empty()) request.lanes = {kept_lanes(choose_device(request.device))};
    const SelftestResult result = run_selftest(request);
    say("{}", command.json ? to_json(result, version()) : command.junit ? to_junit(result) : to_table(result));
    if (!command.bundle.empty()) finish_bundle(command, result);
    return static_cast<int>(result.passed() ? ExitCode::ok : ExitCode::outside_tolerance);
}

}  // namespace tyndall
