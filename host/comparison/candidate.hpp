#pragma once
/// What is compared: settings with names, one for every combination of what was asked for.
#include <functional>
#include <string>
#include <vector>

#include "tyndall/settings.hpp"

namespace tyndall {

struct Candidate {
    std::string name;         ///< what tells it from the others: "vrl · paper · 1024 lights"
    RenderSettings settings;  ///< seed and budget are filled in for every run
};

/// One value of a dial: what it is called and what it sets.
struct DialValue {
    std::string name;
    std::function<void(RenderSettings&)> set;
};

/// A setting with one or more values to compare.
struct Dial {
    std::vector<DialValue> values;
    std::function<bool(Method)> concerns = {};  ///< the methods that it changes; none: those with virtual lights
};

/// Every combination of the values, the first dial outermost: `methods` first, which is named always; other dials are named only if they have several values. A method takes
/// part once for every combination of the dials that concern it. Throws UsageError for no method, for more than `most_candidates`, and for two of one name.
std::vector<Candidate> candidates_of(const RenderSettings& base, const std::vector<Method>& methods, const std::vector<Dial>& dials);

inline constexpr std::size_t most_candidates = 16;  ///< more curves than a reader, or a page, can hold apart

}  // namespace tyndall
