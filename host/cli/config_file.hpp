#pragma once
/// The file of --config: values of options, one a line.
#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace tyndall {

/// "lights = 4096" on its line.
struct ConfigValue {
    std::string section;  ///< of [bench]: "bench"; empty before the first one
    std::string option;   ///< without the dashes
    std::string value;    ///< without its quotes
    SourceLocation where;
};

/// Lines `name = value`, `[section]`, blank ones and comments that start with #. A value in double quotes may hold # and blanks at its ends, with \" and \\ for those characters.
/// At most 1 MiB. Throws UsageError "file:line:column: ..." for anything else.
std::vector<ConfigValue> read_config(const std::filesystem::path& file);

/// The value as such a line holds it: in quotes where it needs them.
std::string config_text(const std::string& value);

}  // namespace tyndall
