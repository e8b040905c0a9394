#include "throughput/throughput_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "report/readable.hpp"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Spread& spread) { return {{"median", spread.median}, {"low", spread.low}, {"high", spread.high}}; }

std::vector<std::string> kernels_of(const ThroughputResult& result)
{
    std::vector<std::string> names;
    for (const KernelRate& rate : result.rates)
        if (names.empty() || names.back() != rate.kernel) names.push_back(rate.kernel);
    return names;
}

std::vector<int> widths_of(const ThroughputResult& result)
{
    std::vector<int> widths;
    for (const KernelRate& rate : result.rates)
        if (std::ranges::find(widths, rate.lanes) == widths.end()) widths.push_back(rate.lanes);
    std::ranges::sort(widths);
    return widths;
}

std::string head_of(int lanes) { return lanes == 0 ? "scalar" : fmt::format("{} lane{}", lanes, lanes == 1 ? "" : "s"); }

std::string words_of(const Spread& s) { return fmt::format("{} ({} – {})", readable_count(s.median), readable_count(s.low), readable_count(s.high)); }

/// What `fastest_lanes` found, as a sentence.
std::string verdict(const std::vector<int>& fastest)
{
    std::string text = fmt::format("{} lane{}", fastest.front(), fastest.front() == 1 ? "" : "s");
    for (std::size_t i = 1; i < fastest.size(); ++i) text += fmt::format("{}{}", i == 1 ? "; no difference measured to " : ", ", fastest[i]);
    return text;
}

Json kernel_json(const ThroughputResult& result, const std::string& kernel)
{
    Json json{{"kernel", kernel}, {"scalar_pairs_per_second", nullptr}, {"lanes", Json::array()}, {"fastest_lanes", fastest_lanes(result, kernel)}};
    if (const KernelRate* scalar = rate_of(result, kernel, 0)) json["scalar_pairs_per_second"] = json_of(scalar->pairs_per_second);
    for (const int lanes : widths_of(result))
        if (const KernelRate* rate = lanes ? rate_of(result, kernel, lanes) : nullptr) json["lanes"].push_back({{"lanes", lanes}, {"pairs_per_second", json_of(rate->pairs_per_second)}});
    return json;
}

std::string speedup_words(const ThroughputResult& result)
{
    const KernelRate *ours = rate_of(result, "henyey_greenstein", result.default_lanes), *scalar = rate_of(result, "henyey_greenstein", 0);
    if (!ours || !scalar) return fmt::format("speed-up over the scalar kernel: not measured, {} lanes are not among --lanes\n", result.default_lanes);
    const auto speedup = speedup_over_scalar(result);
    if (!speedup) return "speed-up over the scalar kernel: no difference measured\n";
    return fmt::format("speed-up over the scalar kernel: {:.1f} ({:.1f} – {:.1f}), henyey_greenstein at {} lanes\n", speedup->median, speedup->low, speedup->high, result.default_lanes);
}

}  // namespace

std::string clock_words(const ThroughputResult& result)
{
    if (result.processor_time) return "processor time of one core";
    return result.cores == Cores::one && !result.device.is_cpu ? "time on the wall of the whole device" : "time on the wall, all compute units";
}

std::string to_json(const ThroughputResult& result, const std::string& version)
{
    Json json;
    json["schema"] = throughput_schema;
    json["version"] = version;
    json["device"] = {{"name", result.device.name}, {"platform", result.device.platform}, {"vendor", result.device.vendor}, {"driver", result.device.driver},
                      {"is_cpu", result.device.is_cpu}, {"compute_units", result.device.compute_units}, {"default_lanes", result.default_lanes}};
    json["cores"] = result.cores == Cores::one ? "one" : "all";
    json["clock"] = result.processor_time ? "processor" : "wall";
    json["rounds"] = result.rounds;
    json["build_seconds"] = result.build_seconds, json["seconds"] = result.seconds;
    const auto speedup = speedup_over_scalar(result);
    json["speedup_over_scalar"] = speedup ? Json(speedup->median) : Json(nullptr);
    json["speedup_over_scalar_range"] = speedup ? Json{speedup->low, speedup->high} : Json(nullptr);
    json["agreeing_sums"] = result.agreeing ? Json(*result.agreeing) : Json(nullptr);
    json["kernels"] = Json::array();
    for (const std::string& kernel : kernels_of(result)) json["kernels"].push_back(kernel_json(result, kernel));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_table(const ThroughputResult& result)
{
    const auto widths = widths_of(result);
    std::string text = fmt::format("{}: {}, driver {}\n", terminal_safe(result.device.platform), terminal_safe(result.device.name), terminal_safe(result.device.driver));
    text += fmt::format("pairs of a light and an eye per second, {}: median (lowest – highest) of {} rounds taken in turns, nothing occludes\n", clock_words(result), result.rounds);
    text += fmt::format("{:<28}", "");
    for (const int lanes : widths) text += fmt::format("{:<28}", head_of(lanes));
    text += "fastest\n";
    for (const std::string& kernel : kernels_of(result)) {
        text += fmt::format("{:<28}", kernel);
        for (const int lanes : widths) {
            const KernelRate* rate = rate_of(result, kernel, lanes);
            text += fmt::format("{:<28}", rate ? words_of(rate->pairs_per_second) : "");
        }
        text += verdict(fastest_lanes(result, kernel)) + "\n";
    }
    text += speedup_words(result);
    return text + fmt::format("built in {}, measured in {}\n", readable_seconds(result.build_seconds), readable_seconds(result.seconds));
}

std::string to_table(const LaneChoice& choice, const ThroughputResult& result)
{
    std::string text = fmt::format("{}: {}, driver {}: {} lanes", terminal_safe(result.device.platform), terminal_safe(result.device.name), terminal_safe(result.device.driver), choice.lanes);
    if (choice.lanes != choice.by_rule) text += fmt::format(", measured to be faster than the {} of the rule\n", choice.by_rule);
    else text += choice.rule_is_fastest ? ", those of the rule, measured to be the fastest\n" : ", those of the rule: no difference measured to the fastest\n";
    text += fmt::format("  {}, {} rounds; speed beside {} lanes, mean over the kernels: median (lowest – highest)\n", clock_words(result), result.rounds, choice.by_rule);
    for (const LaneScore& score : choice.scores)
        text += fmt::format("  {:>2} lanes  {:.3f} ({:.3f} – {:.3f})\n", score.lanes, score.speed.median, score.speed.low, score.speed.high);
    return text;
}

}  // namespace tyndall
