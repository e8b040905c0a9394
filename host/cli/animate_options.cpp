#include "cli/animate_options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>

#include "cli/parse_values.hpp"
#include "cli/render_options.hpp"
#include "scene/text.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

constexpr int most_frames = 1000000;

/// "0:24".
void parse_frames(const std::string& text, AnimateCommand& command)
{
    const auto colon = text.find(':');
    if (colon == std::string::npos) throw UsageError("--frames " + in_quotes(text) + " must be FIRST:END, for example 0:24 for 24 frames");
    command.first = static_cast<int>(parse_integer("--frames", text.substr(0, colon), 0, most_frames));
    command.end = static_cast<int>(parse_integer("--frames", text.substr(colon + 1), 0, most_frames));
    if (command.end <= command.first) throw UsageError("--frames " + in_quotes(text) + " has no frame: the end is not rendered, and must lie behind the first");
}

/// "angle=0:15".
VaryingValue parse_varying(const std::string& text)
{
    const auto [name, value] = parse_definition("--vary", text);
    const auto colon = value.find(':');
    const auto start = parse_real(value.substr(0, colon)), step = colon == std::string::npos ? std::nullopt : parse_real(value.substr(colon + 1));
    if (!start || !step) throw UsageError("--vary " + in_quotes(text) + " must be NAME=START:STEP, for example angle=0:15");
    return {.name = name, .start = *start, .step = *step};
}

/// Options that change no byte of an image.
bool changes_images(const std::string& name)
{
    constexpr std::array without{"help", "scene", "output", "frames", "threads", "tile", "launch-ms", "checkpoint", "resume", "progress", "report", "no-selftest", "allow-outside", "config", "print-config", "display-server", "strict-nan", "dump-kernels"};
    return std::ranges::find(without, name) == without.end();
}

}  // namespace

void add_animate_options(CLI::App& app, AnimateCommand& command)
{
    add_render_options(app, command.render);
    app.get_option("scene")->description("scene file, Mitsuba 3 XML, or a folder with a scene.xml");
    app.get_option("--output")->description("folder of the frames: frame_0000.exr, .png, .json, ... (the scene's name with _frames)");
    app.get_option("--resume")->description("frames go on from their checkpoints in any case");
    app.add_option_function<std::string>("--frames", [&](const std::string& text) { parse_frames(text, command); }, "from the first up to, but without, the end: 0:24")->required()->type_name("FIRST:END");
    app.add_option_function<std::string>(
           "--seed-per-frame", [&](const std::string& text) { command.varying_seed = parse_choice("--seed-per-frame", text, {"fixed", "varying"}) == 1; },
           "fixed: every frame has the same random numbers; varying: its own (varying)")
        ->type_name("WHICH");
    app.add_option_function<std::vector<std::string>>(
           "--vary",
           [&](const std::vector<std::string>& texts) {
               for (const std::string& text : texts) command.vary.push_back(parse_varying(text));
           },
           "in frame f the scene's <default> NAME is START + f STEP; repeatable (frame=0:1)")
        ->type_name("NAME=START:STEP")
        ->allow_extra_args(false);
    app.final_callback([&app, &command] { command.options = options_text(app); });
}

std::string options_text(const CLI::App& app)
{
    std::string text;
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = option->get_lnames().empty() ? option->get_name() : option->get_lnames().front();
        if (option->count() == 0 || !changes_images(name)) continue;
        text += name;
        for (const std::string& value : option->results()) text += " " + value;
        text += "\n";
    }
    return text;
}

}  // namespace tyndall
