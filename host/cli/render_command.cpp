#include "cli/render_command.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "cli/calibrated_lanes.hpp"
#include "cli/checkpoint.hpp"
#include "cli/exit_code.hpp"
#include "cli/explain_command.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/say.hpp"
#include "cli/version.hpp"
#include "cli/write_image.hpp"
#include "film/atomic_file.hpp"
#include "pipeline/render.hpp"
#include "report/readable.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

ProgressStyle chosen_style(const std::optional<ProgressStyle>& wanted)
{
    if (wanted) return *wanted;
    const char* terminal = std::getenv("TERM");
    const bool erases = terminal && *terminal && std::string_view(terminal) != "dumb";  // the bar is written over itself
    return erases && ::isatty(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::plain;
}

int terminal_columns()
{
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void print_warnings(const std::vector<std::string>& warnings)
{
    for (const auto& warning : warnings) say(stderr, "warning: {}\n", terminal_safe(warning));
}

void print_start(const Scene& scene, const RenderSettings& settings, ProgressStyle style)
{
    if (style != ProgressStyle::bar && style != ProgressStyle::plain) return;
    const auto passes = settings.passes > 0 ? fmt::format(", {} passes", settings.passes) : "";
    const auto error = settings.target_error > 0 ? fmt::format(", to an error of {}", readable_percent(settings.target_error)) : "";
    const auto time = settings.seconds > 0 ? fmt::format(", at most {}", readable_seconds(settings.seconds)) : "";
    say(stderr, "rendering {}: {} x {} pixels{}{}{}\n", terminal_safe(scene.file), scene.camera.crop_width, scene.camera.crop_height,
        passes, time, error);
}

/// One render from its options to its files.
class RenderJob {
public:
    explicit RenderJob(RenderCommand& command)
        : command_(command),
          style_(chosen_style(command.progress)),
          shard_file_(command.shard.whole() ? std::filesystem::path() : plan_shard(command.scene, command.output, command.shard.number, command.shard.of)),
          paths_(command.shard.whole() ? plan_outputs(command.scene, command.output, command.report) : OutputPaths{}),
          checkpoint_(checkpoint_of(command.shard.whole() ? paths_.exr : shard_file_), command.checkpoint_seconds),
          view_(style_, style_ == ProgressStyle::json ? stdout : stderr, terminal_columns())
    {
    }

    int run()
    {
        Scene scene = load_scene(command_.scene, command_.load);
        if (const auto warning = take_calibrated_lanes(command_.settings); !warning.empty()) scene.warnings.push_back(warning);
        print_warnings(scene.warnings);
        override_film(scene.camera, command_.resolution, command_.crop);
        if (command_.shard.whole()) check_outputs(paths_);
        else check_writable(shard_file_);
        RenderControl control{.program = version(), .shard = command_.shard, .earlier = earlier_state(), .earlier_name = checkpoint_.file().string()};
        if (command_.dry_run) return run_dry(scene, command_.settings, style_ == ProgressStyle::json);
        command_.settings.stop = &interrupt_.stop();
        print_start(scene, command_.settings, style_);
        control.progress = [&](const Progress& progress, const RenderState& state) { return after_pass(progress, state); };
        if (command_.viewer) live_.emplace(*command_.viewer, (command_.shard.whole() ? paths_.exr : shard_file_).string());
        const RenderState state = render_state(scene, command_.settings, std::move(control));
        view_.end_line();
        if (live_ && state.passes() > 0) live_->finish(state.films.back()), tell_of_viewer();
        if (interrupt_.signal()) return write_unfinished(state);
        if (command_.shard.whole() && state.passes() == 0) throw Error("no pass was finished, so there is nothing to write; give more --time");
        write_finished(state, scene);
        return exit_code(state);
    }

private:
    /// What an earlier run left, if --resume asks for it.
    std::optional<RenderState> earlier_state()
    {
        const std::string file = terminal_safe(checkpoint_.file().string());
        if (command_.resume) {
            auto state = checkpoint_.read();
            if (state) say(stderr, "going on from {}: {} passes are done\n", file, state->passes());
            else say(stderr, "there is no {} to go on from: starting with the first pass\n", file);
            return state;
        }
        if (checkpoint_.enabled() && std::filesystem::exists(checkpoint_.file()))
            say(stderr, "note: {} is left of an earlier render; --resume would go on from it, this render may write over it\n", file);
        return std::nullopt;
    }

    bool after_pass(const Progress& progress, const RenderState& state)
    {
        interrupt_.expect_writing();
        view_.show(progress);
        if (live_) live_->offer(state.films.back()), tell_of_viewer();
        if (interrupt_.take_request()) write_now(state);
        else checkpoint_.after_pass(progress, state);
        return interrupt_.signal() == 0;
    }

    void tell_of_viewer()
    {
        const std::string warning = live_->take_warning();
        if (warning.empty()) return;
        view_.end_line();
        print_warnings({warning});
    }

    /// SIGUSR1: a failure is a warning, the render goes on.
    void write_now(const RenderState& state)
    {
        view_.end_line();
        try {
            checkpoint_.save(state);
            if (command_.shard.whole()) write_image(paths_, state, command_.image);
            say(stderr, "wrote what there is after {} passes; the render goes on\n", state.passes());
        } catch (const IoError& error) {
            say(stderr, "warning: {}; the render goes on\n", terminal_safe(error.what()));
        }
    }

    int write_unfinished(const RenderState& state)
    {
        std::exception_ptr failure;
        try {
            checkpoint_.save(state);
        } catch (const IoError&) {
            failure = std::current_exception();  // the image may still find room
        }
        std::vector<std::string> outputs;
        if (command_.shard.whole()) {
            const Report report = write_image(paths_, state, command_.image);
            if (style_ != ProgressStyle::none) print_summary(report, state.report.warnings);
            outputs = report.outputs;
        }
        if (failure) std::rethrow_exception(failure);
        if (checkpoint_.enabled()) say(stderr, "{} passes are in {}; the same command with --resume goes on\n", state.passes(), terminal_safe(checkpoint_.file().string()));
        print_outputs("interrupt", outputs, style_);
        return exit_after_signal + interrupt_.signal();
    }

    void write_finished(const RenderState& state, const Scene& scene)
    {
        std::vector<std::string> outputs{shard_file_.string()};
        try {
            if (command_.shard.whole()) {
                const Report report = write_image(paths_, state, command_.image);
                if (style_ != ProgressStyle::none) print_summary(report, scene.warnings);
                outputs = report.outputs;
                not_finite_ = report.ledger.not_finite_pixels + report.ledger.not_finite_pairs;
            } else {
                write_state(shard_file_, state);
            }
        } catch (const IoError&) {
            keep_what_was_rendered(state);
            throw;
        }
        checkpoint_.remove();
        print_outputs(state.report.stopped_by, outputs, style_);
    }

    /// The output could not be written: perhaps the checkpoint can.
    void keep_what_was_rendered(const RenderState& state)
    {
        try {
            checkpoint_.save(state);
            if (checkpoint_.enabled()) say(stderr, "the passes are in {}; --resume writes the output without rendering again\n", terminal_safe(checkpoint_.file().string()));
        } catch (const IoError&) {
        }
    }

    int exit_code(const RenderState& state) const
    {
        if (command_.strict_nan && not_finite_ > 0) {
            say(stderr, "tyndall: {} samples were not finite numbers and were left out, which --strict-nan takes for a failure; the report names the first; please report it with the scene\n", not_finite_);
            return static_cast<int>(ExitCode::internal);
        }
        const bool missed = command_.settings.target_error > 0 && state.report.stopped_by != "target error";
        return static_cast<int>(missed ? ExitCode::target_not_reached : ExitCode::ok);
    }

    RenderCommand& command_;
    ProgressStyle style_;
    std::filesystem::path shard_file_;
    OutputPaths paths_;
    Checkpoint checkpoint_;
    ProgressView view_;
    InterruptGuard interrupt_;
    std::optional<LiveView> live_;
    std::uint64_t not_finite_ = 0;  ///< samples
};

}  // namespace

int run_render(RenderCommand command)
{
    give_default_budget(command.settings);
    if (!command.shard.whole() && (command.settings.seconds > 0 || command.settings.target_error > 0))
        throw UsageError("--shard is a part of a number of passes: give --passes, neither --time nor --target-error");
    return RenderJob(command).run();
}

}  // namespace tyndall
