#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "cli/calibrated_lanes.hpp"
#include "cli/compare_command.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/parse_values.hpp"
#include "cli/render_command.hpp"
#include "cli/render_line.hpp"
#include "cli/say.hpp"
#include "cli/version.hpp"
#include "comparison/comparison_json.hpp"
#include "device/device_list.hpp"
#include "film/atomic_file.hpp"
#include "kernels/shared/host_features.hpp"
#include "lights/light_technique.hpp"
#include "path_tracing/path_tracing.hpp"
#include "pipeline/choose_sampler.hpp"
#include "pipeline/layer_plan.hpp"
#include "pipeline/light_selection_plan.hpp"
#include "report/comparison_page.hpp"
#include "report/readable.hpp"
#include "tyndall/error.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

namespace fs = std::filesystem;

Method unbiased_or_path(Method method)
{
    const LightTechnique* technique = technique_of(method);
    return technique && technique->unbiased && !is_clamped(method) ? method : Method::path;
}

/// Fills in what was not given, and puts the times in order.
void complete(CompareCommand& command)
{
    if (command.every_dial && (command.methods.size() > 1 || !command.dials.empty()))
        throw UsageError("--dials turns every dial of one method; name one with --methods and leave the other lists out");
    if (command.methods.empty()) command.methods = command.every_dial ? std::vector{Method::vrl} : std::vector{Method::vrl, Method::path};
    if (command.times.empty()) command.times = {1, 6};
    std::ranges::sort(command.times);
    command.times.erase(std::unique(command.times.begin(), command.times.end()), command.times.end());
    // What dials turn is far less noisy than path tracing where it pays at all, and its differences are small: the reference must be better still.
    if (command.every_dial && !command.reference_method) command.reference_method = unbiased_or_path(command.methods.front());
    if (!command.reference_seconds) command.reference_seconds = (command.every_dial ? 30 : 4) * command.times.back();
    if (command.output.empty()) command.output = fs::path(command.inputs.front().stem()) += "_compare";
    if (!command.layers.empty()) command.settings.layers = {};
    for (const std::string& layer : command.layers) parse_layers("--layer", layer, command.settings.layers);
}

/// Makes the folder, and finds out before an hour of measuring whether its files can be written.
void prepare_output(const fs::path& folder)
{
    make_folder(folder);
    for (const char* file : {"index.html", "comparison.json", "reference.exr"}) check_writable(folder / file);
}

Reference load_reference(const CompareCommand& command, const Scene& scene)
{
    const ImageFile file = load_image_file(command.reference, command.layers);
    const Camera& camera = scene.camera;
    require_same_window({.file = scene.file, .x = camera.crop_x, .y = camera.crop_y, .width = camera.crop_width, .height = camera.crop_height}, file);
    Reference reference = reference_from_file(file, file.method == name(Method::path), fmt::format("{:016x}", scene.hash));
    reference.layers = load_known_layers(command.reference);
    return reference;
}

Reference make_and_write_reference(const CompareCommand& command, const Scene& scene, const RenderFunction& render, const InterruptGuard& interrupt)
{
    RenderSettings settings = command.settings;
    settings.method = command.reference_method.value_or(Method::path);
    say(stderr, "reference: {}, about {}\n", name(settings.method), readable_seconds(*command.reference_seconds));
    MadeReference made = make_reference(render, settings, *command.reference_seconds, [&] { return interrupt.signal() != 0; });
    if (settings.method == Method::path)
        for (const std::string& sentence : uncarried_light(scene)) made.reference.warnings.push_back("the reference lacks light: " + sentence);
    made.outcome.report.version = version();
    write_outputs({command.output / "reference.exr", command.output / "reference.png", command.output / "reference.json"}, made.outcome.film,
                  {scene.camera.crop_x, scene.camera.crop_y, scene.camera.width, scene.camera.height}, {.timestamps = false}, settings.layers, made.outcome.report);
    return std::move(made.reference);
}

bool limited_by_the_reference(const Judgement& judgement)
{
    return std::ranges::any_of(judgement.summaries, [](const Summary& s) { return std::ranges::any_of(s.at_times, &ErrorAt::at_most); });
}

ComparisonAbout about(const CompareCommand& command, const Scene& scene, const std::vector<Measurement>& measurements, const Judgement& judgement)
{
    ComparisonAbout about{.version = version(), .scene_file = scene.file, .layer = command.layers.empty() ? "image" : "", .scene_hash = scene.hash, .warnings = scene.warnings};
    for (const std::string& layer : command.layers) about.layer += (about.layer.empty() ? "" : " + ") + layer;
    about.command = command.invocation;
    if (limited_by_the_reference(judgement))
        about.warnings.emplace_back("some errors lie at the reference's own noise, so only bounds on them are known; give it more --reference-time, or another unbiased --reference-method");
    for (const Measurement& m : measurements) about.render_commands.push_back(render_line(command, m.candidate.settings));
    return about;
}

