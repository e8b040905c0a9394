#pragma once

namespace tyndall {

/// The whole program: parses, runs, reports failures. Returns the exit code (cli/exit_code.hpp).
int run_command_line(int argc, char** argv);

}  // namespace tyndall
