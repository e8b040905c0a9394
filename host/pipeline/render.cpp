#include "pipeline/render.hpp"

#include <fmt/format.h>
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
#include "tyndall/error.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A render that goes on pass by pass.
class Run {
public:
    Run(const Scene& scene, const RenderSettings& settings, RenderControl&& control)
        : scene_(scene), settings_(settings), control_(std::move(control)), start_(Clock::now()), renderer_(scene, settings)
    {
        begin();
        if (control_.earlier) go_on();
        before_ += seconds_since(start_);
    }

    RenderState finished()
    {
        state_.report.stopped_by = pass_loop();
        state_.finished = state_.report.stopped_by != "interrupt";
        state_.report.seconds = seconds(), state_.report.before_seconds = before_;
        state_.report.prediction = first_session() ? forecast_.prediction() : state_.report.prediction;
        if (state_.shard.whole()) describe_film(state_.report, state_.films[0]);
        state_.report.pass_seconds = done_ ? state_.report.seconds / done_ : 0;
        return std::move(state_);
    }

private:
    Film empty_film(int first_pass) const
    {
        return Film(scene_.camera.crop_width, scene_.camera.crop_height, renderer_.plan().rendered(), {.block_passes = settings_.block_passes, .first_pass = first_pass});
    }
    double seconds() const { return earlier_seconds_ + seconds_since(start_); }
    bool first_session() const { return earlier_passes_ == 0; }

    void begin()
    {
        const Camera& camera = scene_.camera;
        state_.settings = {{"version", control_.program}, {"scene hash", fmt::format("{:016x}", scene_.hash)}};
        for (StateSetting& setting : renderer_.settings()) state_.settings.push_back(std::move(setting));
        state_.shard = control_.shard, state_.run_passes = settings_.passes;
        state_.range = passes_of(control_.shard, settings_.passes, settings_.block_passes);
        state_.window = {camera.crop_x, camera.crop_y, camera.width, camera.height}, state_.asked = settings_.layers;
        if (state_.shard.whole()) state_.films.push_back(empty_film(0));
        fill_report();
    }

    /// Takes the films and counts of the earlier state, after checking that it is one of this render.
    void go_on()
    {
        RenderState& earlier = *control_.earlier;
        std::vector<std::string> wrong = differences(state_.settings, earlier.settings, control_.earlier_name);
        if (earlier.shard.number != state_.shard.number || earlier.shard.of != state_.shard.of || (!state_.shard.whole() && earlier.run_passes != state_.run_passes))
            wrong.push_back(fmt::format("{} is of shard {}/{} of {} passes (0/0: not a shard)", control_.earlier_name, earlier.shard.number, earlier.shard.of, earlier.run_passes));
        for (const Film& film : earlier.films)
            if (!film.same_kind(empty_film(0))) wrong.push_back("its film is not that of its settings");
        if (!wrong.empty()) throw SceneError(fmt::format("{}: is of another render, so this one cannot go on from it: {}", control_.earlier_name, fmt::join(wrong, "; ")));
        renderer_.continue_from(earlier.report);
        state_.films = std::move(earlier.films);
        earlier_passes_ = done_ = state_.passes(), earlier_seconds_ = earlier.report.seconds, before_ = earlier.report.before_seconds;
        state_.report.prediction = earlier.report.prediction;
        control_.earlier.reset();
        fill_report();
    }

    /// Counts and times as they are after a whole pass: one that is abandoned leaves no trace.
    void fill_report()
    {
        Report report{.scene = scene_.file, .method = std::string(name(settings_.method))};
        report.version = control_.program, report.scene_hash = scene_.hash, report.seed = settings_.seed, report.passes = done_;
        report.threads = settings_.threads ? settings_.threads : static_cast<int>(std::thread::hardware_concurrency());
        report.seconds = seconds(), report.before_seconds = before_, report.target_error = settings_.target_error;
        report.error = -1, report.error_upper = std::numeric_limits<double>::infinity();  // until describe_film
        report.width = scene_.camera.crop_width, report.height = scene_.camera.crop_height;
        report.warnings = scene_.warnings;
        if (renderer_.plan().paths_seek_lights())
            for (std::string& sentence : uncarried_light(scene_)) report.warnings.push_back(std::move(sentence));
        report.prediction = state_.report.prediction;
        renderer_.fill(report);
        state_.report = std::move(report);
    }

