#include "cli/parse_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "kernels/shared/host_features.hpp"
#include "lights/light_technique.hpp"
#include "scene/text.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

[[noreturn]] void refuse(std::string_view option, const std::string& text, const std::string& wanted)
{
    throw UsageError(fmt::format("{} \"{}\": {}", option, text, wanted));
}

/// True if the whole text is one number of that type.
template <class T>
bool whole(std::string_view text, T& value)
{
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
}

std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

}  // namespace

std::int64_t parse_integer(std::string_view option, const std::string& text, std::int64_t low, std::int64_t high)
{
    std::int64_t value = 0;
    if (!whole(text, value) || value < low || value > high)
        refuse(option, text, fmt::format("must be a whole number from {} to {}", low, high));
    return value;
}

std::uint64_t parse_unsigned(std::string_view option, const std::string& text)
{
    std::uint64_t value = 0;
    if (!whole(text, value)) refuse(option, text, fmt::format("must be a whole number from 0 to {}", UINT64_MAX));
    return value;
}

double parse_number(std::string_view option, const std::string& text, double low, double high)
{
    double value = 0;
    if (!whole(text, value) || !(value >= low && value <= high))
        refuse(option, text, fmt::format("must be a number from {} to {}", low, high));
    return value;
}

double parse_share(std::string_view option, const std::string& text)
{
    const bool percent = !text.empty() && text.back() == '%';
    double value = 0;
    if (!whole(std::string_view(text).substr(0, text.size() - percent), value) || !(value >= 0 && value < (percent ? 100 : 1)))
        refuse(option, text, "must be a share such as .01 or 1%, at least 0 and less than 1");
    return percent ? value / 100 : value;
}

double parse_duration(std::string_view option, const std::string& text)
{
    constexpr double year = 365. * 24 * 3600;
    const std::string units = "smh";
    const auto unit = text.empty() ? std::string::npos : units.find(text.back());
    const double factor = unit == std::string::npos ? 1 : std::pow(60., static_cast<double>(unit));
    double value = 0;
    if (!whole(std::string_view(text).substr(0, text.size() - (unit != std::string::npos)), value) ||
        !(value > 0 && value * factor <= year))
        refuse(option, text, "must be a duration such as 60, 60s, 2m or 1.5h, longer than 0 and at most a year");
    return value * factor;
}

std::pair<int, int> parse_resolution(std::string_view option, const std::string& text)
{
    const auto parts = split(text, 'x');
    if (parts.size() != 2) refuse(option, text, "must be WIDTHxHEIGHT, for example 640x480");
    return {static_cast<int>(parse_integer(option, parts[0], 1, 65536)), static_cast<int>(parse_integer(option, parts[1], 1, 65536))};
}

std::pair<int, int> parse_shard(std::string_view option, const std::string& text)
{
    const auto parts = split(text, '/');
    if (parts.size() != 2) refuse(option, text, "must be a shard and how many there are, for example 3/16");
    const int of = static_cast<int>(parse_integer(option, parts[1], 1, 65536));
    return {static_cast<int>(parse_integer(option, parts[0], 1, of)), of};
}

Crop parse_crop(std::string_view option, const std::string& text)
{
    const auto parts = split(text, ',');
    if (parts.size() != 4) refuse(option, text, "must be x,y,width,height in pixels, for example 100,50,64,64");
    const auto part = [&](int i, int low) { return static_cast<int>(parse_integer(option, parts[i], low, 65536)); };
    return {part(0, 0), part(1, 0), part(2, 1), part(3, 1)};
}

void parse_layers(std::string_view option, const std::string& text, LayerSet& layers)
{
    std::vector<std::string> names(layer_names.begin(), layer_names.end());
    names.emplace_back("all");
    for (const auto& part : split(text, ',')) {
        const auto index = parse_choice(option, part, names);
        if (index == layer_count)
            layers = LayerSet::all();
        else
            layers.add(static_cast<Layer>(index));
    }
}

/// Why a layer is not given to that method, and who carries it.
std::string why_not(const std::string& layer, Method method)
{
    const auto which = static_cast<Layer>(std::find(layer_names.begin(), layer_names.end(), layer) - layer_names.begin());
    const bool all = layer == "all";
    if (!all && !lights_for(which, recipe_of(method)))
        return fmt::format("{} do not carry {}; --method {} does, and {}=path path-traces it", recipe_of(method).title, layer, fmt::join(methods_that_carry(which), ", "), layer);
    return fmt::format("a layer of its own can be given to path only; --method {} sets the kind of light for all layers", method.name());
}

void parse_layer_wishes(std::string_view option, const std::string& text, LayerWishes& wishes)
{
    for (const auto& part : split(text, ',')) {
        const auto sign = part.find('=');
        const std::string how = sign == std::string::npos ? "" : part.substr(sign + 1);
        LayerSet& asked = sign == std::string::npos ? wishes.named : wishes.by_path;
        parse_layers(option, part.substr(0, sign), asked);
        if (sign == std::string::npos || how == "path") continue;
        refuse(option, part, why_not(part.substr(0, sign), parse_method(option, how)));
    }
}

std::optional<std::uint32_t> parse_features(std::string_view option, const std::string& text)
{
    if (text == "own") return std::nullopt;
    std::vector<std::string> names;
    for (const auto& feature : scene_feature_list) names.emplace_back(feature.name);
    names.insert(names.end(), {"all", "none", "own"});
    std::uint32_t mask = 0;
    for (const auto& part : split(text, ',')) {
        const auto index = parse_choice(option, part, names);
        if (index < scene_feature_list.size()) mask |= scene_feature_list[index].bit;
        else if (names[index] == "all") for (const auto& feature : scene_feature_list) mask |= feature.bit;
        else if (part != text) refuse(option, text, "\"" + part + "\" stands alone");
    }
    return mask;
}

std::size_t parse_choice(std::string_view option, const std::string& text, const std::vector<std::string>& names)
{
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == text) return i;
    refuse(option, text, fmt::format("must be one of {}{}", fmt::join(names, ", "), suggestion(text, names)));
}

Method parse_method(std::string_view option, const std::string& text)
{
    const std::vector<Method> methods = all_methods();
    std::vector<std::string> names;
    for (const Method method : methods) names.emplace_back(method.name());
    return methods[parse_choice(option, text, names)];
}

std::pair<std::string, std::string> parse_definition(std::string_view option, const std::string& text)
{
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0) refuse(option, text, "must be name=value, for example -D density=2");
    return {text.substr(0, equals), text.substr(equals + 1)};
}

int parse_lanes(std::string_view option, const std::string& text) { return std::array{1, 4, 8, 16}[parse_choice(option, text, {"1", "4", "8", "16"})]; }

}  // namespace tyndall
