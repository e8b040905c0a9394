#include "comparison/recorder.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tyndall {
namespace {

double distance(const Snapshot& snapshot) { return std::abs(std::log(snapshot.seconds / snapshot.wanted_seconds)); }

}  // namespace

RunRecorder::RunRecorder(const Reference& reference, std::vector<double> times, Clock clock) : reference_(reference), times_(std::move(times)), clock_(std::move(clock))
{
    assert(!times_.empty() && std::ranges::is_sorted(times_));
    for (const double time : times_) run_.snapshots.push_back({.wanted_seconds = time});
}

void RunRecorder::keep_snapshots(double seconds, const std::vector<Rgb>& image, int passes)
{
    for (Snapshot& snapshot : run_.snapshots) {
        const Snapshot now{.wanted_seconds = snapshot.wanted_seconds, .seconds = seconds, .passes = passes};
        if (snapshot.passes && distance(snapshot) <= distance(now)) continue;
        snapshot = now, snapshot.image = image;
    }
}

bool RunRecorder::worth_a_point(double seconds) const
{
    constexpr double step = 1.1;
    if (run_.curve.empty() || seconds >= step * run_.curve.back().seconds) return true;
    return std::ranges::any_of(times_, [&](double time) { return seconds_ < time && seconds >= time; });
}

bool RunRecorder::after_pass(double seconds, const Film& film)
{
    const double start = clock_(), measured = seconds - recording_;
    const std::vector<Rgb> image = film.beauty();
    const int n = film.passes();
    if (before_.empty()) before_.assign(image.size(), Rgb(0));
    std::vector<Rgb> pass(image.size());
    for (std::size_t i = 0; i < image.size(); ++i) pass[i] = double(n) * image[i] - (n - 1.) * before_[i];
    run_.passes.add(pass, film.width());
    keep_snapshots(measured, image, n);
    if (worth_a_point(measured)) {
        run_.last = image_error(image, reference_.pixels);
        run_.curve.push_back({n, measured, run_.last.relative_mse, run_.last.trimmed_relative_mse});
    }
    before_ = image, seconds_ = measured;
    recording_ += clock_() - start;
    return measured < times_.back();
}

Run RunRecorder::finish(const RenderOutcome& outcome, std::uint64_t seed, bool keep_layers)
{
    run_.seed = seed, run_.report = outcome.report;
    run_.report.seconds = seconds_;  // without what recording took
    if (keep_layers)
        for (std::size_t l = 0; l < layer_count; ++l)
            if (const auto layer = static_cast<Layer>(l); outcome.film.has(layer)) run_.layers[std::string(name(layer))] = outcome.film.mean(layer);
    return std::move(run_);
}

}  // namespace tyndall
