#include "cli/render_command.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/calibrated_lanes.hpp"
#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/version.hpp"
#include "pipeline/render.hpp"
#include "report/readable.hpp"
#include "report/report_output.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

ProgressStyle chosen_style(const std::optional<ProgressStyle>& wanted)
{
    if (wanted) return *wanted;
    return ::isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::plain;
}

int terminal_columns()
{
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void print_warnings(const std::vector<std::string>& warnings)
{
    for (const auto& warning : warnings) fmt::print(stderr, "warning: {}\n", terminal_safe(warning));
}

void print_start(const Scene& scene, const RenderSettings& settings, ProgressStyle style)
{
    if (style != ProgressStyle::bar && style != ProgressStyle::plain) return;
    const auto passes = settings.passes > 0 ? fmt::format(", {} passes", settings.passes) : "";
    const auto error = settings.target_error > 0 ? fmt::format(", to an error of {}", readable_percent(settings.target_error)) : "";
    const auto time = settings.seconds > 0 ? fmt::format(", at most {}", readable_seconds(settings.seconds)) : "";
    fmt::print(stderr, "rendering {}: {} x {} pixels{}{}{}\n", terminal_safe(scene.file), scene.camera.crop_width, scene.camera.crop_height,
               passes, time, error);
}

RenderOutcome render_with_progress(const Scene& scene, const RenderSettings& settings, ProgressStyle style, const InterruptGuard& interrupt)
{
    ProgressView view(style, style == ProgressStyle::json ? stdout : stderr, terminal_columns());
    return render(scene, settings, [&](const Progress& progress, const Film&) {
        view.show(progress);
        return interrupt.signal() == 0;
    });
}

/// What the pipeline cannot know: the film's ledger, the program's version, the warnings of the scene.
void complete_report(Report& report, const Film& film, const Scene& scene)
{
    report.version = version();
    report.ledger.not_finite_pixels = film.not_finite().count;
    for (const auto& pixel : film.not_finite().first_cases)
        report.ledger.first_cases.push_back(
            fmt::format("pass {}, layer {}, pixel ({}, {}) was not finite", pixel.pass, name(pixel.layer), pixel.x, pixel.y));
    for (const auto& warning : scene.warnings)
        if (std::ranges::find(report.warnings, warning) == report.warnings.end()) report.warnings.push_back(warning);
}

/// The table, without the warnings that were printed before the render started.
void print_summary(Report report, const Scene& scene)
{
    std::erase_if(report.warnings, [&](const auto& warning) { return std::ranges::find(scene.warnings, warning) != scene.warnings.end(); });
    fmt::print(stderr, "{}", to_table(report));
}

void print_outputs(const Report& report, ProgressStyle style)
{
    if (style == ProgressStyle::json) {
        const nlohmann::ordered_json event{{"event", "finished"}, {"stopped_by", report.stopped_by}, {"outputs", report.outputs}};
        fmt::print("{}\n", event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    } else {
        for (const auto& output : report.outputs) fmt::print("{}\n", output);
    }
}

}  // namespace

int run_render(RenderCommand command)
{
    give_default_budget(command.settings);
    const auto paths = plan_outputs(command.scene, command.output, command.report);
    Scene scene = load_scene(command.scene, command.load);
    if (const auto warning = take_calibrated_lanes(command.settings); !warning.empty()) scene.warnings.push_back(warning);
    print_warnings(scene.warnings);
    override_film(scene.camera, command.resolution, command.crop);
    check_outputs(paths);
    const auto style = chosen_style(command.progress);
    const InterruptGuard interrupt;
    print_start(scene, command.settings, style);
    RenderOutcome outcome = render_with_progress(scene, command.settings, style, interrupt);
    if (outcome.film.passes() == 0) throw Error("no pass was finished, so there is nothing to write; give more --time");
    complete_report(outcome.report, outcome.film, scene);
    write_outputs(paths, outcome.film, scene.camera, {command.exposure, command.half, command.settings.layers, command.timestamps}, outcome.report);
    if (style != ProgressStyle::none) print_summary(outcome.report, scene);
    print_outputs(outcome.report, style);
    if (interrupt.signal()) return exit_after_signal + interrupt.signal();
    const bool missed = command.settings.target_error > 0 && outcome.report.stopped_by != "target error";
    return static_cast<int>(missed ? ExitCode::target_not_reached : ExitCode::ok);
}

}  // namespace tyndall
