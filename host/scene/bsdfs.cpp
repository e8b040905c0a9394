// Surfaces: null, diffuse, twosided, dielectrics, conductors and plastics, smooth and rough.
#include <fmt/format.h>

#include "scene/plastic.hpp"
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

/// Interior over exterior index.
double read_eta(Properties& properties, const std::string& interior)
{
    const double eta = read_index(properties, "int_ior", interior) / read_index(properties, "ext_ior", "air");
    // 100: no material comes near, and beyond it the squares of Snell's law lose every digit of the direction.
    if (!(eta > .01 && eta < 100)) properties.refuse_parameter("int_ior", fmt::format("int_ior / ext_ior = {} must lie between .01 and 100", eta));
    return eta;
}

/// One index on both sides: facets would bend nothing, and which of them did it could not be told.
void require_boundary(Properties& properties, double eta)
{
    if (std::abs(eta - 1) < 1e-6)
        properties.refuse_parameter("int_ior", fmt::format("int_ior / ext_ior = {} makes no boundary; use type \"null\", or \"dielectric\" without roughness", eta));
}

/// Roughness below this is a mirror in all but its noise; Mitsuba's limit.
constexpr double least_alpha = 1e-4;

void read_distribution(Properties& properties, Roughness& roughness)
{
    const std::string name = properties.choice("distribution", "beckmann", {"beckmann", "ggx"});
    roughness.type = name == "ggx" ? Roughness::Type::ggx : Roughness::Type::beckmann;
    properties.boolean("sample_visible", true);  // a choice of sampler: Tyndall's always draws visible normals, the image is the same
}

double read_alpha(Properties& properties, const std::string& name, double fallback) { return properties.real(name, fallback, Range::between(least_alpha, 10)); }

Roughness read_roughness(Properties& properties)
{
    Roughness roughness;
    read_distribution(properties, roughness);
    const bool by_axis = properties.has("alpha_u") || properties.has("alpha_v");
    if (by_axis && properties.has("alpha")) properties.refuse_parameter("alpha", "alpha excludes alpha_u and alpha_v");
    const double alpha = read_alpha(properties, "alpha", .1);
    roughness.alpha_u = read_alpha(properties, "alpha_u", alpha), roughness.alpha_v = read_alpha(properties, "alpha_v", alpha);
    if (by_axis && !(properties.has("alpha_u") && properties.has("alpha_v"))) properties.refuse_parameter("alpha_u", "alpha_u and alpha_v come in pairs");
    return roughness;
}

/// `name` into bsdf.reflectance.
void read_reflectance(SceneBuilder& builder, Properties& properties, const std::string& name, double fallback, Bsdf& bsdf)
{
    const SurfaceColour colour = read_reflectance(builder, properties, name, fallback);
    bsdf.reflectance = colour.largest, bsdf.reflectance_texture = colour.texture;
}

Bsdf read_diffuse(SceneBuilder& builder, Properties& properties)
{
    Bsdf bsdf{.type = Bsdf::Type::diffuse};
    read_reflectance(builder, properties, "reflectance", .5, bsdf);
    return bsdf;
}

Bsdf read_dielectric(SceneBuilder& builder, Properties& properties, Bsdf::Type type)
{
    Bsdf bsdf{.type = type, .eta = read_eta(properties, "bk7")};
    read_reflectance(builder, properties, "specular_reflectance", 1, bsdf);
    const SurfaceColour transmittance = read_reflectance(builder, properties, "specular_transmittance", 1);
    bsdf.specular_transmittance = transmittance.largest, bsdf.transmittance_texture = transmittance.texture;
    if (type != Bsdf::Type::rough_dielectric) return bsdf;
    require_boundary(properties, bsdf.eta);
    bsdf.roughness = read_roughness(properties);
    return bsdf;
}

