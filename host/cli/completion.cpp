/// Completion for shells, from the table of options.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <vector>

#include "cli/manual.hpp"
#include "lights/light_technique.hpp"
#include "tyndall/error.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

std::string words(const std::vector<std::string>& all) { return fmt::format("{}", fmt::join(all, " ")); }

template <class Value, std::size_t count>
std::string words(const std::array<Named<Value>, count>& names)
{
    std::vector<std::string> all;
    for (const auto& named : names) all.emplace_back(named.name);
    return words(all);
}

/// What may follow an option that takes a name of a list, from the lists themselves.
std::vector<std::pair<std::string, std::string>> choices()
{
    std::vector<std::string> methods, layers(layer_names.begin(), layer_names.end());
    for (const Method method : all_methods()) methods.emplace_back(method.name());
    return {{"--method", words(methods)},          {"--layer", words(layers)},
            {"--sampler", words(sampler_names)},   {"--sequence", words(sequence_names)},
            {"--emission", words(sequence_names)}, {"--transmittance", words(transmittance_names)},
            {"--precision", words(precision_names)}, {"--math", words(math_names)},
            {"--select", words(selection_names)},  {"--lanes", "1 4 8 16"},
            {"--light-segments", "all first"},     {"--progress", "auto bar plain json none"}};
}

std::vector<std::string> option_names(const CLI::App& app)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
}

/// In single quotes, as fish reads them.
std::string fish_quoted(const std::string& text)
{
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return quoted + "'";
}

/// "complete -c tyndall -n ... -s p -l passes -r -d '...'".
std::string fish_option(const std::string& condition, const CLI::Option& option, const std::vector<std::pair<std::string, std::string>>& choices)
{
    std::string line = "complete -c tyndall -n " + fish_quoted(condition);
    for (const std::string& name : option.get_snames()) line += " -s " + name;
    for (const std::string& name : option.get_lnames()) line += " -l " + name;
    const auto choice = std::ranges::find_if(choices, [&](const auto& c) { return c.first == "--" + option.get_lnames().front(); });
    if (choice != choices.end()) line += " -x -a " + fish_quoted(choice->second);
    else if (option.get_expected_max() > 0) line += " -r";
    return line + " -d " + fish_quoted(option.get_description()) + "\n";
}

std::string fish_script(const CLI::App& app)
{
    std::string text;
    const auto all_choices = choices();
    for (const CLI::Option* option : app.get_options())
        if (!option->get_lnames().empty()) text += fish_option("__fish_use_subcommand", *option, {});
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        text += fmt::format("complete -c tyndall -f -n __fish_use_subcommand -a {} -d {}\n", command->get_name(), fish_quoted(command->get_description()));
        for (const CLI::Option* option : command->get_options())
            if (!option->get_lnames().empty()) text += fish_option("__fish_seen_subcommand_from " + command->get_name(), *option, all_choices);
    }
    return text + "complete -c tyndall -f -n '__fish_seen_subcommand_from completion' -a 'bash zsh fish'\n";
}

std::string bash_script(const CLI::App& app, bool zsh)
{
    std::vector<std::string> commands = option_names(app);
    std::string cases, values;
    for (const CLI::App* command : app.get_subcommands(nullptr)) {
        commands.push_back(command->get_name());
        cases += fmt::format("        {}) options=\"{}\" ;;\n", command->get_name(), words(option_names(*command)));
    }
    for (const auto& [option, names] : choices()) values += fmt::format("        {}) COMPREPLY=($(compgen -W \"{}\" -- \"$current\")); return ;;\n", option, names);
    return fmt::format(R"({}_tyndall()
{{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} options=""
    COMPREPLY=()
    if [[ $COMP_CWORD -eq 1 ]]; then
        COMPREPLY=($(compgen -W "{}" -- "$current"))
        return
    fi
    case $previous in
{}    esac
    case ${{COMP_WORDS[1]}} in
{}    esac
    if [[ $current == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$current"))
    else
        COMPREPLY=($(compgen -f -- "$current"))
    fi
}}
complete -o filenames -F _tyndall tyndall
)",
                       zsh ? "autoload -U +X bashcompinit && bashcompinit\n" : "", words(commands), values, cases);
}

}  // namespace

std::string completion_script(const CLI::App& app, const std::string& shell)
{
    if (shell == "fish") return fish_script(app);
    if (shell != "bash" && shell != "zsh") throw UsageError("completion for \"" + shell + "\" is not there; bash, zsh and fish are");
    return bash_script(app, shell == "zsh");
}

}  // namespace tyndall
