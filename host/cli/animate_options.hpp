#pragma once
#include <string>

#include "cli/animate_command.hpp"

namespace CLI {
class App;
}

namespace tyndall {

/// Declares the options of `tyndall animate`: those of `render` and its own. Values that make no sense throw UsageError.
void add_animate_options(CLI::App& app, AnimateCommand& command);

/// The options that were given on the command line or in the environment and that images depend on, a line each.
std::string options_text(const CLI::App& app);

}  // namespace tyndall
