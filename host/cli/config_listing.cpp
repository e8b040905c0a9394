/// --print-config: options, values, sources.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/config_file.hpp"
#include "cli/option_sources.hpp"
#include "scene/scene.hpp"

namespace tyndall {
namespace {

constexpr std::size_t value_column = 44;

/// What a description says of the default: the brackets at its end.
std::string default_of(const CLI::Option& option)
{
    const std::string& text = option.get_description();
    if (option.get_expected_max() == 0) return text.ends_with("(default)") ? "true" : "false";
    if (text.empty() || text.back() != ')') return {};
    const auto open = text.rfind('(');
    return open == std::string::npos ? std::string() : text.substr(open + 1, text.size() - open - 2);
}

/// The value that the scene determines, if it is one of those.
std::string scene_value(const std::string& option, const Scene& scene)
{
    const Camera& c = scene.camera;
    if (option == "max-depth") return fmt::to_string(scene.max_depth);
    if (option == "resolution") return fmt::format("{}x{}", c.width, c.height);
    if (option == "crop") return fmt::format("{},{},{},{}", c.crop_x, c.crop_y, c.crop_width, c.crop_height);
    return {};
}

std::string line(const std::string& value, const std::string& source) { return fmt::format("{:<{}} # {}\n", value, value_column, source); }

}  // namespace

std::string config_listing(const CLI::App& command, const std::vector<GivenValue>& given, const Scene* scene)
{
    std::string text = fmt::format("[{}]\n", command.get_name());
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_lnames().empty()) continue;
        const std::string& name = option->get_lnames().front();
        if (name == "help" || name == "config" || name == "print-config" || name == "dry-run") continue;
        const auto found = std::ranges::find_if(given, [&](const GivenValue& g) { return g.option == name; });
        const std::string of_scene = scene ? scene_value(name, *scene) : std::string();
        if (found != given.end())
            for (const std::string& value : found->values) text += line(name + " = " + config_text(value), found->source);
        else if (!of_scene.empty()) text += line("# " + name + " = " + of_scene, scene->file);
        else if (const std::string usual = default_of(*option); !usual.empty()) text += line("# " + name + " = " + usual, "default");
        else text += line("# " + name, "not given");
    }
    return text;
}

}  // namespace tyndall
