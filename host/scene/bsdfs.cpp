// Surfaces: null, diffuse, twosided, dielectric, conductor.
#include <fmt/format.h>

#include "scene/refractive_index.hpp"
#include "scene/scene_builder.hpp"
#include "scene/text.hpp"

namespace tyndall {

namespace {

int add(SceneBuilder& builder, Bsdf bsdf)
{
    builder.scene.bsdfs.push_back(std::move(bsdf));
    return static_cast<int>(builder.scene.bsdfs.size()) - 1;
}

/// A number, or the name of a material.
double read_index(Properties& properties, const std::string& name, const std::string& fallback)
{
    if (properties.written_as(name) != "string" && properties.has(name)) return properties.real(name, 1, Range::positive());
    const std::string material = properties.text(name, fallback);
    const auto index = refractive_index(material);
    if (!index)
        properties.refuse_parameter(
            name, fmt::format("{} = {} is not a material with a known index of refraction{}; known: {}", name, in_quotes(material),
                              suggestion(material, named_refractive_indices()), join(named_refractive_indices())));
    return *index;
}

Bsdf read_dielectric(Properties& properties)
{
    Bsdf bsdf{.type = Bsdf::Type::dielectric, .reflectance = Rgb(1)};
    bsdf.eta = read_index(properties, "int_ior", "bk7") / read_index(properties, "ext_ior", "air");
    // 100: no material comes near, and beyond it the squares of Snell's law lose every digit of the direction.
    if (!(bsdf.eta > .01 && bsdf.eta < 100))
        properties.refuse_parameter("int_ior", fmt::format("int_ior / ext_ior = {} must lie between .01 and 100", bsdf.eta));
    bsdf.reflectance = properties.colour("specular_reflectance", Rgb(1), Range::between(0, 1));
    bsdf.specular_transmittance = properties.colour("specular_transmittance", Rgb(1), Range::between(0, 1));
    return bsdf;
}

Bsdf read_conductor(Properties& properties)
{
    Bsdf bsdf{.type = Bsdf::Type::conductor};
    const std::string material = properties.text("material", "none");
    if (material != "none")
        properties.refuse_parameter(
            "material",
            fmt::format("material = {} is not supported: Tyndall carries no measured metals; give eta and k as <rgb>, or material "
                        "\"none\" for a perfect mirror",
                        in_quotes(material)));
    bsdf.conductor_eta = properties.colour("eta", Rgb(0), Range::not_negative());
    bsdf.conductor_k = properties.colour("k", Rgb(1), Range::not_negative());
    bsdf.reflectance = properties.colour("specular_reflectance", Rgb(1), Range::between(0, 1));
    return bsdf;
}

int read_twosided(SceneBuilder& builder, Properties& properties)
{
    const auto sides = properties.nested("bsdf");
    if (sides.empty() || sides.size() > 2)
        refuse(properties.where(), fmt::format("{}: {} bsdfs inside; it takes one, or one for the front and one for the back",
                                               properties.title(), sides.size()));
    for (const Nested& side : sides) {
        const std::string type = side.object->value_of("type");
        if (type == "twosided" || type == "null" || type == "dielectric")
            refuse(side.mention->where,
                   fmt::format("{}: a {} bsdf cannot be a side; only what lets no light through can", properties.title(), in_quotes(type)));
    }
    Bsdf bsdf = builder.scene.bsdfs[static_cast<std::size_t>(read_bsdf(builder, *sides[0].object))];
    bsdf.name = properties.id_or_type(), bsdf.where = properties.where(), bsdf.two_sided = true;
    if (sides.size() == 2) bsdf.back = read_bsdf(builder, *sides[1].object);
    properties.finish();
    return add(builder, std::move(bsdf));
}

Bsdf read_one_sided(Properties& properties)
{
    if (properties.type() == "null") return {.type = Bsdf::Type::null, .reflectance = Rgb(0)};
    if (properties.type() == "diffuse")
        return {.type = Bsdf::Type::diffuse, .reflectance = properties.colour("reflectance", Rgb(.5), Range::between(0, 1))};
    if (properties.type() == "dielectric") return read_dielectric(properties);
    if (properties.type() == "conductor") return read_conductor(properties);
    properties.refuse_type({"null", "diffuse", "twosided", "dielectric", "conductor"});
}

}  // namespace

int read_bsdf(SceneBuilder& builder, const XmlElement& element)
{
    if (const auto known = builder.bsdfs.find(&element); known != builder.bsdfs.end()) return known->second;
    Properties properties(element, builder.document);
    if (properties.type() == "twosided") return builder.bsdfs[&element] = read_twosided(builder, properties);
    Bsdf bsdf = read_one_sided(properties);
    bsdf.name = properties.id_or_type(), bsdf.where = properties.where();
    properties.finish();
    return builder.bsdfs[&element] = add(builder, std::move(bsdf));
}

int default_bsdf(SceneBuilder& builder, bool glows)
{
    const std::string name = glows ? "default (black)" : "default (grey)";
    for (std::size_t i = 0; i < builder.scene.bsdfs.size(); ++i)
        if (builder.scene.bsdfs[i].where.line == 0 && builder.scene.bsdfs[i].name == name) return static_cast<int>(i);
    return add(builder, {.name = name, .type = Bsdf::Type::diffuse, .reflectance = Rgb(glows ? 0 : .5)});
}

}  // namespace tyndall
