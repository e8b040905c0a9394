#include "scene/refractive_index.hpp"

#include <array>
#include <utility>

namespace tyndall {

namespace {

// Handbook values at the sodium D line; the names are the ones that Mitsuba's scene format uses.
constexpr std::array<std::pair<const char*, double>, 23> table{{
    {"vacuum", 1.0},
    {"helium", 1.000036},
    {"hydrogen", 1.000132},
    {"air", 1.000277},
    {"carbon dioxide", 1.00045},
    {"water ice", 1.31},
    {"water", 1.333},
    {"acetone", 1.36},
    {"ethanol", 1.361},
    {"fused quartz", 1.458},
    {"carbon tetrachloride", 1.461},
    {"pyrex", 1.47},
    {"glycerol", 1.4729},
    {"acrylic glass", 1.49},
    {"polypropylene", 1.49},
    {"benzene", 1.501},
    {"bk7", 1.5046},
    {"silicone oil", 1.52045},
    {"sodium chloride", 1.544},
    {"amber", 1.55},
    {"pet", 1.575},
    {"bromine", 1.661},
    {"diamond", 2.419},
}};

}  // namespace

std::optional<double> refractive_index(const std::string& name)
{
    for (const auto& [known, index] : table)
        if (name == known) return index;
    return {};
}

std::vector<std::string> named_refractive_indices()
{
    std::vector<std::string> names;
    for (const auto& [name, index] : table) names.emplace_back(name);
    return names;
}

}  // namespace tyndall
