#include "cli/render_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>

#include "cli/parse_values.hpp"
#include "lights/light_technique.hpp"

namespace tyndall {
namespace {

/// An option whose text goes through one of parse_values.hpp's functions; may be given once.
CLI::Option* add(CLI::App& app, const char* name, const char* type, const std::string& description, const std::function<void(const std::string&)>& parse)
{
    return app.add_option_function<std::string>(name, parse, description)->type_name(type);
}

/// A flag that can be taken back: `--name=false` calls `set` with false. Given several times, the last one counts.
CLI::Option* add_switch(CLI::App& app, const char* name, const std::string& description, const std::function<void(bool)>& set)
{
    return app.add_flag_function(name, [set](std::int64_t count) { set(count > 0); }, description)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

int integer(const char* option, const std::string& text, int low, int high)
{
    return static_cast<int>(parse_integer(option, text, low, high));
}

void add_budget(CLI::App& app, RenderSettings& settings)
{
    add(app, "-p,--passes", "N", "stop after N passes (16, unless a time or a target error is given)",
        [&](const auto& text) { settings.passes = integer("--passes", text, 1, 1 << 30); });
    add(app, "-t,--time", "TIME", "stop before this wall-clock time: 60, 60s, 2m, 1.5h",
        [&](const auto& text) { settings.seconds = parse_duration("--time", text); });
    add(app, "--target-error", "SHARE", "stop when the image's error is at most this with 95 % confidence: 1% or .01",
        [&](const auto& text) { settings.target_error = parse_share("--target-error", text); });
    add(app, "--lights", "N", "virtual lights per pass, aimed at (2048 to choose among; with --select all by image size and time)",
        [&](const auto& text) { settings.lights = static_cast<std::uint32_t>(parse_integer("--lights", text, 1, 1 << 26)); });
    add(app, "--seed", "N", "another seed, other noise (1)", [&](const auto& text) { settings.seed = parse_unsigned("--seed", text); });
}

void add_layers(CLI::App& app, RenderSettings& settings)
{
    app.add_option_function<std::vector<std::string>>(
           "--layer",
           [&](const std::vector<std::string>& texts) {
               LayerWishes wishes;
               for (const auto& text : texts) parse_layer_wishes("--layer", text, wishes);
               settings.layers = wishes.kept(), settings.path_layers = wishes.by_path;
           },
           "keep only these layers, for example single,media_to_media; NAME=path keeps the others and path-traces this one; repeatable (all)")
        ->type_name("NAMES")
        ->allow_extra_args(false);
}

/// "vrl: virtual ray lights; ...", from the lights that there are.
std::string method_help()
{
    std::string text;
    for (const Method method : all_methods()) {
        text += (text.empty() ? "" : "; ") + std::string(method.name()) + ": " + recipe_of(method).title;
    }
    return text + " (vrl)";
}

/// What makes virtual lights biased, and how much.
void add_bias(CLI::App& app, RenderSettings& settings)
{
    add(app, "--clamp", "C", "of clamped methods: 1/w^2 of a connection is at most C over the square of the scene's half diagonal; biased (100)",
        [&](const auto& text) { settings.clamp = parse_number("--clamp", text, 1e-6, 1e12); });
    add(app, "--beam-radius", "SHARE", "of beams and photons: radius in the first pass, of the scene's half diagonal: .05 or 5%; biased, less from pass to pass (vbl .05, beams and photons .02)",
        [&](const auto& text) { settings.beam_radius = parse_share("--beam-radius", text); });
}

void add_transport(CLI::App& app, RenderSettings& settings)
{
    add(app, "--method", "NAME", method_help(), [&](const auto& text) { settings.method = parse_method("--method", text); });
    add(app, "--max-depth", "D", "paths have at most D - 1 scattering vertices; -1: no limit (the scene's)",
        [&](const auto& text) { settings.max_depth = text == "-1" ? -1 : integer("--max-depth", text, 1, 1 << 20); });
    add(app, "--light-segments", "WHICH", "all, or first: only those that leave the emitter (all)", [&](const auto& text) {
        settings.light_segments = parse_choice("--light-segments", text, {"all", "first"}) == 0 ? LightSegments::all : LightSegments::first;
    });
    add(app, "--sampler", "NAME", "of connections: auto, paper-isotropic, paper, paper-6, table, table-4x4 or table-3x2 (by how media scatter)", [&](const auto& text) {
        settings.sampler = parse_named("--sampler", text, sampler_names);
    });
    add(app, "--emission", "NAME", "numbers of the light paths: auto, random or sobol (sobol)", [&](const auto& text) {
        settings.emission = parse_named("--emission", text, sequence_names);
    });
    add(app, "--sequence", "NAME", "numbers of the samples: auto, random or sobol", [&](const auto& text) {
        settings.sequence = parse_named("--sequence", text, sequence_names);
    });
    add(app, "--transmittance", "NAME", "through density grids: march, with an exact correction for one pair in 64, or exact (march)", [&](const auto& text) {
        settings.transmittance = parse_named("--transmittance", text, transmittance_names);
    });
    add(app, "--samples", "N", "samples of every pair of light and eye per pass (1)", [&](const auto& text) { settings.samples_per_pair = integer("--samples", text, 1, 256); });
    add(app, "--skip-thin", "SHARE", "leave media_to_media out if at most this share of what media scatter is scattered there again: .01 or 1% (never)",
        [&](const auto& text) { settings.skip_thin = parse_share("--skip-thin", text); });
    add_bias(app, settings);
    auto* longer = add_switch(app, "--long", "virtual ray lights reach the next surface (default)",
                              [&](bool on) { settings.segment_length = on ? SegmentLength::long_ : SegmentLength::short_; });
    add_switch(app, "--short", "virtual ray lights end at their sampled collision",
               [&](bool on) { settings.segment_length = on ? SegmentLength::short_ : SegmentLength::long_; })->excludes(longer);
}

void add_selection(CLI::App& app, RenderSettings& settings)
{
    add(app, "--select", "WHICH", "virtual lights of each pixel: auto, all, or tile: some, chosen by an estimate that a square of pixels shares", [&](const auto& text) {
        settings.selection = parse_named("--select", text, selection_names);
    });
    add(app, "--selected", "N", "so many virtual lights per pixel and pass (by rule)",
        [&](const auto& text) { settings.selected_lights = static_cast<std::uint32_t>(parse_integer("--selected", text, 1, 1 << 16)); });
    add(app, "--block", "PIXELS", "width of the squares that share an estimate: 4, 8 or 16 (by rule)",
        [&](const auto& text) { settings.selection_block = std::array{4, 8, 16}[parse_choice("--block", text, {"4", "8", "16"})]; });
    add(app, "--candidates", "N", "virtual lights chosen for a region of 8 x 8 squares, among which they choose, or all (by rule)",
        [&](const auto& text) { settings.candidates = text == "all" ? all_lights : static_cast<std::uint32_t>(parse_integer("--candidates", text, 1, 1 << 20)); });
    add(app, "--defence", "SHARE", "of the choice that goes by power alone: .1 or 10% (by rule)",
        [&](const auto& text) { settings.selection_defence = parse_share("--defence", text); });
    add(app, "--camera-samples", "N", "per pixel and pass, for virtual lights (by rule)",
        [&](const auto& text) { settings.camera_samples = integer("--camera-samples", text, 1, 64); });
}

void add_picture(CLI::App& app, ImageWishes& image)
{
    if (std::getenv("SOURCE_DATE_EPOCH")) image.timestamps = false;
    add(app, "--exposure", "STOPS", "brightness of the PNG (automatic: 95th percentile at .7)", [&](const auto& text) {
        if (text != "auto") image.exposure = parse_number("--exposure", text, -64, 64);
    });
    app.add_flag("--half", image.half, "16-bit colours in the EXR; variance and depth stay 32-bit");
    add_switch(app, "--no-timestamps", "nothing of the clock in the EXR: equal renders are byte-equal (also with SOURCE_DATE_EPOCH set)",
               [&](bool on) { image.timestamps = !on; });
}

void add_film(CLI::App& app, RenderCommand& command)
{
    add(app, "--resolution", "WxH", "film size in pixels; the scene's crop window is scaled with it",
        [&](const auto& text) { command.resolution = parse_resolution("--resolution", text); });
    add(app, "--crop", "X,Y,W,H", "render only this window of the film, in pixels from the top left",
        [&](const auto& text) { command.crop = parse_crop("--crop", text); });
    add_picture(app, command.image);
}

void add_blocks(CLI::App& app, RenderSettings& settings)
{
    add(app, "--block-passes", "N", "passes that are summed by themselves, the unit of shards; part of the result (8)",
        [&](const auto& text) { settings.block_passes = integer("--block-passes", text, 1, 1 << 16); });
}

void add_farm(CLI::App& app, RenderCommand& command)
{
    add(app, "--shard", "I/N", "only part I of N of the passes, into a .shard file for `tyndall merge`", [&](const auto& text) {
        const auto [number, of] = parse_shard("--shard", text);
        command.shard = {number, of};
    });
    add(app, "--checkpoint", "TIME", "save so often to go on from, off: never (30 s, in runs of more than a minute)",
        [&](const auto& text) {
            command.checkpoint_seconds = text == "off" ? 0 : parse_duration("--checkpoint", text);
        })->envname("TYNDALL_CHECKPOINT");
    app.add_flag("--resume", command.resume, "go on from the checkpoint beside the output, if there is one");
    add_blocks(app, command.settings);
}

void add_machine(CLI::App& app, RenderSettings& settings)
{
    add(app, "-d,--device", "DEVICE", "index, part of the name, or platform:device, as `tyndall devices` lists; several with commas, or all, share the work", [&](const auto& text) {
        settings.device = text;
    })->envname("TYNDALL_DEVICE");
    add(app, "--lanes", "N", "pixels per work-item: 1, 4, 8 or 16 (by device); part of the result", [&](const auto& text) {
        settings.lanes = parse_lanes("--lanes", text);
    })->envname("TYNDALL_LANES");
    add(app, "--threads", "N", "host threads (all cores); a CPU device has its own, which answer shadow segments too (PoCL: POCL_MAX_PTHREAD_COUNT)", [&](const auto& text) {
        settings.threads = integer("--threads", text, 1, 1024);
    })->envname("TYNDALL_THREADS");
    add(app, "--features", "NAMES", "build kernels for these features, comma-separated, all or own; what the scene needs must be among them (own)",
        [&](const auto& text) { settings.features = parse_features("--features", text); });
    add(app, "--precision", "NAME", "of the kernels: f32, or f64 where the device has it; part of the result (f32)",
        [&](const auto& text) { settings.precision = parse_named("--precision", text, precision_names); });
    add(app, "--math", "NAME", "of the kernels: strict, or fast, which lets compilers reorder and approximate and which no selftest covers (strict)",
        [&](const auto& text) { settings.math = parse_named("--math", text, math_names); });
    app.add_option("--dump-kernels", settings.dump_kernels, "write the source of every program that is built into this folder, to look at or to report")->type_name("FOLDER");
    add_switch(app, "--no-selftest", "render on a device that fails its selftest, or has not passed it yet, at your own risk",
               [&](bool on) { settings.selftest = !on; });
    add(app, "--tile", "PAIRS", "pairs per tile; never changes a byte of the image",
        [&](const auto& text) { settings.tile_pairs = static_cast<std::uint32_t>(parse_integer("--tile", text, 1, 1 << 30)); });
    add(app, "--launch-ms", "MS", "keep what the device does in one go below so many milliseconds (100); never changes a byte of the image",
        [&](const auto& text) { settings.launch_seconds = 1e-3 * parse_number("--launch-ms", text, 1, 1e6); });
}

void add_output(CLI::App& app, RenderCommand& command)
{
    app.add_option("-o,--output", command.output, "image, *.exr; PNG and report (JSON) are written beside it")->type_name("FILE");
    app.add_option("--report", command.report, "another name for the report")->type_name("FILE");
    add(app, "--progress", "STYLE", "auto, bar, plain, json (on standard output) or none (auto)", [&](const auto& text) {
        const auto choice = parse_choice("--progress", text, {"auto", "bar", "plain", "json", "none"});
        constexpr std::array styles{ProgressStyle::none, ProgressStyle::bar, ProgressStyle::plain, ProgressStyle::json,
                                    ProgressStyle::none};
        command.progress = choice == 0 ? std::nullopt : std::optional(styles[choice]);
    })->envname("TYNDALL_PROGRESS");
    add(app, "--display-server", "HOST:PORT", "show the image in the viewer tev while it is rendered (port 14158)",
        [&](const auto& text) { command.viewer = parse_viewer("--display-server", text); });
    app.add_flag("--strict-nan", command.strict_nan, "exit code 1 if a sample was not a finite number; it is left out and counted in any case");
}

}  // namespace

void add_setting_options(CLI::App& app, RenderSettings& settings)
{
    for (const auto add_group : {add_budget, add_layers, add_transport, add_selection, add_machine, add_blocks}) add_group(app, settings);
}

void add_merge_options(CLI::App& app, MergeCommand& command)
{
    app.add_option("shards", command.shards, "shard files of one render, in any order")->required()->type_name("FILE.shard");
    app.add_option("-o,--output", command.output, "image, *.exr; PNG and report (JSON) are written beside it")->required()->type_name("FILE");
    app.add_option("--report", command.report, "another name for the report")->type_name("FILE");
    add_picture(app, command.image);
    app.add_flag("--mixed-devices", command.mixed_devices, "take shards of different devices and drivers: as good an image, but not byte-equal to one run's");
}

void add_load_options(CLI::App& app, LoadOptions& options)
{
    app.add_option_function<std::vector<std::string>>(
           "-D,--define",
           [&](const std::vector<std::string>& texts) {
               for (const auto& text : texts)
                   options.definitions.insert_or_assign(parse_definition("-D", text).first, parse_definition("-D", text).second);
           },
           "value for a <default> of the scene; repeatable")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    app.add_flag("--allow-outside", options.allow_outside, "let the scene name files outside its own folder");
}

void add_explain_options(CLI::App& app, ExplainCommand& command)
{
    add_render_options(app, command.render);
    app.add_flag("--json", command.json, "as JSON");
    add(app, "--calibrate", "TIME", "about so long may be spent on measuring, 0: not at all (3 s)", [&](const auto& text) {
        command.calibration_seconds = text == "0" ? 0 : parse_duration("--calibrate", text);
    });
}

void add_render_options(CLI::App& app, RenderCommand& command)
{
    app.add_option("scene", command.scene, "scene file, Mitsuba 3 XML")->required()->type_name("SCENE.XML");
    add_output(app, command);
    add_budget(app, command.settings);
    add_film(app, command);
    add_layers(app, command.settings);
    add_transport(app, command.settings);
    add_selection(app, command.settings);
    add_machine(app, command.settings);
    add_farm(app, command);
    add_load_options(app, command.load);
}

}  // namespace tyndall
