/// A report as bytes, for state files (host/docs/farm.md). All fields are taken apart by name, so that a field which is missing here does not compile.
#include "report/report_bytes.hpp"

#include <algorithm>

#include "scene/byte_stream.hpp"

namespace tyndall {
namespace {

template <class Self, class T>
concept Is = std::is_same_v<std::remove_const_t<Self>, T>;

template <class Stream, class... Field>
void each(Stream& stream, Field&... field)
{
    (stream(field), ...);
}

}  // namespace

template <class Stream, Is<StageTime> Self>
void fields(Stream& s, Self& x)
{
    auto& [stage, seconds, count] = x;
    each(s, stage, seconds, count);
}

template <class Stream, Is<LayerReport> Self>
void fields(Stream& s, Self& x)
{
    auto& [layer, technique, skipped, why, unbiased, error, left_out, bias, removed, kept_light, removed_light, sampler, sampler_why] = x;
    each(s, layer, technique, skipped, why, unbiased, error, left_out, bias, removed, kept_light, removed_light, sampler, sampler_why);
}

template <class Stream, Is<EffectReport> Self>
void fields(Stream& s, Self& x)
{
    auto& [effect, found, cause] = x;
    each(s, effect, found, cause);
}

template <class Stream, Is<SavingReport> Self>
void fields(Stream& s, Self& x)
{
    auto& [what, because, predicted_seconds] = x;
    each(s, what, because, predicted_seconds);
}

template <class Stream, Is<Prediction> Self>
void fields(Stream& s, Self& x)
{
    auto& [from_passes, passes, seconds, error, pass_seconds] = x;
    each(s, from_passes, passes, seconds, error, pass_seconds);
}

template <class Stream, Is<WorstPairReport> Self>
void fields(Stream& s, Self& x)
{
    auto& [layer, pass, pixel_x, pixel_y, radiance, share_of_pixel] = x;
    each(s, layer, pass, pixel_x, pixel_y, radiance, share_of_pixel);
}

template <class Stream, Is<NumericsLedger> Self>
void fields(Stream& s, Self& x)
{
    auto& [not_finite_pairs, runaway_walks, unsafe_shadow_segments, floored_pairs, first_cases, worst_pair, not_finite_pixels] = x;
    each(s, not_finite_pairs, runaway_walks, unsafe_shadow_segments, floored_pairs, first_cases, worst_pair, not_finite_pixels);
}

template <class Stream, Is<SelftestReport> Self>
void fields(Stream& s, Self& x)
{
    auto& [outcome, outputs, seconds, remembered_in, warning] = x;
    each(s, outcome, outputs, seconds, remembered_in, warning);
}

template <class Stream, Is<Report> Self>
void fields(Stream& s, Self& x)
{
    auto& [scene, method, device, driver, build_options, scene_hash, seed, width, height, passes, threads, lanes, max_depth, light_paths,
           virtual_lights, eye_segments, eye_points, pairs, shadow_segments, launches, programs, lanes_from, seconds, largest_launch_seconds, pass_seconds,
           before_seconds, wall_clock, error, error_upper, target_error, stopped_by, selection, grids, effects, savings, prediction, selftest, layers, stages,
           warnings, ledger, version, exposure, outputs] = x;
    each(s, scene, method, device, driver, build_options, scene_hash, seed, width, height, passes, threads, lanes, max_depth, light_paths,
         virtual_lights, eye_segments, eye_points, pairs, shadow_segments, launches, programs, lanes_from, seconds, largest_launch_seconds, pass_seconds,
         before_seconds, wall_clock, error, error_upper, target_error, stopped_by, selection, grids, effects, savings, prediction, selftest, layers, stages,
         warnings, ledger, version, exposure, outputs);
}

void save(ByteWriter& writer, const Report& report) { writer(report); }

Report load_report(ByteReader& reader)
{
    Report report;
    reader(report);
    return report;
}

void add_counts(Report& report, const Report& other)
{
    report.light_paths += other.light_paths, report.virtual_lights += other.virtual_lights, report.eye_segments += other.eye_segments, report.eye_points += other.eye_points;
    report.pairs += other.pairs, report.shadow_segments += other.shadow_segments, report.launches += other.launches;
    report.seconds += other.seconds, report.before_seconds += other.before_seconds;
    report.largest_launch_seconds = std::max(report.largest_launch_seconds, other.largest_launch_seconds);
    for (const StageTime& stage : other.stages) {
        const auto found = std::ranges::find(report.stages, stage.stage, &StageTime::stage);
        if (found == report.stages.end()) report.stages.push_back(stage);
        else found->seconds += stage.seconds, found->count += stage.count;
    }
    for (std::size_t l = 0; l < std::min(report.layers.size(), other.layers.size()); ++l) {
        LayerReport& layer = report.layers[l];
        layer.kept_light += other.layers[l].kept_light, layer.removed_light += other.layers[l].removed_light;
        if (layer.removed >= 0) layer.removed = layer.removed_light > 0 ? layer.removed_light / (layer.removed_light + layer.kept_light) : 0;
    }
    NumericsLedger& sum = report.ledger;
    const NumericsLedger& more = other.ledger;
    sum.not_finite_pairs += more.not_finite_pairs, sum.runaway_walks += more.runaway_walks, sum.unsafe_shadow_segments += more.unsafe_shadow_segments;
    sum.floored_pairs += more.floored_pairs;
    if (more.worst_pair.radiance >= sum.worst_pair.radiance) sum.worst_pair = more.worst_pair;  // of equals the first
    sum.first_cases.insert(sum.first_cases.begin(), more.first_cases.begin(), more.first_cases.end());
}

}  // namespace tyndall
