#include "comparison/comparison_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/page_image.hpp"
#include "comparison/stage_costs.hpp"
#include "film/error_estimate.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json spread(const Spread& s) { return {{"median", number(s.median)}, {"low", number(s.low)}, {"high", number(s.high)}}; }

Json spread(const std::optional<Spread>& s) { return s ? spread(*s) : Json(nullptr); }

Json error_at(const ErrorAt& at)
{
    return {{"seconds", at.seconds}, {"relative_mse", spread(at.relative_mse)}, {"at_most", at.at_most}};
}

Json bias_of(const Summary& s)
{
    Json z = Json::array();
    for (const double block : s.blocks.z) z.push_back(std::isfinite(block) ? Json(std::round(100 * block) / 100) : Json(nullptr));
    return {{"relative", number(s.bias.relative)},
            {"half_width", number(s.bias.half_width)},
            {"z", number(s.bias.z)},
            {"significant", s.bias.significant()},
            {"sentence", sentence(s.bias)},
            {"lit_blocks", s.blocks.lit_blocks},
            {"block_chi_squared", number(s.blocks.chi_squared)},
            {"largest_block_z", number(s.blocks.largest_z)},
            {"largest_block_relative", number(s.blocks.largest_relative)},
            {"block_z", z}};
}

Json outliers_of(const Summary& s, int width)
{
    const int pixel = static_cast<int>(s.worst_pixel);
    return {{"runs", s.runs_with_outliers}, {"share_of_largest", number(s.share_of_largest)}, {"x", pixel % width}, {"y", pixel / width}};
}

Json runs_of(const Measurement& m)
{
    Json runs = Json::array();
    for (const Run& run : m.runs) runs.push_back({{"seed", fmt::to_string(run.seed)}, {"passes", run.curve.back().passes}, {"seconds", run.curve.back().seconds}});
    return runs;
}

/// Seconds per stage, summed over the runs.
Json stages_of(const Measurement& m)
{
    std::vector<StageCost> total;
    for (const Run& run : m.runs) {
        const auto costs = stage_costs(run.report);
        if (total.empty()) total = costs;
        else
            for (std::size_t i = 0; i < costs.size(); ++i) total[i].seconds += costs[i].seconds;
    }
    Json stages = Json::array();
    for (const StageCost& cost : total) stages.push_back({{"stage", cost.stage}, {"seconds", number(cost.seconds)}});
    return stages;
}

/// Error of each layer of the first run at its end, against the reference's.
Json layers_of(const Measurement& m, const Reference& reference)
{
    Json layers = Json::array();
    for (const auto& [layer, image] : m.runs.front().layers) {
        const auto expected = reference.layers.find(layer);
        if (expected == reference.layers.end()) continue;
        const auto floor = reference.layer_floors.find(layer);
        layers.push_back({{"layer", layer},
                          {"relative_mse", number(relative_mse(image, expected->second))},
                          {"floor", floor == reference.layer_floors.end() ? Json(nullptr) : number(floor->second)}});
    }
    return layers;
}

/// Errors as measured, the reference's noise included.
Json snapshots_of(const Measurement& m, const Reference& reference)
{
    Json snapshots = Json::array();
    for (const Snapshot& snapshot : m.runs.front().snapshots)
        snapshots.push_back({{"wanted_seconds", snapshot.wanted_seconds}, {"seconds", snapshot.seconds}, {"passes", snapshot.passes}, {"relative_mse", number(relative_mse(snapshot.image, reference.pixels))}});
    return snapshots;
}

Json candidate_of(const Comparison& c, std::size_t i)
{
    const Measurement& m = c.measurements[i];
    const Summary& s = c.judgement.summaries[i];
    Json json{{"name", m.candidate.name}, {"method", name(m.candidate.settings.method)}, {"render_command", c.about.render_commands.at(i)}};
    const Report& report = m.runs.front().report;
    json["device"] = report.device, json["unbiased"] = std::ranges::all_of(report.layers, &LayerReport::unbiased);
    json["runs"] = runs_of(m), json["snapshots"] = snapshots_of(m, c.reference);
    json["curve"] = json["at_times"] = Json::array();
    for (const ErrorAt& at : s.curve) json["curve"].push_back(error_at(at));
    for (const ErrorAt& at : s.at_times) json["at_times"].push_back(error_at(at));
    json["bias"] = bias_of(s), json["outliers"] = outliers_of(s, c.reference.width);
    json["slope"] = spread(s.slope), json["efficiency"] = spread(s.efficiency);
    json["rmse"] = spread(s.rmse), json["relative_mse"] = spread(s.relative_mse), json["trimmed_relative_mse"] = spread(s.trimmed_relative_mse);
    json["seconds_per_pass"] = spread(s.seconds_per_pass);
    json["stages"] = stages_of(m), json["layers"] = layers_of(m, c.reference);
    return json;
}