void write_page(const CompareCommand& command, const Comparison& comparison)
{
    const std::string json = to_json(comparison);
    write_atomically(command.output / "comparison.json", json);
    write_atomically(command.output / "index.html", comparison_page(to_page_data(comparison)));
    if (limited_by_the_reference(comparison.judgement)) say(stderr, "warning: {}\n", comparison.about.warnings.back());
    say(stderr, "{}", to_table(comparison));
    if (command.json) say("{}", json);
    else
        for (const char* file : {"index.html", "comparison.json"}) say("{}\n", (command.output / file).string());
}

EveryDial what_to_compare(const CompareCommand& command, const Scene& scene)
{
    if (!command.every_dial) return {candidates_of(command.settings, command.methods, command.dials), {}};
    RenderSettings base = command.settings;
    base.method = command.methods.front(), base.seconds = command.times.back();
    const DeviceInfo device = choose_device(base.device);
    const SelectionPlan plan = plan_selection(base, scene.camera);
    const SceneFeatures features = features_for(scene, base);
    const std::string sampler = sampler_name(choose_sampler(scene, features, base.sampler).sampler);
    const std::uint32_t mask = features.media_to_media | features.media_to_surface;
    base.seconds = 0;
    return every_dial(base, {.lights = plan.lights, .selected = plan.chosen ? plan.slots : plan.lights, .lanes = base.lanes ? base.lanes : device.default_lanes,
                             .sampler = parse_named("sampler", sampler, sampler_names), .anisotropic = (mask & feature_bit::anisotropic) != 0,
                             .grids = (mask & feature_bit::heterogeneous) != 0, .fp64 = device.fp64});
}

void say_how_long(const CompareCommand& command, std::size_t candidates)
{
    const double reference = command.reference.empty() ? *command.reference_seconds : 0, runs = static_cast<double>(candidates) * command.repeats * command.times.back();
    say(stderr, "{} to compare, {} runs of each: about {}\n", candidates, command.repeats, readable_seconds(reference + runs));
}

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

int compare_methods(CompareCommand& command)
{
    complete(command);
    if (const auto warning = take_calibrated_lanes(command.settings); !warning.empty()) say(stderr, "warning: {}\n", terminal_safe(warning));
    if (!command.every_dial) candidates_of(command.settings, command.methods, command.dials);  // what makes no sense is refused before anything is read
    Scene scene = load_scene(command.inputs.front(), command.load);
    for (const auto& warning : scene.warnings) say(stderr, "warning: {}\n", terminal_safe(warning));
    override_film(scene.camera, command.resolution, command.crop);
    const auto [candidates, sweeps] = what_to_compare(command, scene);
    prepare_output(command.output);
    const RenderFunction render_scene = [&](const RenderSettings& settings, const ProgressCallback& progress) {
        RenderSettings longest = settings;
        longest.seconds = command.times.back();  // what `render --time` of the longest time would choose
        return render(scene, with_plan(settings, plan_selection(longest, scene.camera)), progress);
    };
    say_how_long(command, candidates.size());
    InterruptGuard interrupt;
    interrupt.expect_writing();
    const Reference reference = command.reference.empty() ? make_and_write_reference(command, scene, render_scene, interrupt) : load_reference(command, scene);
    for (const auto& warning : reference.warnings) say(stderr, "warning: {}\n", terminal_safe(warning));
    const MeasuringPlan plan{.times = command.times, .repeats = command.repeats, .seed = command.settings.seed};
    const auto note = [](const std::string& sentence) { say(stderr, "{}\n", sentence); };
    const auto measurements = measure(candidates, reference, plan, render_scene, {[&] { return interrupt.signal() != 0; }, note, seconds_now});
    if (measurements.front().runs.empty()) throw Error("stopped before every method had one run, so there is nothing to write");
    const Judgement judgement = judge(measurements, reference, plan.times, sweeps.empty() ? all_pairs(candidates.size()) : pairs_of(sweeps));
    write_page(command, {about(command, scene, measurements, judgement), reference, plan, measurements, judgement, sweeps});
    return interrupt.signal() ? exit_after_signal + interrupt.signal() : static_cast<int>(ExitCode::ok);
}

}  // namespace tyndall
