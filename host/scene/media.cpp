// Media and their phase functions.
#include <cmath>

#include <fmt/format.h>

#include "scene/scene_builder.hpp"

namespace tyndall {

namespace {

PhaseFunction read_phase(SceneBuilder& builder, const XmlElement& element, const std::string& medium)
{
    Properties properties(element, builder.document, medium);
    PhaseFunction phase;
    if (properties.type() == "hg") {
        phase.type = PhaseFunction::Type::henyey_greenstein;
        phase.g = properties.real("g", .8, Range::strictly_between(-1, 1));
    } else if (properties.type() != "isotropic") {
        properties.refuse_type({"isotropic", "hg"});
    }
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
