#pragma once
/// Where options get their values from: the command line, else a variable TYNDALL_..., else the file of --config. What none of them names stays with the scene or the default.
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tyndall {

struct Scene;

/// An option, what it is given, and by what: "command line", "TYNDALL_LIGHTS", "site.conf:3".
struct GivenValue {
    std::string option;  ///< without the dashes
    std::vector<std::string> values;
    std::string source;
};
inline constexpr const char* from_command_line = "command line";

/// "TYNDALL_TARGET_ERROR" for "target-error".
std::string environment_name(const std::string& option);

/// Every option of a command that is given anywhere, each from the first place that has it; one that excludes another which is given earlier is left alone. `program`: all commands, of
/// which `command` has parsed the command line and nothing else. Throws UsageError for a --config file that cannot be read or that names what does not exist.
std::vector<GivenValue> given_values(const CLI::App& program, const CLI::App& command);

/// The arguments, with what they do not hold put behind the command's name.
std::vector<std::string> with_values(std::vector<std::string> arguments, const std::string& command, const std::vector<GivenValue>& given);

/// "; the value is that of TYNDALL_LIGHTS" if the message is about an option that the command line does not hold, else nothing.
std::string source_of_mistake(const std::string& message, const std::vector<GivenValue>& given);

/// Every option with its value and where that is from, as lines that --config reads: what is given stands as it is, the rest in comments. `scene`: for the values that it determines; may be null.
std::string config_listing(const CLI::App& command, const std::vector<GivenValue>& given, const Scene* scene);

}  // namespace tyndall
