#include "selftest/selftest_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "report/readable.hpp"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const SelftestMiss& miss)
{
    Json in = Json::array();
    for (const double x : miss.in) in.push_back(number(x));
    return {{"set", miss.set},          {"sampler", sampler_name(miss.sampler)}, {"mean", miss.is_mean},   {"output", miss.output}, {"got", number(miss.got)},
            {"value", number(miss.value)}, {"low", number(miss.low)},            {"high", number(miss.high)}, {"in", in}};
}

Json json_of(const SelftestOutcome& outcome)
{
    return {{"case", outcome.name},
            {"where", outcome.where},
            {"lanes", outcome.lanes ? Json(outcome.lanes) : Json(nullptr)},
            {"passed", outcome.misses == 0},
            {"outputs", outcome.outputs},
            {"outside", outcome.misses},
            {"worst_ulp", number(outcome.worst_ulp)},
            {"worst_relative", number(outcome.worst_relative)},
            {"worst_share_of_bound", number(outcome.worst_share)},
            {"seconds", number(outcome.seconds)},
            {"first_outside", outcome.first ? json_of(*outcome.first) : Json(nullptr)}};
}

/// Text between tags or in an attribute; characters that XML 1.0 cannot hold become "?".
std::string xml(const std::string& text)
{
    std::string safe;
    for (const char c : text) {
        if (c == '&') safe += "&amp;";
        else if (c == '<') safe += "&lt;";
        else if (c == '>') safe += "&gt;";
        else if (c == '"') safe += "&quot;";
        else if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) safe += "?";
        else safe += c;
    }
    return safe;
}

std::size_t places(const SelftestResult& result)
{
    return result.outcomes.empty() ? 0 : static_cast<std::size_t>(std::ranges::count(result.outcomes, result.outcomes.front().name, &SelftestOutcome::name));
}

}  // namespace

std::string place_of(const SelftestOutcome& outcome) { return outcome.lanes ? fmt::format("device, {} lane{}", outcome.lanes, outcome.lanes == 1 ? "" : "s") : outcome.where; }

std::string to_table(const SelftestResult& result)
{
    std::string table = fmt::format("device {}: {}, driver {}\n", terminal_safe(result.device.platform), terminal_safe(result.device.name), terminal_safe(result.device.driver));
    const auto out = std::back_inserter(table);
    fmt::format_to(out, "{:<58} {:<16} {:>7} {:>7} {:>8} {:>9} {:>8} {:>9}\n", "case", "where", "outputs", "outside", "ulp", "relative", "of bound", "time");
    std::size_t outside = 0;
    for (const SelftestOutcome& o : result.outcomes) {
        fmt::format_to(out, "{:<58} {:<16} {:>7} {:>7} {:>8.2f} {:>9.1e} {:>6.0f} % {:>6.1f} ms\n", o.name, place_of(o), o.outputs, o.misses, o.worst_ulp, o.worst_relative,
                       100 * o.worst_share, 1e3 * o.seconds);
        outside += o.misses != 0;
    }
    for (const SelftestOutcome& o : result.outcomes)
        if (o.first) fmt::format_to(out, "OUTSIDE {} ({}): {}\n", o.name, place_of(o), sentence_of(*o.first));
    const std::size_t cases = places(result) ? result.outcomes.size() / places(result) : 0;
    if (outside) fmt::format_to(out, "{} of {} results are outside their bounds", outside, result.outcomes.size());
    else fmt::format_to(out, "all {} cases are within their bounds in {} places", cases, places(result));
    fmt::format_to(out, ", {}\n", readable_seconds(result.seconds));
    return table;
}

std::string to_json(const SelftestResult& result, const std::string& version)
{
    Json json;
    json["schema"] = selftest_schema;
    json["version"] = version;
    json["device"] = {{"platform", result.device.platform}, {"name", result.device.name}, {"driver", result.device.driver}, {"version", result.device.version}};
    json["passed"] = result.passed();
    json["seconds"] = number(result.seconds);
    Json programs = Json::array(), cases = Json::array();
    for (const SelftestProgram& program : result.programs) programs.push_back({{"lanes", program.lanes}, {"build_options", program.options}});
    for (const SelftestOutcome& outcome : result.outcomes) cases.push_back(json_of(outcome));
    json["programs"] = programs, json["cases"] = cases;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_junit(const SelftestResult& result)
{
    std::size_t failures = 0;
    std::string suites;
    for (std::size_t first = 0, end; first < result.outcomes.size(); first = end) {
        const std::string place = place_of(result.outcomes[first]);
        std::size_t failed = 0;
        double seconds = 0;
        std::string cases;
        for (end = first; end < result.outcomes.size() && place_of(result.outcomes[end]) == place; ++end) {
            const SelftestOutcome& o = result.outcomes[end];
            seconds += o.seconds, failed += o.misses != 0;
            cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.6f}\"", xml(place), xml(o.name), o.seconds);
            cases += o.first ? fmt::format(">\n      <failure message=\"{}\"/>\n    </testcase>\n", xml(sentence_of(*o.first))) : "/>\n";
        }
        suites += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" time=\"{:.6f}\">\n{}  </testsuite>\n", xml(place), end - first, failed, seconds, cases);
        failures += failed;
    }
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"tyndall selftest\" tests=\"{}\" failures=\"{}\" time=\"{:.6f}\">\n{}</testsuites>\n",
                       result.outcomes.size(), failures, result.seconds, suites);
}

}  // namespace tyndall
