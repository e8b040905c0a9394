#include "cli/compare_options.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <functional>

#include "cli/parse_values.hpp"
#include "cli/render_options.hpp"
#include "lights/light_technique.hpp"

namespace tyndall {
namespace {

using Texts = std::vector<std::string>;

void add(CLI::App& app, const char* name, const char* type, const std::string& description, const std::function<void(const std::string&)>& parse)
{
    app.add_option_function<std::string>(name, parse, description)->type_name(type);
}

/// An option with a list of values, comma-separated.
void add_list(CLI::App& app, const char* name, const char* type, const std::string& description, const std::function<void(const Texts&)>& parse)
{
    app.add_option_function<Texts>(name, parse, description)->type_name(type)->delimiter(',')->allow_extra_args(false);
}

/// A dial whose values come from a table of names.
template <class Value, std::size_t count>
void add_named_dial(CLI::App& app, CompareCommand& command, const char* option, const std::string& description, const std::array<Named<Value>, count>& table, Value RenderSettings::*member)
{
    std::string known;
    for (const auto& named : table) known += (known.empty() ? "" : ", ") + std::string(named.name);
    add_list(app, option, "NAMES", description + ": " + known, [=, &command, &table](const Texts& texts) {
        Dial dial;
        for (const std::string& text : texts) {
            const Value value = parse_named(option, text, table);
            dial.values.push_back({text, [member, value](RenderSettings& s) { s.*member = value; }});
        }
        command.dials.push_back(dial);
    });
}

/// A dial of whole numbers; "128 lights" is the name of a value.
template <class Number>
void add_number_dial(CLI::App& app, CompareCommand& command, const char* option, const char* description, std::int64_t most, const char* unit, Number RenderSettings::*member)
{
    add_list(app, option, "NUMBERS", description, [=, &command](const Texts& texts) {
        Dial dial;
        for (const std::string& text : texts) {
            const auto value = static_cast<Number>(parse_integer(option, text, 1, most));
            dial.values.push_back({fmt::format("{} {}", text, unit), [member, value](RenderSettings& s) { s.*member = value; }});
        }
        command.dials.push_back(dial);
    });
}

/// A dial of numbers that only some methods have.
void add_share_dial(CLI::App& app, CompareCommand& command, const char* option, const char* description, double (*parse)(std::string_view, const std::string&), const char* words,
                    bool (*concerns)(Method), std::optional<double> RenderSettings::*member)
{
    add_list(app, option, "NUMBERS", description, [=, &command](const Texts& texts) {
        Dial dial{.values = {}, .concerns = concerns};
        for (const std::string& text : texts) {
            const double value = parse(option, text);
            dial.values.push_back({fmt::format(fmt::runtime(words), text), [member, value](RenderSettings& s) { s.*member = value; }});
        }
        command.dials.push_back(dial);
    });
}

double parse_clamp(std::string_view option, const std::string& text) { return parse_number(option, text, 1e-6, 1e12); }
double parse_radius(std::string_view option, const std::string& text) { return parse_share(option, text); }

/// What makes methods biased, and what kernels compute with.
void add_more_dials(CLI::App& app, CompareCommand& command)
{
    add_share_dial(app, command, "--clamps", "of clamped methods (100)", parse_clamp, "clamp {}", is_clamped, &RenderSettings::clamp);
    add_share_dial(app, command, "--beam-radii", "of beams in the first pass, shares of the scene's half diagonal: .05 or 5% (.05)", parse_radius, "radius {}", is_thick, &RenderSettings::beam_radius);
    add_named_dial(app, command, "--precisions", "of the kernels", precision_names, &RenderSettings::precision);
    add_named_dial(app, command, "--maths", "of the kernels", math_names, &RenderSettings::math);
}

void add_dials(CLI::App& app, CompareCommand& command)
{
    add_list(app, "--methods", "NAMES", "methods to compare (vrl,path)", [&](const Texts& texts) {
        for (const std::string& text : texts) command.methods.push_back(parse_method("--methods", text));
    });
    add_named_dial(app, command, "--samplers", "of connections", sampler_names, &RenderSettings::sampler);
    add_named_dial(app, command, "--sequences", "numbers of the samples", sequence_names, &RenderSettings::sequence);
    add_named_dial(app, command, "--emissions", "numbers of the light paths", sequence_names, &RenderSettings::emission);
    add_named_dial(app, command, "--transmittances", "through density grids", transmittance_names, &RenderSettings::transmittance);
    add_named_dial(app, command, "--lengths", "of virtual ray lights", segment_length_names, &RenderSettings::segment_length);
    add_number_dial(app, command, "--lights", "virtual lights per pass (as `render` chooses for the longest time)", 1 << 24, "lights", &RenderSettings::lights);
    add_named_dial(app, command, "--selections", "all virtual lights for each pixel, or some: auto, all, tile", selection_names, &RenderSettings::selection);
    add_number_dial(app, command, "--selected", "virtual lights that are chosen for each pixel", 1 << 16, "chosen", &RenderSettings::selected_lights);
    add_number_dial(app, command, "--candidates", "virtual lights that a region's squares choose among", 1 << 20, "candidates", &RenderSettings::candidates);
    add_number_dial(app, command, "--samples", "of every pair of light and eye per pass (1)", 256, "samples", &RenderSettings::samples_per_pair);
    add_list(app, "--lanes", "NUMBERS", "pixels per work-item: 1, 4, 8, 16 (by device)", [&](const Texts& texts) {
        Dial dial;
        for (const std::string& text : texts) {
            const int lanes = parse_lanes("--lanes", text);
            dial.values.push_back({text + " lanes", [lanes](RenderSettings& s) { s.lanes = lanes, s.lanes_calibrated = false; }});
        }
        command.dials.push_back(dial);
    });
}

void add_measuring(CLI::App& app, CompareCommand& command)
{
    add_list(app, "-t,--times", "TIMES", "seconds at which methods are compared: 1,6,1m (1,6)", [&](const Texts& texts) {
        for (const std::string& text : texts) command.times.push_back(parse_duration("--times", text));
    });
    add(app, "--repeats", "N", "runs of each with other seeds, taken in turns; one has no error bar (3)",
        [&](const auto& text) { command.repeats = static_cast<int>(parse_integer("--repeats", text, 1, 1000)); });
    app.add_option("--reference", command.reference, "image to measure against, *.exr (made by path tracing)")->type_name("FILE");
    add(app, "--reference-time", "TIME", "for the reference that is made (four times the longest time)",
        [&](const auto& text) { command.reference_seconds = parse_duration("--reference-time", text); });
    add(app, "--reference-method", "NAME", "that makes it (path)", [&](const auto& text) { command.reference_method = parse_method("--reference-method", text); });
    add(app, "--seed", "N", "of the reference; runs have the seeds after it (1)", [&](const auto& text) { command.settings.seed = parse_unsigned("--seed", text); });
    app.add_option("-o,--output", command.output, "folder for the page (named after the scene)")->type_name("FOLDER");
}

void add_scene(CLI::App& app, CompareCommand& command)
{
    add(app, "--max-depth", "D", "as for render", [&](const auto& text) {
        command.settings.max_depth = text == "-1" ? -1 : static_cast<int>(parse_integer("--max-depth", text, 1, 1 << 20));
    });
    add(app, "--resolution", "WxH", "film size in pixels", [&](const auto& text) { command.resolution = parse_resolution("--resolution", text); });
    add(app, "--crop", "X,Y,W,H", "only this window of the film", [&](const auto& text) { command.crop = parse_crop("--crop", text); });
    add(app, "-d,--device", "DEVICE", "as for render", [&](const auto& text) { command.settings.device = text; });
    add(app, "--threads", "N", "host threads (all cores); a CPU device has its own, which answer shadow segments too (PoCL: POCL_MAX_PTHREAD_COUNT)", [&](const auto& text) { command.settings.threads = static_cast<int>(parse_integer("--threads", text, 1, 1024)); });
    add_load_options(app, command.load);
}

}  // namespace

void add_compare_options(CLI::App& app, CompareCommand& command)
{
    app.add_option("inputs", command.inputs, "an image and its reference, *.exr, or a scene, *.xml")->required()->expected(1, 2)->type_name("FILES");
    add_list(app, "--layer", "NAMES", "compare this layer, or the sum of several, instead of the image", [&](const Texts& texts) {
        for (const std::string& text : texts) command.layers.push_back(text);
    });
    add(app, "--tolerance", "SHARE", "two images: exit code 8 if the error of the first is larger: 1% or .01 (any error is fine)",
        [&](const auto& text) { command.tolerance = parse_share("--tolerance", text); });
    app.add_flag("--json", command.json, "as JSON, on standard output");
    add_dials(app, command);
    add_more_dials(app, command);
    app.add_flag("--dials", command.every_dial, "every dial of the first method by itself: what each is worth in accuracy for the same time");
    add_measuring(app, command);
    add_scene(app, command);
}

}  // namespace tyndall
