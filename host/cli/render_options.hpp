#pragma once
#include "cli/bench_command.hpp"
#include "cli/explain_command.hpp"
#include "cli/list_commands.hpp"
#include "cli/merge_command.hpp"
#include "cli/render_command.hpp"
#include "cli/selftest_command.hpp"

namespace CLI {
class App;
}

namespace tyndall {

/// Declares the options of `tyndall render` on `app`; parsing fills `command`, which must outlive it. Values that make no sense throw
/// UsageError.
void add_render_options(CLI::App& app, RenderCommand& command);

/// Those of them that are settings and nothing else.
void add_setting_options(CLI::App& app, RenderSettings& settings);

/// Declares the options of `tyndall explain`: those of `render` and its own.
void add_explain_options(CLI::App& app, ExplainCommand& command);

/// Declares the options of `tyndall merge`.
void add_merge_options(CLI::App& app, MergeCommand& command);

/// Declares the options of `tyndall devices`.
void add_devices_options(CLI::App& app, DevicesCommand& command);

/// Declares the options of `tyndall bench`.
void add_bench_options(CLI::App& app, BenchCommand& command);

/// Declares the options of `tyndall selftest`.
void add_selftest_options(CLI::App& app, SelftestCommand& command);

/// Declares -D and --allow-outside, which every command that reads a scene has.
void add_load_options(CLI::App& app, LoadOptions& options);

}  // namespace tyndall
