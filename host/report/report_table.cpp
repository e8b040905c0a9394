#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "report/readable.hpp"
#include "report/report_output.hpp"

namespace tyndall {
namespace {

using Text = std::string;

template <class... Arguments>
void line(Text& table, const char* label, fmt::format_string<Arguments...> format, Arguments&&... arguments)
{
    fmt::format_to(std::back_inserter(table), "  {:<17}", label);
    fmt::format_to(std::back_inserter(table), format, std::forward<Arguments>(arguments)...);
    table += '\n';
}

std::string count(std::uint64_t value) { return readable_count(static_cast<double>(value)); }

void add_head(Text& table, const Report& report)
{
    line(table, "scene", "{}", terminal_safe(report.scene));
    line(table, "image", "{} x {}, {} passes, seed {}, method {}", report.width, report.height, report.passes, report.seed, report.method);
    if (!report.device.empty())
        line(table, "device", "{}, {} ({})", terminal_safe(report.device), readable_lanes(report.lanes, report.lanes_from), terminal_safe(report.driver));
    if (report.launches)
        line(table, "launches", "{}, the largest {}{}", count(report.launches), readable_seconds(report.largest_launch_seconds),
             report.wall_clock ? " by the wall clock: the device has none" : "");
    if (report.selftest && report.selftest->outcome != "passed before") line(table, "selftest", "{}", report.selftest->outcome);
    line(table, "time", "{} on {} threads, {} per pass, stopped by {}", readable_seconds(report.seconds), report.threads,
         readable_seconds(report.pass_seconds), report.stopped_by);
    const auto bound = std::isfinite(report.error_upper) ? fmt::format(", below {} with 95 % confidence", readable_percent(report.error_upper)) : "";
    const auto target = report.target_error > 0 ? fmt::format("; {} was asked for", readable_percent(report.target_error)) : "";
    line(table, "error", "{} (root of the estimated relative mean square error){}{}", readable_percent(report.error), bound, target);
    if (report.exposure) line(table, "exposure", "{:+.2f} stops", *report.exposure);
}

void add_counts(Text& table, const Report& report)
{
    line(table, "virtual lights", "{} from {} light paths", count(report.virtual_lights), count(report.light_paths));
    line(table, "eye segments", "{}, eye points {}", count(report.eye_segments), count(report.eye_points));
    if (!report.selection.empty()) line(table, "chosen lights", "{}", report.selection);
    if (report.pairs && report.seconds > 0)
        line(table, "pairs", "{} ({}/s), shadow segments {} ({}/s)", count(report.pairs),
             readable_count(static_cast<double>(report.pairs) / report.seconds), count(report.shadow_segments),
             readable_count(static_cast<double>(report.shadow_segments) / report.seconds));
}

void add_stages(Text& table, const Report& report)
{
    if (report.stages.empty()) return;
    table += "  stage                                seconds    share       count\n";
    for (const auto& stage : report.stages)
        fmt::format_to(std::back_inserter(table), "    {:<32} {:>9.3f}  {:>5.1f} %  {:>10}\n", terminal_safe(stage.stage), stage.seconds,
                       report.seconds > 0 ? 100 * stage.seconds / report.seconds : 0., count(stage.count));
}

void add_effects(Text& table, const Report& report)
{
    if (report.effects.empty()) return;
    Text found, absent;
    for (const auto& effect : report.effects) (effect.found ? found : absent) += " " + effect.effect;
    line(table, "effects found", "{}", found.empty() ? "none" : found.substr(1));
    line(table, "not in the scene", "{}", absent.empty() ? "none" : absent.substr(1));
}

void add_grids(Text& table, const Report& report)
{
    if (!report.grids.empty()) line(table, "density grids", "{}", report.grids);
}

void add_prediction(Text& table, const Report& report)
{
    if (!report.prediction) return;
    const Prediction& p = *report.prediction;
    line(table, "predicted", "{} for {} passes and an error of {}, from the first {} passes; it was {} for {} passes and {}", readable_seconds(p.seconds), p.passes,
         readable_percent(p.error), p.from_passes, readable_seconds(report.seconds), report.passes, readable_percent(report.error));
}

void add_savings(Text& table, const Report& report)
{
    for (const auto& saving : report.savings)
        line(table, "saved", "{}: {}{}", saving.what, saving.because,
             saving.predicted_seconds < 0 ? "" : ", predicted " + readable_seconds(saving.predicted_seconds) + " of processor time");
}

void add_layers(Text& table, const Report& report)
{
    for (const auto& layer : report.layers) {
        const auto what = layer.skipped ? "skipped: " + terminal_safe(layer.why) + (layer.unbiased ? "" : "; the image is too dark by that much") : layer.technique + (layer.unbiased ? "" : " (biased)");
        const auto error = layer.error >= 0 && std::isfinite(layer.error) ? ", error " + readable_percent(layer.error) : "";
        fmt::format_to(std::back_inserter(table), "  {:<26} {}{}\n", layer.layer, what, error);
        if (!layer.bias.empty()) fmt::format_to(std::back_inserter(table), "  {:<26}   biased: {}\n", "", layer.bias);
        if (layer.removed >= 0) fmt::format_to(std::back_inserter(table), "  {:<26}   clamping removed {} of its light\n", "", readable_percent(layer.removed));
    }
}

void add_ledger(Text& table, const NumericsLedger& ledger)
{
    const auto add = [&](const char* what, std::uint64_t cases) {
        if (cases) fmt::format_to(std::back_inserter(table), "  numerics: {} {}\n", cases, what);
    };
    add("pixels were not finite in one pass and count as 0 there", ledger.not_finite_pixels);
    add("pairs were not finite and count as 0", ledger.not_finite_pairs);
    add("rays or shadow segments were not finite and met nothing or counted as blocked", ledger.unsafe_shadow_segments);
    add("pairs all but crossed: the floor on their distance was active, which adds variance and no bias", ledger.floored_pairs);
    add("walks were ended because they crossed too many surfaces", ledger.runaway_walks);
    if (const WorstPairReport& worst = ledger.worst_pair; !worst.layer.empty())
        fmt::format_to(std::back_inserter(table), "  largest pair: radiance {:.4g} in {}, pass {}, pixel ({}, {}), {:.0f} % of what that pixel got there in that pass\n", worst.radiance,
                       worst.layer, worst.pass, worst.x, worst.y, 100 * worst.share_of_pixel);
    for (const auto& first : ledger.first_cases) fmt::format_to(std::back_inserter(table), "    {}\n", terminal_safe(first));
}

}  // namespace

std::string to_table(const Report& report)
{
    Text table;
    add_head(table, report);
    add_prediction(table, report);
    add_counts(table, report);
    add_effects(table, report);
    add_grids(table, report);
    add_savings(table, report);
    add_layers(table, report);
    add_stages(table, report);
    add_ledger(table, report.ledger);
    for (const auto& warning : report.warnings) fmt::format_to(std::back_inserter(table), "  warning: {}\n", terminal_safe(warning));
    for (const auto& output : report.outputs) fmt::format_to(std::back_inserter(table), "  wrote {}\n", terminal_safe(output));
    return table;
}

}  // namespace tyndall
