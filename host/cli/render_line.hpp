#pragma once
#include <string>

#include "cli/compare_command.hpp"

namespace tyndall {

/// The text as one word of a POSIX shell.
std::string shell_quoted(const std::string& text);

/// The `tyndall render` command with a candidate's settings and the film, scene and machine of the comparison; without budget and seed.
std::string render_line(const CompareCommand& command, const RenderSettings& settings);

}  // namespace tyndall
