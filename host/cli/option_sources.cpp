#include "cli/option_sources.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <map>

#include "cli/config_file.hpp"
#include "scene/text.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

/// Commands that render take every option from the environment, and from the part of a file before its first section.
bool renders(const std::string& command)
{
    constexpr std::array all{"render", "animate", "explain"};
    return std::ranges::find(all, command) != all.end();
}

std::string name_of(const CLI::Option& option) { return option.get_lnames().empty() ? std::string() : option.get_lnames().front(); }

/// Options that only a command line can hold.
bool of_line_alone(const std::string& name)
{
    constexpr std::array all{"", "help", "config", "print-config", "dry-run"};
    return std::ranges::find(all, name) != all.end();
}

bool repeatable(const CLI::Option& option) { return option.get_items_expected_max() > 1; }

/// Options that a file may name, of one command.
std::vector<std::string> names_in(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        if (!of_line_alone(name_of(*option))) names.push_back(name_of(*option));
    return names;
}

/// Throws UsageError unless the value's section is a command that has its option.
void check_name(const CLI::App& program, const ConfigValue& value)
{
    std::vector<std::string> commands, names;
    for (const CLI::App* command : program.get_subcommands(nullptr)) {
        commands.push_back(command->get_name());
        if (value.section.empty() ? renders(command->get_name()) : value.section == command->get_name())
            for (std::string& name : names_in(*command)) names.push_back(std::move(name));
    }
    const std::string where = to_string(value.where);
    if (!value.section.empty() && std::ranges::find(commands, value.section) == commands.end())
        throw UsageError(where + ": there is no command " + in_quotes(value.section) + suggestion(value.section, commands));
    if (std::ranges::find(names, value.option) == names.end())
        throw UsageError(where + ": " + (value.section.empty() ? "render" : value.section) + " has no option " + in_quotes(value.option) + suggestion(value.option, names));
}

/// What a file says to a command: its own section wins over what stands before the sections.
std::map<std::string, GivenValue> from_file(const CLI::App& program, const CLI::App& command, const std::string& file)
{
    std::map<std::string, GivenValue> given;
    for (const bool own : {false, true}) {
        std::map<std::string, GivenValue> part;
        for (const ConfigValue& value : read_config(file)) {
            check_name(program, value);
            const CLI::Option* option = command.get_option_no_throw("--" + value.option);
            const bool concerns = own ? value.section == command.get_name() : value.section.empty() && renders(command.get_name());
            if (!option || !concerns) continue;
            GivenValue& entry = part[value.option];
            if (!entry.values.empty() && !repeatable(*option)) throw UsageError(to_string(value.where) + ": " + in_quotes(value.option) + " is given before, at " + entry.source);
            if (entry.values.empty()) entry.source = fmt::format("{}:{}", value.where.file, value.where.line);
            entry.option = value.option, entry.values.push_back(value.value);
        }
        for (auto& [name, value] : part) given[name] = std::move(value);
    }
    return given;
}

/// The variable that stands in for an option, if the command listens to one.
const char* variable_of(const CLI::App& command, const CLI::Option& option, std::string& variable)
{
    variable = option.get_envname();
    if (variable.empty() && renders(command.get_name())) variable = environment_name(name_of(option));
    const char* value = variable.empty() ? nullptr : std::getenv(variable.c_str());
    return value && *value ? value : nullptr;
}

bool holds(const std::vector<GivenValue>& given, const std::string& option)
{
    return std::ranges::any_of(given, [&](const GivenValue& g) { return g.option == option; });
}

/// Is the option, or one that it excludes, among them?
bool decided(const std::vector<GivenValue>& given, const CLI::Option& option)
{
    const auto excluded = option.get_excludes();
    return holds(given, name_of(option)) || std::ranges::any_of(excluded, [&](const CLI::Option* other) { return holds(given, name_of(*other)); });
}

}  // namespace

std::string environment_name(const std::string& option)
{
    std::string name = "TYNDALL_";
    for (const char c : option) name += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name;
}

std::vector<GivenValue> given_values(const CLI::App& program, const CLI::App& command)
{
    std::vector<GivenValue> given;
    const auto options = command.get_options();
    for (const CLI::Option* option : options)
        if (option->count() > 0 && !name_of(*option).empty()) given.push_back({name_of(*option), option->results(), from_command_line});
    std::string variable;
    for (const CLI::Option* option : options) {
        if (of_line_alone(name_of(*option)) || decided(given, *option)) continue;
        if (const char* value = variable_of(command, *option, variable)) given.push_back({name_of(*option), {value}, variable});
    }
    const CLI::Option* config = command.get_option_no_throw("--config");
    const char* by_variable = std::getenv("TYNDALL_CONFIG");
    const std::string file = config && config->count() > 0 ? config->results().front() : by_variable ? by_variable : "";
    if (!config || file.empty()) return given;
    for (auto& [name, value] : from_file(program, command, file))
        if (!decided(given, *command.get_option_no_throw("--" + name))) given.push_back(std::move(value));
    return given;
}

std::vector<std::string> with_values(std::vector<std::string> arguments, const std::string& command, const std::vector<GivenValue>& given)
{
    std::vector<std::string> added;
    for (const GivenValue& g : given)
        if (g.source != from_command_line)
            for (const std::string& value : g.values) added.push_back("--" + g.option + "=" + value);
    const auto place = std::ranges::find(arguments, command);
    if (place != arguments.end()) arguments.insert(place + 1, added.begin(), added.end());
    return arguments;
}

std::string source_of_mistake(const std::string& message, const std::vector<GivenValue>& given)
{
    for (const GivenValue& g : given) {
        const std::string name = "--" + g.option;
        const auto place = message.find(name);
        if (g.source == from_command_line || place == std::string::npos) continue;
        const char next = place + name.size() < message.size() ? message[place + name.size()] : ' ';
        if (next != '-' && !std::isalnum(static_cast<unsigned char>(next))) return "; the value is that of " + g.source;
    }
    return {};
}

}  // namespace tyndall
