/// Options of the commands that render nothing.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "cli/parse_values.hpp"
#include "cli/render_options.hpp"

namespace tyndall {
namespace {

CLI::Option* add(CLI::App& app, const char* name, const char* type, const std::string& description, const std::function<void(const std::string&)>& parse)
{
    return app.add_option_function<std::string>(name, parse, description)->type_name(type);
}

}  // namespace

void add_devices_options(CLI::App& app, DevicesCommand& command)
{
    auto* json = app.add_flag("--json", command.json, "as JSON");
    auto* prebuild = app.add_flag("--prebuild", command.prebuild, "build the kernels of everyday scenes, so that the driver's cache has them")->excludes(json);
    app.add_flag("--calibrate", command.calibrate, "measure lane widths and keep the fastest for later renders; lanes are part of the result")->excludes(json)->excludes(prebuild);
    add(app, "-d,--device", "DEVICE", "the one that --prebuild and --calibrate are about (as for render)", [&](const auto& text) { command.device = text; })->envname("TYNDALL_DEVICE");
}

void add_bench_options(CLI::App& app, BenchCommand& command)
{
    add(app, "-d,--device", "DEVICE", "the one to measure (as for render)", [&](const auto& text) { command.request.device = text; })->envname("TYNDALL_DEVICE");
    app.add_option_function<std::vector<std::string>>(
           "--lanes",
           [&](const std::vector<std::string>& texts) {
               command.request.lanes.clear(), command.usual_lanes = false;
               for (const auto& text : texts) command.request.lanes.push_back(parse_lanes("--lanes", text));
               std::ranges::sort(command.request.lanes);
               command.request.lanes.erase(std::unique(command.request.lanes.begin(), command.request.lanes.end()), command.request.lanes.end());
           },
           "lane widths to measure, comma-separated (1,4,8,16 on CPUs, 1,4 elsewhere)")
        ->type_name("NUMBERS")
        ->delimiter(',')
        ->allow_extra_args(false);
    add(app, "--cores", "WHICH", "one: processor time on one core; all: time on the wall with the whole device (one)",
        [&](const auto& text) { command.request.cores = parse_choice("--cores", text, {"one", "all"}) == 0 ? Cores::one : Cores::all; });
    add(app, "-t,--time", "TIME", "about so long may be spent on measuring, after the kernels were built (10 s; 5m for --accuracy)", [&](const auto& text) { command.seconds = parse_duration("--time", text); });
    auto* accuracy = app.add_flag("--accuracy", command.accuracy, "what every dial is worth in accuracy for the same time, in a foggy room that comes with the program, as a table and a page");
    app.add_option("-o,--output", command.output, "folder for that page (accuracy)")->type_name("FOLDER")->needs(accuracy);
    add(app, "--repeats", "N", "runs of each value there (8)", [&](const auto& text) { command.repeats = static_cast<int>(parse_integer("--repeats", text, 2, 1000)); })->needs(accuracy);
    app.add_flag("--json", command.json, "as JSON");
}

void add_selftest_options(CLI::App& app, SelftestCommand& command)
{
    add(app, "-d,--device", "DEVICE", "the one to test (as for render)", [&](const auto& text) { command.request.device = text; })->envname("TYNDALL_DEVICE");
    app.add_option("--only", command.request.only, "only cases with this in their name, for example row04; repeatable (all)")->type_name("CASE")->allow_extra_args(false);
    auto* all = app.add_flag("--all-lanes", command.all_lanes, "at 1, 4, 8 and 16 lanes (those that a render would use)");
    add(app, "--lanes", "N", "at 1, 4, 8 or 16 lanes (by device)", [&](const auto& text) {
        command.request.lanes = {parse_lanes("--lanes", text)};
    })->envname("TYNDALL_LANES")->excludes(all);
    auto* json = app.add_flag("--json", command.json, "as JSON");
    app.add_flag("--junit", command.junit, "as JUnit's XML")->excludes(json);
    app.add_option("--bundle", command.bundle, "if a case fails on the device: kernel, options, buffers, expected values and a program that replays it, in this folder")->type_name("FOLDER");
}

}  // namespace tyndall
