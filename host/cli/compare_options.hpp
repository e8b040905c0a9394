#pragma once
#include "cli/compare_command.hpp"

namespace CLI {
class App;
}

namespace tyndall {

/// Declares the options of `tyndall compare` on `app`; parsing fills `command`, which must outlive it. Values that make no sense throw UsageError.
void add_compare_options(CLI::App& app, CompareCommand& command);

}  // namespace tyndall
