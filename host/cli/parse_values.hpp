#pragma once
/// Values of options, strictly: the whole text, decimal, in range, in the C locale. All throw UsageError that names option and value.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tyndall/layer.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {

std::int64_t parse_integer(std::string_view option, const std::string& text, std::int64_t low, std::int64_t high);
std::uint64_t parse_unsigned(std::string_view option, const std::string& text);
double parse_number(std::string_view option, const std::string& text, double low, double high);

/// "1%" or ".01": at least 0 and less than 1.
double parse_share(std::string_view option, const std::string& text);

/// "60", "60s", "2m", "1.5h" in seconds, more than 0 and at most a year.
double parse_duration(std::string_view option, const std::string& text);

/// "640x480": width and height, 1 to 65536 each.
std::pair<int, int> parse_resolution(std::string_view option, const std::string& text);

/// "3/16": a shard and how many there are, 1 to 65536.
std::pair<int, int> parse_shard(std::string_view option, const std::string& text);

/// "x,y,w,h": pixels from the top left corner.
Crop parse_crop(std::string_view option, const std::string& text);

/// Adds the comma-separated layer names to the set; "all" adds every layer.
void parse_layers(std::string_view option, const std::string& text, LayerSet& layers);

/// What --layer says: layers to keep, and layers to path-trace whatever the method.
struct LayerWishes {
    LayerSet named, by_path;
    /// All, or those that were named in either way.
    LayerSet kept() const { return named.empty() ? LayerSet::all() : named | by_path; }
};

/// Adds comma-separated wishes: "single" keeps a layer, "media_to_media=path" path-traces one.
void parse_layer_wishes(std::string_view option, const std::string& text, LayerWishes& wishes);

/// A mask of kernels/shared/scene_features.h: comma-separated names, "all" or "none"; nothing for "own", what the scene calls for.
std::optional<std::uint32_t> parse_features(std::string_view option, const std::string& text);

/// Index of `text` in `names`.
std::size_t parse_choice(std::string_view option, const std::string& text, const std::vector<std::string>& names);

/// A lane width: 1, 4, 8 or 16.
int parse_lanes(std::string_view option, const std::string& text);

/// The value of that name in one of the tables of tyndall/setting_names.hpp.
template <class Value, std::size_t count>
Value parse_named(std::string_view option, const std::string& text, const std::array<Named<Value>, count>& table)
{
    std::vector<std::string> names;
    for (const auto& named : table) names.emplace_back(named.name);
    return table[parse_choice(option, text, names)].value;
}

/// The method of that name: one of all_methods().
Method parse_method(std::string_view option, const std::string& text);

/// "name=value"; the name is not empty.
std::pair<std::string, std::string> parse_definition(std::string_view option, const std::string& text);

}  // namespace tyndall