    /// Would one more pass of the usual length end after the budget? The time before the first pass (kernels, pilot) counts too.
    bool time_is_up() const { return settings_.seconds > 0 && done_ > 0 && seconds() + (seconds() - before_) / done_ > settings_.seconds; }

    /// Why it ended.
    std::string pass_loop()
    {
        for (int pass = state_.range.first + done_; settings_.passes == 0 || pass < state_.range.end; ++pass) {
            if (time_is_up()) return "time";
            if (target_reached()) return "target error";
            if (!add_pass(pass)) return "interrupt";
            if (control_.progress && !control_.progress(progress(), state_)) return target_reached() ? "target error" : "interrupt";
        }
        return target_reached() ? "target error" : "passes";
    }

    bool target_reached() const { return settings_.target_error > 0 && state_.shard.whole() && error_upper_bound(state_.films[0]) <= settings_.target_error; }

    /// False if it was abandoned.
    bool add_pass(int pass)
    try {
        throw_if_raised(settings_.stop);
        const PassResult result = renderer_.render(static_cast<std::uint64_t>(pass));
        if (!state_.shard.whole() && pass % settings_.block_passes == 0) state_.films.push_back(empty_film(pass));
        state_.films.back().add_pass(result.image, &result.features);
        ++done_;
        fill_report();
        if (first_session()) forecast_.after_pass(settings_, done_, seconds(), [&] { return error(); });
        return true;
    } catch (const Stopped&) {
        return false;
    }

    double error() const { return state_.shard.whole() ? estimated_error(state_.films[0]) : -1; }

    Progress progress() const
    {
        const int wanted = state_.range.end - state_.range.first;
        Progress p{.passes_done = done_, .passes_wanted = settings_.passes > 0 ? wanted : 0, .seconds = seconds(), .error = error()};
        const double in_passes = p.seconds - before_;
        if (settings_.target_error > 0) p.error_aimed_at = settings_.target_error;
        if (p.error >= 0) p.seconds_to_error = std::max(in_passes * (p.error * p.error / (p.error_aimed_at * p.error_aimed_at) - 1), 0.0);
        const double by_passes = settings_.passes > 0 ? in_passes / done_ * (wanted - done_) : 1e300;
        const double by_time = settings_.seconds > 0 ? std::max(settings_.seconds - p.seconds, 0.0) : 1e300;
        p.seconds_left = std::min(by_passes, by_time);
        if (settings_.target_error > 0 && p.seconds_to_error >= 0) p.seconds_left = std::min(p.seconds_left, p.seconds_to_error);
        if (p.seconds_left >= 1e300) p.seconds_left = std::numeric_limits<double>::infinity();  // until the target error, and nothing is known of it yet
        p.pairs_per_second = static_cast<double>(renderer_.counts().pairs) / in_passes;
        p.shadow_segments_per_second = static_cast<double>(renderer_.counts().shadow_segments) / in_passes;
        return p;
    }

    const Scene& scene_;
    const RenderSettings& settings_;
    RenderControl control_;
    Clock::time_point start_;
    PassRenderer renderer_;
    RenderState state_;
    Forecast forecast_;
    int done_ = 0, earlier_passes_ = 0;  ///< passes in the films
    double before_ = 0, earlier_seconds_ = 0;
};

}  // namespace

void describe_film(Report& report, const Film& film)
{
    report.width = film.width(), report.height = film.height(), report.passes = film.passes();
    report.error = estimated_error(film), report.error_upper = error_upper_bound(film);
    for (std::size_t l = 0; l < report.layers.size(); ++l)  // one line per layer, in order
        if (film.has(static_cast<Layer>(l))) report.layers[l].error = estimated_error(film, static_cast<Layer>(l));
}

RenderState render_state(const Scene& scene, const RenderSettings& settings, RenderControl control)
{
    check_settings(settings);
    if (!control.shard.whole() && settings.passes == 0) throw UsageError("a shard is a part of a number of passes: give --passes");
    std::optional<tbb::global_control> threads;
    if (settings.threads > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(settings.threads));
    return Run(scene, settings, std::move(control)).finished();
}

RenderOutcome render(const Scene& scene, const RenderSettings& settings, const ProgressCallback& progress)
{
    RenderControl control;
    if (progress) control.progress = [&](const Progress& p, const RenderState& state) { return progress(p, state.films[0]); };
    RenderState state = render_state(scene, settings, std::move(control));
    return {std::move(state.films[0]), std::move(state.report)};
}

}  // namespace tyndall
