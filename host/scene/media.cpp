// Media and their phase functions.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/phases.hpp"
#include "scene/scene_builder.hpp"
#include "scene/text.hpp"

namespace tyndall {

namespace {

constexpr std::size_t most_parts = 64;  ///< of a blend: every connection evaluates each of them

PhaseFunction read_table(Properties& properties)
{
    if (!properties.has("values")) refuse(properties.where(), fmt::format("{}: a tabphase needs the parameter \"values\": two or more numbers", properties.title()));
    const std::string text = properties.text("values", "");
    std::vector<double> values;
    for (const std::string_view piece : split_list(text)) {
        const auto value = parse_real(piece);
        const std::string which = fmt::format("value {} of the table, {},", values.size() + 1, in_quotes(piece));
        if (!value) properties.refuse_parameter("values", which + " is not a finite number");
        if (*value < 0) properties.refuse_parameter("values", which + " must not be negative");
        values.push_back(*value);
    }
    if (values.size() < 2) properties.refuse_parameter("values", fmt::format("a table of {} values; it takes two or more, from cosine -1 to 1", values.size()));
    if (std::all_of(values.begin(), values.end(), [](double value) { return value == 0; }))
        properties.refuse_parameter("values", "all values of the table are 0; at least one must be positive");
    return table_phase(std::move(values));
}

PhaseFunction read_phase(SceneBuilder& builder, const XmlElement& element, const std::string& medium, std::vector<const XmlElement*> around = {});

/// `around`: the blends that this one is inside of, the outermost first.
PhaseFunction read_blend(SceneBuilder& builder, Properties& properties, const std::vector<const XmlElement*>& around)
{
    if (around.size() > most_parts) refuse(properties.where(), fmt::format("{}: blendphases nest deeper than {}", properties.title(), most_parts));
    if (!properties.has("weight")) properties.real("weight", 0);  // refuses a volume or texture of that name
    if (!properties.has("weight")) refuse(properties.where(), fmt::format("{}: a blendphase needs the parameter \"weight\" between 0 and 1", properties.title()));
    const double weight = properties.real("weight", 0, Range::between(0, 1));
    const auto inside = properties.nested("phase");
    if (inside.size() != 2)
        refuse(properties.where(), fmt::format("{}: a blendphase of {} phase functions; it takes two, for weight 0 and for weight 1", properties.title(), inside.size()));
    for (const Nested& phase : inside)
        if (std::find(around.begin(), around.end(), phase.object) != around.end())
            refuse(phase.mention->where, fmt::format("{}: a blendphase is inside of itself", properties.title()));
    const PhaseFunction first = read_phase(builder, *inside[0].object, properties.title(), around);
    PhaseFunction blend = blend_phase(weight, first, read_phase(builder, *inside[1].object, properties.title(), around));
    if (blend.parts.size() > most_parts)
        refuse(properties.where(), fmt::format("{}: a blendphase of {} parts; the most are {}; write them as one tabphase", properties.title(), blend.parts.size(), most_parts));
    return blend;
}

PhaseFunction read_phase(SceneBuilder& builder, const XmlElement& element, const std::string& medium, std::vector<const XmlElement*> around)
{
    Properties properties(element, builder.document, medium);
    around.push_back(&element);
    PhaseFunction phase;
    if (properties.type() == "hg") phase = henyey_greenstein_phase(properties.real("g", .8, Range::strictly_between(-1, 1)));
    else if (properties.type() == "rayleigh") phase = rayleigh_phase();
    else if (properties.type() == "tabphase") phase = read_table(properties);
    else if (properties.type() == "blendphase") phase = read_blend(builder, properties, around);
    else if (properties.type() != "isotropic") properties.refuse_type({"isotropic", "hg", "rayleigh", "tabphase", "blendphase"});
    properties.finish();
    return phase;
}

void read_homogeneous(Properties& properties, Medium& medium)
{
    const double scale = properties.real("scale", 1, Range::not_negative());
    medium.sigma_t = scale * properties.colour("sigma_t", Rgb(1), Range::not_negative());
    medium.albedo = properties.colour("albedo", Rgb(.75), Range::between(0, 1));
}

}  // namespace

int read_medium(SceneBuilder& builder, const XmlElement& element)
{
    if (const auto known = builder.media.find(&element); known != builder.media.end()) return known->second;
    Properties properties(element, builder.document);
    if (properties.type() != "homogeneous" && properties.type() != "heterogeneous") properties.refuse_type({"homogeneous", "heterogeneous"});
    for (const char* preset : {"material", "preset"})
        if (properties.has(preset)) properties.refuse_parameter(preset, "presets of materials are not supported; give sigma_t and albedo");
    for (const char* old : {"sigma_s", "sigma_a"})
        if (properties.has(old))
            properties.refuse_parameter(old, fmt::format("{} is not supported; Mitsuba 3 takes sigma_t and albedo", old));
    Medium medium{.name = properties.id_or_type(), .where = properties.where()};
    if (properties.type() == "heterogeneous") read_heterogeneous(builder, properties, medium);
    else read_homogeneous(properties, medium);
    for (int c = 0; c < 3; ++c)
        if (!std::isfinite(medium.sigma_t[c])) properties.refuse_parameter("scale", "sigma_t x scale is too large");
    properties.boolean("sample_emitters", true);  // how Mitsuba's integrators sample: nothing that changes the image
    if (const XmlElement* phase = properties.single("phase")) medium.phase = read_phase(builder, *phase, properties.title());
    properties.finish();
    builder.scene.media.push_back(std::move(medium));
    return builder.media[&element] = static_cast<int>(builder.scene.media.size()) - 1;
}

int read_only_medium(SceneBuilder& builder, Properties& properties)
{
    const XmlElement* element = properties.single("medium");
    return element ? read_medium(builder, *element) : vacuum;
}

}  // namespace tyndall
