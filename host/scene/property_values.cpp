// What the values of Properties' parameters look like in text.
#include <fmt/format.h>

#include <algorithm>

#include "scene/properties.hpp"
#include "scene/text.hpp"
#include "scene/transforms.hpp"

namespace tyndall {

namespace {

const std::string& value_text(const XmlElement& element, const std::string& title)
{
    require_known_attributes(element, {"name", "value"});
    const std::string* value = element.find("value");
    if (!value) refuse(element.where, fmt::format("{}: {} needs the attribute \"value\"", title, printable(element.value_of("name"))));
    return *value;
}

double real_of(const XmlElement& element, std::string_view text, const std::string& title)
{
    const auto value = parse_real(text);
    if (!value)
        refuse(element.where,
               fmt::format("{}: {} = {} is not a finite number", title, printable(element.value_of("name")), in_quotes(text)));
    return *value;
}

}  // namespace

double Properties::real(const std::string& name, double fallback, const Range& range)
{
    const Parameter* parameter = use(name, {"float", "integer"});
    if (!parameter) return fallback;
    const double value = real_of(*parameter->element, value_text(*parameter->element, title_), title_);
    if (!range.contains(value)) refuse_parameter(name, fmt::format("{} = {} {}", name, value, range.words()));
    return value;
}

int Properties::integer(const std::string& name, int fallback, int low, int high)
{
    const Parameter* parameter = use(name, {"integer"});
    if (!parameter) return fallback;
    const std::string& text = value_text(*parameter->element, title_);
    const auto value = parse_integer(text);
    if (!value) refuse_parameter(name, fmt::format("{} = {} is not an integer", name, in_quotes(text)));
    if (*value < low) refuse_parameter(name, fmt::format("{} = {} must be at least {}", name, *value, low));
    if (*value > high) refuse_parameter(name, fmt::format("{} = {} must be at most {}", name, *value, high));
    return static_cast<int>(*value);
}

bool Properties::boolean(const std::string& name, bool fallback)
{
    const Parameter* parameter = use(name, {"boolean"});
    if (!parameter) return fallback;
    const std::string& text = value_text(*parameter->element, title_);
    if (text == "true" || text == "True") return true;
    if (text == "false" || text == "False") return false;
    refuse_parameter(name, fmt::format("{} = {} must be \"true\" or \"false\"", name, in_quotes(text)));
}

std::string Properties::text(const std::string& name, const std::string& fallback)
{
    const Parameter* parameter = use(name, {"string"});
    return parameter ? value_text(*parameter->element, title_) : fallback;
}

std::string Properties::choice(const std::string& name, const std::string& fallback, const std::vector<std::string>& choices)
{
    std::string value = text(name, fallback);
    if (std::find(choices.begin(), choices.end(), value) == choices.end())
        refuse_parameter(name, fmt::format("{} = {} is not supported{}; supported: {}", name, in_quotes(value), suggestion(value, choices),
                                           join(choices)));
    return value;
}

Rgb Properties::colour_of(const Parameter& parameter, bool is_light) const
{
    const XmlElement& element = *parameter.element;
    if (element.tag == "spectrum" && is_light)
        refuse(element.where,
               fmt::format("{}: {} as <spectrum> is not supported: a flat spectrum of light is not white in RGB; write it as <rgb>", title_,
                           printable(parameter.name)));
    if (element.tag == "spectrum" && element.find("filename"))
        refuse(element.where,
               fmt::format("{}: {} from a spectrum file is not supported; write it as <rgb>", title_, printable(parameter.name)));
    const std::string& text = value_text(element, title_);
    const auto pieces = split_list(text);
    if (element.tag == "spectrum" && (pieces.size() != 1 || text.find(':') != std::string::npos))
        refuse(element.where,
               fmt::format("{}: {} as a spectrum of wavelengths is not supported; write it as <rgb>", title_, printable(parameter.name)));
    if (element.tag == "rgb" && text.starts_with('#'))
        refuse(element.where, fmt::format("{}: {} = {} is not supported: Mitsuba 3 takes linear numbers only; write three numbers", title_,
                                          printable(parameter.name), in_quotes(text)));
    if (element.tag == "rgb" && pieces.size() == 3)
        return {real_of(element, pieces[0], title_), real_of(element, pieces[1], title_), real_of(element, pieces[2], title_)};
    if (element.tag == "rgb" && pieces.size() != 1)
        refuse(element.where, fmt::format("{}: {} = {} must be one or three numbers", title_, printable(parameter.name), in_quotes(text)));
    return Rgb(real_of(element, text, title_));
}

Rgb Properties::colour(const std::string& name, const Rgb& fallback, const Range& range)
{
    const Parameter* parameter = use(name, {"rgb", "float", "integer", "spectrum"});
    if (!parameter) return fallback;
    const Rgb value = colour_of(*parameter, false);
    for (int c = 0; c < 3; ++c)
        if (!range.contains(value[c])) refuse_parameter(name, fmt::format("{} = {} {}", name, value[c], range.words()));
    return value;
}

Rgb Properties::light_colour(const std::string& name, const Rgb& fallback)
{
    const Parameter* parameter = use(name, {"rgb", "float", "integer", "spectrum"});
    if (!parameter) return fallback;
    const Rgb value = colour_of(*parameter, true);
    for (int c = 0; c < 3; ++c)
        if (!(value[c] >= 0)) refuse_parameter(name, fmt::format("{} = {} must not be negative", name, value[c]));
    return value;
}

Vec3 Properties::vector(const std::string& name, const Vec3& fallback)
{
    const Parameter* parameter = use(name, {"point", "vector"});
    if (!parameter) return fallback;
    require_known_attributes(*parameter->element, {"name", "value", "x", "y", "z"});
    return read_vector(*parameter->element, 0);
}

Mat4 Properties::transform(const std::string& name)
{
    const Parameter* parameter = use(name, {"transform"});
    return parameter ? read_transform(*parameter->element) : Mat4(1);
}

}  // namespace tyndall
