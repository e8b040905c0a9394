#pragma once
#include "cli/render_command.hpp"

namespace CLI {
class App;
}

namespace tyndall {

/// Declares the options of `tyndall render` on `app`; parsing fills `command`, which must outlive it. Values that make no sense throw
/// UsageError.
void add_render_options(CLI::App& app, RenderCommand& command);

/// Declares -D and --allow-outside, which every command that reads a scene has.
void add_load_options(CLI::App& app, LoadOptions& options);

}  // namespace tyndall
