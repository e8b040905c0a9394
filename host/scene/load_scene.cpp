#include "scene/load_scene.hpp"

#include <fmt/format.h>

#include "scene/render_space.hpp"
#include "scene/scene_builder.hpp"
#include "scene/scene_warnings.hpp"
#include "scene/text.hpp"

namespace tyndall {

namespace {

/// Which paths the integrator keeps; everything else about it is ours to choose. Integrators may be nested.
void read_integrator(SceneBuilder& builder, const XmlElement& element, int depth)
{
    Properties properties(element, builder.document);
    // An integrator that refers to itself would never end.
    if (depth > xml_limits::depth) refuse(properties.where(), "integrators are nested too deeply, or in a circle");
    builder.scene.integrator += (builder.scene.integrator.empty() ? "" : " > ") + properties.type();
    if (properties.has("max_depth")) builder.scene.max_depth = properties.integer("max_depth", -1, -1, 1 << 30);
    for (const XmlElement& child : element.children) {
        const std::string name = child.value_of("name");
        if (name != "max_depth" && edit_distance(name, "max_depth") <= 2)
            builder.warn(child.where,
                         fmt::format("{}: {} is not looked at; was \"max_depth\" meant?", properties.title(), in_quotes(name)));
    }
    for (const Nested& nested : properties.nested("integrator")) read_integrator(builder, *nested.object, depth + 1);
    for (const char* foreign : {"sampler", "bsdf", "texture", "film", "rfilter"}) properties.nested(foreign);
    properties.ignore_parameters();
    properties.finish();
}

void read_sensors(SceneBuilder& builder, Properties& properties)
{
    const auto sensors = properties.nested("sensor");
    if (sensors.empty()) refuse(properties.where(), "the scene has no <sensor>; add one of type \"perspective\"");
    builder.scene.camera = read_sensor(builder, *sensors[0].object);
    for (std::size_t i = 1; i < sensors.size(); ++i) builder.warn(sensors[i].mention->where, "only the first sensor is used");
}

/// Objects that belong inside others may stand at the top, with an id, to be referred to.
void check_parts(Properties& properties, const char* tag)
{
    for (const Nested& part : properties.nested(tag))
        if (!part.object->find("id"))
            refuse(part.mention->where, fmt::format("<{}> at the top of the scene needs an id by which something refers to it", tag));
}

void read_root(SceneBuilder& builder)
{
    const XmlElement& root = builder.document.root();
    require_known_attributes(root, {"version"});
    for (const XmlElement& child : root.children)
        if (child.tag == "ref")
            refuse(child.where, "<ref> at the top of the scene refers to an object that is in the scene anyway; remove it");
    Properties properties(root, builder.document, "scene");
    if (const XmlElement* integrator = properties.single("integrator")) read_integrator(builder, *integrator, 1);
    read_sensors(builder, properties);
    for (const Nested& medium : properties.nested("medium")) read_medium(builder, *medium.object);
    for (const Nested& bsdf : properties.nested("bsdf")) read_bsdf(builder, *bsdf.object);
    for (const Nested& shape : properties.nested("shape")) read_shape(builder, *shape.object);
    for (const Nested& emitter : properties.nested("emitter")) read_emitter(builder, *emitter.object);
    for (const char* part : {"film", "sampler", "rfilter", "phase", "volume", "texture"}) check_parts(properties, part);
    properties.finish();
}

Scene build(const std::string& xml, const std::string& name, SceneFiles& files, const LoadOptions& options)
{
    for (const auto& [key, value] : options.definitions) files.hash().add(key), files.hash().add(value);
    const SceneDocument document(parse_xml(xml, name), files, options.definitions);
    SceneBuilder builder{.document = document, .files = files};
    builder.scene.file = name;
    read_root(builder);
    to_render_space(builder.scene);
    add_warnings(builder);
    builder.scene.hash = files.hash().value();
    return std::move(builder.scene);
}

}  // namespace

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options)
{
    const SourceLocation where{.file = file.string()};
    const std::string xml = read_regular_file(file, where, xml_limits::bytes);
    SceneFiles files(file.parent_path(), options.allow_outside);
    files.hash().add(xml);
    return build(xml, file.string(), files, options);
}

Scene parse_scene(const std::string& xml, const std::filesystem::path& folder, const std::string& name, const LoadOptions& options)
{
    SceneFiles files(folder, options.allow_outside);
    files.hash().add(xml);
    return build(xml, name, files, options);
}

}  // namespace tyndall
