#include "cli/compare_options.hpp"

#include <CLI/CLI.hpp>

#include "cli/parse_values.hpp"

namespace tyndall {
namespace {

using Texts = std::vector<std::string>;

/// An option with a list of values, comma-separated and repeatable.
void add_list(CLI::App& app, const char* name, const char* type, const char* description, Texts& values)
{
    app.add_option(name, values, description)->type_name(type)->delimiter(',')->allow_extra_args(false);
}

}  // namespace

void add_compare_options(CLI::App& app, CompareCommand& command)
{
    app.add_option("inputs", command.inputs, "an image and its reference, *.exr")->required()->expected(1, 2)->type_name("FILES");
    add_list(app, "--layer", "NAMES", "compare this layer, or the sum of several, instead of the image; repeatable", command.layers);
    app.add_option_function<std::string>(
           "--tolerance", [&](const std::string& text) { command.tolerance = parse_share("--tolerance", text); },
           "exit code 8 if the error of the first image is larger: 1% or .01 (any error is fine)")
        ->type_name("SHARE");
    app.add_flag("--json", command.json, "as JSON");
}

}  // namespace tyndall