Bsdf read_conductor(SceneBuilder& builder, Properties& properties, Bsdf::Type type)
{
    Bsdf bsdf{.type = type};
    const std::string material = properties.text("material", "none");
    if (material != "none")
        properties.refuse_parameter(
            "material",
            fmt::format("material = {} is not supported: Tyndall carries no measured metals; give eta and k as <rgb>, or material "
                        "\"none\" for a perfect mirror",
                        in_quotes(material)));
    bsdf.conductor_eta = properties.colour("eta", Rgb(0), Range::not_negative());
    bsdf.conductor_k = properties.colour("k", Rgb(1), Range::not_negative());
    read_reflectance(builder, properties, "specular_reflectance", 1, bsdf);
    if (type == Bsdf::Type::rough_conductor) bsdf.roughness = read_roughness(properties);
    return bsdf;
}

Bsdf read_plastic(SceneBuilder& builder, Properties& properties, Bsdf::Type type)
{
    Bsdf bsdf{.type = type, .eta = read_eta(properties, "polypropylene")};
    require_boundary(properties, bsdf.eta);
    const SurfaceColour below = read_reflectance(builder, properties, "diffuse_reflectance", .5);
    bsdf.diffuse = below.largest, bsdf.diffuse_texture = below.texture;
    read_reflectance(builder, properties, "specular_reflectance", 1, bsdf);
    bsdf.nonlinear = properties.boolean("nonlinear", false);
    if (type == Bsdf::Type::rough_plastic) {
        read_distribution(properties, bsdf.roughness);
        bsdf.roughness.alpha_u = bsdf.roughness.alpha_v = read_alpha(properties, "alpha", .1);
    }
    prepare_plastic(bsdf);
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
        if (type == "twosided" || type == "null" || type == "dielectric" || type == "thindielectric" || type == "roughdielectric")
            refuse(side.mention->where,
                   fmt::format("{}: a {} bsdf cannot be a side; only what lets no light through can", properties.title(), in_quotes(type)));
    }
    Bsdf bsdf = builder.scene.bsdfs[static_cast<std::size_t>(read_bsdf(builder, *sides[0].object))];
    bsdf.name = properties.id_or_type(), bsdf.where = properties.where(), bsdf.two_sided = true;
    if (sides.size() == 2) bsdf.back = read_bsdf(builder, *sides[1].object);
    properties.finish();
    return add(builder, std::move(bsdf));
}

Bsdf read_one_sided(SceneBuilder& builder, Properties& properties)
{
    const std::string& type = properties.type();
    if (type == "null") return {.type = Bsdf::Type::null, .reflectance = Rgb(0)};
    if (type == "diffuse") return read_diffuse(builder, properties);
    if (type == "dielectric") return read_dielectric(builder, properties, Bsdf::Type::dielectric);
    if (type == "thindielectric") return read_dielectric(builder, properties, Bsdf::Type::thin_dielectric);
    if (type == "roughdielectric") return read_dielectric(builder, properties, Bsdf::Type::rough_dielectric);
    if (type == "conductor") return read_conductor(builder, properties, Bsdf::Type::conductor);
    if (type == "roughconductor") return read_conductor(builder, properties, Bsdf::Type::rough_conductor);
    if (type == "plastic") return read_plastic(builder, properties, Bsdf::Type::plastic);
    if (type == "roughplastic") return read_plastic(builder, properties, Bsdf::Type::rough_plastic);
    properties.refuse_type({"null", "diffuse", "twosided", "dielectric", "thindielectric", "roughdielectric", "conductor", "roughconductor", "plastic", "roughplastic"});
}

}  // namespace

int read_bsdf(SceneBuilder& builder, const XmlElement& element)
{
    if (const auto known = builder.bsdfs.find(&element); known != builder.bsdfs.end()) return known->second;
    Properties properties(element, builder.document);
    if (properties.type() == "twosided") return builder.bsdfs[&element] = read_twosided(builder, properties);
    Bsdf bsdf = read_one_sided(builder, properties);
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
