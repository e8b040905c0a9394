#include "comparison/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace tyndall {
namespace {

/// Nothing if it was stopped.
std::optional<Run> one_run(const Candidate& candidate, const Reference& reference, const MeasuringPlan& plan, const RenderFunction& render, const MeasuringHooks& hooks, std::uint64_t seed,
                           bool keep_layers)
{
    RenderSettings settings = candidate.settings;
    settings.passes = std::numeric_limits<int>::max(), settings.seconds = 0, settings.target_error = 0, settings.seed = seed;
    RunRecorder recorder(reference, plan.times, hooks.clock);
    bool stopped = false;
    const RenderOutcome outcome = render(settings, [&](const Progress& progress, const Film& film) {
        const bool go_on = recorder.after_pass(progress.seconds, film);
        stopped = go_on && hooks.stop();
        return go_on && !stopped;
    });
    if (stopped) return std::nullopt;
    return recorder.finish(outcome, seed, keep_layers);
}

void warm_up(const std::vector<Candidate>& candidates, const RenderFunction& render, const MeasuringHooks& hooks)
{
    for (const Candidate& candidate : candidates) {
        if (hooks.stop()) return;
        hooks.note("warming up: " + candidate.name);
        RenderSettings settings = candidate.settings;
        settings.passes = 1, settings.seconds = 0, settings.target_error = 0;
        render(settings, {});
    }
}

}  // namespace

std::vector<Measurement> measure(const std::vector<Candidate>& candidates, const Reference& reference, const MeasuringPlan& plan, const RenderFunction& render, const MeasuringHooks& hooks)
{
    std::vector<Measurement> measured;
    for (const Candidate& candidate : candidates) measured.push_back({candidate, {}});
    if (plan.warm_up) warm_up(candidates, render, hooks);
    const std::size_t n = candidates.size();
    for (int repeat = 0; repeat < plan.repeats && !hooks.stop(); ++repeat)
        for (std::size_t turn = 0; turn < n; ++turn) {
            const std::size_t c = (turn + static_cast<std::size_t>(repeat)) % n;
            hooks.note(fmt::format("run {} of {}: {}", repeat + 1, plan.repeats, candidates[c].name));
            const std::uint64_t seed = plan.seed + 1 + static_cast<std::uint64_t>(repeat) * n + c;
            auto run = one_run(candidates[c], reference, plan, render, hooks, seed, repeat == 0);
            if (!run) break;
            measured[c].runs.push_back(std::move(*run));
        }
    std::size_t whole = std::numeric_limits<std::size_t>::max();
    for (const Measurement& m : measured) whole = std::min(whole, m.runs.size());
    for (Measurement& m : measured) m.runs.resize(whole);
    return measured;
}

}  // namespace tyndall
