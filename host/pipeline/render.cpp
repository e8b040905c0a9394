#include "pipeline/render.hpp"

#include <tbb/global_control.h>

#include <chrono>
#include <limits>
#include <optional>
#include <thread>

#include "film/error_estimate.hpp"
#include "path_tracing/path_tracing.hpp"
#include "pipeline/check_settings.hpp"
#include "pipeline/forecast.hpp"
#include "pipeline/pass_renderer.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Would one more pass of the usual length end after the budget? The time before the first pass (kernels, pilot) counts too.
bool time_is_up(const RenderSettings& settings, int passes, double seconds, double before)
{
    return settings.seconds > 0 && passes > 0 && seconds + (seconds - before) / passes > settings.seconds;
}

Progress progress_of(const RenderSettings& settings, const PassRenderer& renderer, const Film& film, double seconds, double before)
{
    Progress p{.passes_done = film.passes(), .passes_wanted = settings.passes, .seconds = seconds, .error = estimated_error(film)};
    const double in_passes = seconds - before;
    if (settings.target_error > 0) p.error_aimed_at = settings.target_error;
    if (p.error >= 0) p.seconds_to_error = std::max(in_passes * (p.error * p.error / (p.error_aimed_at * p.error_aimed_at) - 1), 0.0);
    const double by_passes = settings.passes > 0 ? in_passes / film.passes() * (settings.passes - film.passes()) : 1e300;
    const double by_time = settings.seconds > 0 ? std::max(settings.seconds - seconds, 0.0) : 1e300;
    p.seconds_left = std::min(by_passes, by_time);
    if (settings.target_error > 0 && p.seconds_to_error >= 0) p.seconds_left = std::min(p.seconds_left, p.seconds_to_error);
    if (p.seconds_left >= 1e300) p.seconds_left = std::numeric_limits<double>::infinity();  // until the target error, and nothing is known of it yet
    p.pairs_per_second = static_cast<double>(renderer.counts().pairs) / in_passes;
    p.shadow_segments_per_second = static_cast<double>(renderer.counts().shadow_segments) / in_passes;
    return p;
}

Report report_of(const Scene& scene, const RenderSettings& settings, const PassRenderer& renderer, const Film& film, double seconds)
{
    Report report{.scene = scene.file, .method = std::string(name(settings.method))};
    report.scene_hash = scene.hash, report.seed = settings.seed;
    report.width = film.width(), report.height = film.height(), report.passes = film.passes();
    report.threads = settings.threads ? settings.threads : static_cast<int>(std::thread::hardware_concurrency());
    report.seconds = seconds, report.pass_seconds = film.passes() ? seconds / film.passes() : 0;
    report.error = estimated_error(film), report.error_upper = error_upper_bound(film);
    report.target_error = settings.target_error;
    report.warnings = scene.warnings;
    for (std::string& sentence : uncarried_light(scene)) report.warnings.push_back(std::move(sentence));
    renderer.fill(report);
    for (std::size_t l = 0; l < report.layers.size(); ++l)  // one line per layer, in order
        if (film.has(static_cast<Layer>(l))) report.layers[l].error = estimated_error(film, static_cast<Layer>(l));
    return report;
}

}  // namespace

RenderOutcome render(const Scene& scene, const RenderSettings& settings, const ProgressCallback& progress)
{
    check_settings(settings);
    std::optional<tbb::global_control> threads;
    if (settings.threads > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(settings.threads));
    const Clock::time_point start = Clock::now();
    PassRenderer renderer(scene, settings);
    Film film(scene.camera.crop_width, scene.camera.crop_height, renderer.plan().rendered());
    const double before = seconds_since(start);
    Forecast forecast;
    std::string stopped_by = "passes";
    for (std::uint64_t pass = 0; settings.passes == 0 || pass < static_cast<std::uint64_t>(settings.passes); ++pass) {
        if (time_is_up(settings, film.passes(), seconds_since(start), before)) {
            stopped_by = "time";
            break;
        }
        const PassResult result = renderer.render(pass);
        film.add_pass(result.image, &result.features);
        forecast.after_pass(settings, film.passes(), seconds_since(start), [&] { return estimated_error(film); });
        if (progress && !progress(progress_of(settings, renderer, film, seconds_since(start), before), film)) {
            stopped_by = "interrupt";
            break;
        }
        if (settings.target_error > 0 && error_upper_bound(film) <= settings.target_error) {
            stopped_by = "target error";
            break;
        }
    }
    Report report = report_of(scene, settings, renderer, film, seconds_since(start));
    report.stopped_by = stopped_by, report.before_seconds = before, report.prediction = forecast.prediction();
    return {std::move(film), std::move(report)};
}

}  // namespace tyndall
