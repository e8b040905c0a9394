#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/report_output.hpp"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json rate(std::uint64_t count, double seconds) { return seconds > 0 ? number(static_cast<double>(count) / seconds) : Json(nullptr); }

Json counts_of(const Report& report)
{
    return {{"light_paths", report.light_paths},
            {"virtual_lights", report.virtual_lights},
            {"eye_segments", report.eye_segments},
            {"eye_points", report.eye_points},
            {"pairs", report.pairs},
            {"shadow_segments", report.shadow_segments},
            {"launches", report.launches},
            {"programs", report.programs}};
}

Json timings_of(const Report& report)
{
    return {{"seconds", number(report.seconds)},
            {"pass_seconds", number(report.pass_seconds)},
            {"before_seconds", number(report.before_seconds)},
            {"largest_launch_seconds", number(report.largest_launch_seconds)},
            {"launches_timed_by", report.wall_clock ? "wall clock" : "device"},
            {"pairs_per_second", rate(report.pairs, report.seconds)},
            {"shadow_segments_per_second", rate(report.shadow_segments, report.seconds)}};
}

Json stages_of(const Report& report)
{
    Json stages = Json::array();
    for (const auto& stage : report.stages)
        stages.push_back({{"stage", stage.stage},
                          {"seconds", number(stage.seconds)},
                          {"count", stage.count},
                          {"per_second", rate(stage.count, stage.seconds)}});
    return stages;
}

Json layers_of(const Report& report)
{
    Json layers = Json::array();
    for (const auto& layer : report.layers)
        layers.push_back({{"layer", layer.layer},
                          {"technique", layer.technique},
                          {"skipped", layer.skipped},
                          {"why", layer.why},
                          {"sampler", layer.sampler},
                          {"sampler_why", layer.sampler_why},
                          {"unbiased", layer.unbiased},
                          {"bias", layer.bias},
                          {"removed_by_clamp", layer.removed < 0 ? Json(nullptr) : number(layer.removed)},
                          {"error", layer.error < 0 ? Json(nullptr) : number(layer.error)},
                          {"left_out", layer.left_out > 0 ? number(layer.left_out) : Json(nullptr)}});
    return layers;
}

Json effects_of(const Report& report)
{
    Json effects = Json::object();
    for (const auto& effect : report.effects) effects[effect.effect] = effect.found;
    return effects;
}

Json causes_of(const Report& report)
{
    Json causes = Json::object();
    for (const auto& effect : report.effects)
        if (!effect.cause.empty()) causes[effect.effect] = effect.cause;
    return causes;
}

Json savings_of(const Report& report)
{
    Json savings = Json::array();
    for (const auto& saving : report.savings)
        savings.push_back({{"what", saving.what},
                           {"because", saving.because},
                           {"predicted_processor_seconds", saving.predicted_seconds < 0 ? Json(nullptr) : number(saving.predicted_seconds)}});
    return savings;
}

Json prediction_of(const Report& report)
{
    if (!report.prediction) return nullptr;
    const Prediction& p = *report.prediction;
    return {{"from_passes", p.from_passes},
            {"passes", p.passes},
            {"seconds", number(p.seconds)},
            {"pass_seconds", number(p.pass_seconds)},
            {"error", p.error < 0 ? Json(nullptr) : number(p.error)}};
}

Json worst_pair_of(const WorstPairReport& worst)
{
    if (worst.layer.empty()) return nullptr;
    return {{"layer", worst.layer}, {"pass", worst.pass}, {"x", worst.x}, {"y", worst.y}, {"radiance", worst.radiance}, {"share_of_pixel", worst.share_of_pixel}};
}

Json numerics_of(const NumericsLedger& ledger)
{
    return {{"not_finite_pixels", ledger.not_finite_pixels},
            {"not_finite_pairs", ledger.not_finite_pairs},
            {"unsafe_shadow_segments", ledger.unsafe_shadow_segments},
            {"floored_pairs", ledger.floored_pairs},
            {"runaway_walks", ledger.runaway_walks},
            {"worst_pair", worst_pair_of(ledger.worst_pair)},
            {"first_cases", ledger.first_cases}};
}

Json device_of(const Report& report)
{
    if (report.device.empty()) return nullptr;
    return {{"name", report.device}, {"driver", report.driver}, {"build_options", report.build_options}, {"lanes", report.lanes}, {"lanes_from", report.lanes_from}};
}

/// Seconds of the whole render at which the error would be 1 % and .1 %: variance falls with one over the passes.
Json seconds_to_error_of(const Report& report)
{
    if (!(report.error >= 0)) return nullptr;
    const double passes = report.seconds - report.before_seconds;
    const auto at = [&](double error) { return number(report.before_seconds + passes * report.error * report.error / (error * error)); };
    return {{"0.01", at(.01)}, {"0.001", at(.001)}};
}

Json selftest_of(const Report& report)
{
    if (!report.selftest) return nullptr;
    const SelftestReport& s = *report.selftest;
    return {{"outcome", s.outcome}, {"outputs", s.outputs}, {"seconds", number(s.seconds)}, {"remembered_in", s.remembered_in.empty() ? Json(nullptr) : Json(s.remembered_in)}};
}

}  // namespace

std::string to_json(const Report& report)
{
    Json json;
    json["schema"] = report_schema;
    json["version"] = report.version;
    json["scene"] = {{"file", report.scene}, {"hash", fmt::format("{:016x}", report.scene_hash)}};
    json["method"] = report.method;
    json["seed"] = fmt::to_string(report.seed);
    json["width"] = report.width, json["height"] = report.height, json["passes"] = report.passes;
    json["max_depth"] = report.max_depth < 0 ? Json(nullptr) : Json(report.max_depth);
    json["threads"] = report.threads;
    json["device"] = device_of(report);
    json["selftest"] = selftest_of(report);
    json["stopped_by"] = report.stopped_by;
    json["error"] = report.error < 0 ? Json(nullptr) : number(report.error);
    json["error_below_95"] = report.error < 0 ? Json(nullptr) : number(report.error_upper);
    json["target_error"] = report.target_error > 0 ? number(report.target_error) : Json(nullptr);
    json["seconds_to_error"] = seconds_to_error_of(report);
    json["exposure"] = report.exposure ? number(*report.exposure) : Json(nullptr);
    json["timings"] = timings_of(report);
    json["counts"] = counts_of(report);
    json["stages"] = stages_of(report);
    json["prediction"] = prediction_of(report);
    json["effects"] = effects_of(report);
    json["causes"] = causes_of(report);
    json["chosen_lights"] = report.selection.empty() ? Json(nullptr) : Json(report.selection);
    json["density_grids"] = report.grids.empty() ? Json(nullptr) : Json(report.grids);
    json["savings"] = savings_of(report);
    json["layers"] = layers_of(report);
    json["numerics"] = numerics_of(report.ledger);
    json["warnings"] = report.warnings;
    json["outputs"] = report.outputs;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tyndall
