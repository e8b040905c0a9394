#include "cli/setting_text.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/render_options.hpp"
#include "scene/text.hpp"
#include "tyndall/error.hpp"

namespace tyndall {

void set_setting(RenderSettings& settings, const std::string& name, const std::string& value)
{
    CLI::App app;
    app.set_help_flag();
    add_setting_options(app, settings);
    std::vector<std::string> names;
    for (CLI::Option* option : app.get_options()) {
        option->envname("");
        for (const std::string& known : option->get_lnames()) names.push_back(known);
    }
    const CLI::Option* option = name.empty() ? nullptr : app.get_option_no_throw("--" + name);
    if (!option) throw UsageError(fmt::format("there is no setting {}{}", in_quotes(name), suggestion(name, names)));
    const bool is_flag = option->get_expected_max() == 0;
    if (is_flag && value != "true" && value != "false") throw UsageError(fmt::format("{} = {}: must be true or false", name, in_quotes(value)));
    std::vector<std::string> arguments{"--" + name + "=" + value};
    try {
        app.parse(arguments);
    } catch (const CLI::ParseError& error) {
        throw UsageError(fmt::format("{} = {}: {}", name, in_quotes(value), error.what()));
    }
}

}  // namespace tyndall
