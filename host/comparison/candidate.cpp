#include "comparison/candidate.hpp"

#include <fmt/format.h>

#include <set>

#include "lights/light_technique.hpp"
#include "tyndall/error.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

/// `candidates` with every value of the dial.
std::vector<Candidate> multiplied(const std::vector<Candidate>& candidates, const Dial& dial)
{
    std::vector<Candidate> all;
    for (const Candidate& candidate : candidates) {
        if (!(dial.concerns ? dial.concerns(candidate.settings.method) : uses_virtual_lights(candidate.settings.method))) {
            all.push_back(candidate);
            continue;
        }
        for (const DialValue& value : dial.values) {
            all.push_back(candidate);
            value.set(all.back().settings);
            if (dial.values.size() > 1) all.back().name += " · " + value.name;
        }
        if (all.size() > most_candidates) throw UsageError(fmt::format("these lists make more than {} combinations; compare fewer at a time", most_candidates));
    }
    return all;
}

}  // namespace

std::vector<Candidate> candidates_of(const RenderSettings& base, const std::vector<Method>& methods, const std::vector<Dial>& dials)
{
    if (methods.empty()) throw UsageError("--methods names no method: there is nothing to compare");
    std::vector<Candidate> candidates;
    for (const Method method : methods) {
        candidates.push_back({std::string(name(method)), base});
        candidates.back().settings.method = method;
    }
    for (const Dial& dial : dials)
        if (!dial.values.empty()) candidates = multiplied(candidates, dial);
    std::set<std::string> names;
    for (const Candidate& candidate : candidates)
        if (!names.insert(candidate.name).second) throw UsageError(fmt::format("\"{}\" is asked for twice; name every method and value once", candidate.name));
    return candidates;
}

}  // namespace tyndall