Json verdicts_of(const Comparison& c)
{
    Json verdicts = Json::array();
    for (const Verdict& v : c.judgement.verdicts)
        verdicts.push_back({{"seconds", v.seconds},
                            {"better", v.better},
                            {"worse", v.worse},
                            {"ratio", number(v.ratio)},
                            {"low", v.high > 0 ? number(v.low) : Json(nullptr)},
                            {"high", v.high > 0 ? number(v.high) : Json(nullptr)},
                            {"significant", v.significant},
                            {"sentence", sentence(v, c.measurements)}});
    return verdicts;
}

Json price_of(const std::optional<Price>& price)
{
    if (!price) return nullptr;
    const bool known = price->high > 0;
    return {{"ratio", number(price->ratio)}, {"low", known ? number(price->low) : Json(nullptr)}, {"high", known ? number(price->high) : Json(nullptr)}, {"told_apart", price->significant}};
}

/// A dial's other values, each with its price beside the usual one at the longest time.
Json values_of(const Comparison& c, const DialSweep& sweep)
{
    Json values = Json::array();
    for (const std::size_t other : sweep.others)
        values.push_back({{"candidate", other},
                          {"value", value_name(c.measurements[sweep.usual].candidate.name, c.measurements[other].candidate.name)},
                          {"biased", c.judgement.summaries[other].bias.significant()},
                          {"price", price_of(price(c.judgement, other, sweep.usual, c.plan.times.back()))}});
    return values;
}

Json dials_of(const Comparison& c)
{
    Json dials = Json::array();
    for (const DialSweep& sweep : c.sweeps) dials.push_back({{"dial", sweep.name}, {"usual_value", sweep.usual_value}, {"usual", sweep.usual}, {"values", values_of(c, sweep)}});
    return dials;
}

Json data_of(const Comparison& c)
{
    Json json{{"schema", "tyndall-comparison/1"}, {"version", c.about.version}, {"command", c.about.command}};
    json["scene"] = {{"file", c.about.scene_file}, {"hash", fmt::format("{:016x}", c.about.scene_hash)}};
    json["width"] = c.reference.width, json["height"] = c.reference.height, json["layer"] = c.about.layer;
    json["times"] = c.plan.times, json["repeats"] = c.measurements.empty() ? 0 : c.measurements.front().runs.size();
    json["reference"] = {{"origin", c.reference.origin}, {"error_known", c.reference.error_known}, {"relative_mse", number(c.reference.floor)}, {"mean", number(c.reference.whole.value)}};
    json["candidates"] = Json::array();
    for (std::size_t i = 0; i < c.measurements.size(); ++i) json["candidates"].push_back(candidate_of(c, i));
    json["verdicts"] = verdicts_of(c);
    if (!c.sweeps.empty()) json["dials"] = dials_of(c);
    json["warnings"] = c.about.warnings;
    for (const std::string& warning : c.reference.warnings) json["warnings"].push_back(warning);
    return json;
}

Json image_of(std::span<const Rgb> pixels, int width)
{
    const PageImage image = page_image(pixels, width);
    return {{"uri", image.uri}, {"exponent", image.exponent}};
}

void add_images(Json& json, const Comparison& c)
{
    const int width = c.reference.width;
    std::size_t layer_images = c.reference.layers.size(), count = 1;
    for (const Measurement& m : c.measurements) layer_images += m.runs.front().layers.size(), count += m.runs.front().snapshots.size();
    constexpr double bytes_per_pixel = 5;  // measured: 6 bytes, of which noise leaves some two thirds after compression, and a third more in base64
    const bool with_layers = static_cast<double>((count + layer_images) * c.reference.pixels.size()) * bytes_per_pixel <= most_page_bytes;
    if (!with_layers) json["warnings"].push_back("the page would be very large with an image per layer, so it has none; give a smaller --resolution to see them");
    json["reference"]["image"] = image_of(c.reference.pixels, width);
    if (with_layers)
        for (const auto& [layer, pixels] : c.reference.layers) json["reference"]["layer_images"][layer] = image_of(pixels, width);
    for (std::size_t i = 0; i < c.measurements.size(); ++i) {
        const Run& run = c.measurements[i].runs.front();
        Json& candidate = json["candidates"][i];
        for (std::size_t t = 0; t < run.snapshots.size(); ++t) candidate["snapshots"][t]["image"] = image_of(run.snapshots[t].image, width);
        if (with_layers)
            for (const auto& [layer, pixels] : run.layers) candidate["layer_images"][layer] = image_of(pixels, width);
    }
}

}  // namespace

std::string to_json(const Comparison& comparison) { return data_of(comparison).dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string to_page_data(const Comparison& comparison)
{
    Json json = data_of(comparison);
    add_images(json, comparison);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tyndall
