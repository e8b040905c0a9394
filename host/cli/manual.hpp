#pragma once
/// What the table of options can tell about itself: a manual page and completion for shells.
#include <string>

namespace CLI {
class App;
}

namespace tyndall {

/// tyndall(1) as roff: every command and option with the words of `-h`, exit codes, environment variables. `version`: "0.1.0".
std::string manual_page(const CLI::App& app, const std::string& version);

/// A script that completes commands, options, their names of choice and files. `shell`: "bash", "zsh", which reads the same by bashcompinit, or "fish". Throws UsageError for another.
std::string completion_script(const CLI::App& app, const std::string& shell);

}  // namespace tyndall
