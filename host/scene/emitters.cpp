// Lights: point, spot, area, directional, constant, envmap.
#include <fmt/format.h>

#include <numbers>

#include "scene/environment_maps.hpp"
#include "scene/scene_builder.hpp"
#include "scene/text.hpp"
#include "scene/transforms.hpp"

namespace tyndall {

namespace {

constexpr double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

Emitter read_point(Properties& properties)
{
    Emitter emitter{.type = Emitter::Type::point};
    emitter.value = properties.light_colour("intensity", Rgb(1));
    if (properties.has("position") && properties.has("to_world"))
        properties.refuse_parameter("to_world", "position and to_world exclude each other");
    const Vec3 position = properties.vector("position", Vec3(0));
    emitter.position = transform_point(properties.transform("to_world"), position);
    return emitter;
}

Emitter read_spot(Properties& properties)
{
    Emitter emitter{.type = Emitter::Type::spot};
    emitter.value = properties.light_colour("intensity", Rgb(1));
    const double cutoff = properties.real("cutoff_angle", 20, Range{.low = 0, .high = 180, .open = true});
    const double beam = properties.real("beam_width", cutoff * 3 / 4, Range::between(0, 180));
    if (beam > cutoff)
        properties.refuse_parameter("beam_width", fmt::format("beam_width = {} must not exceed cutoff_angle = {}", beam, cutoff));
    emitter.cutoff = radians(cutoff), emitter.beam = radians(beam);
    const Mat4 to_world = properties.transform("to_world");
    emitter.position = transform_point(to_world, Vec3(0));
    emitter.direction = glm::normalize(transform_direction(to_world, Vec3(0, 0, 1)));
    return emitter;
}

Emitter read_directional(Properties& properties)
{
    Emitter emitter{.type = Emitter::Type::directional};
    emitter.value = properties.light_colour("irradiance", Rgb(1));
    if (properties.has("direction") && properties.has("to_world"))
        properties.refuse_parameter("to_world", "direction and to_world exclude each other");
    const Vec3 direction = transform_direction(properties.transform("to_world"), properties.vector("direction", Vec3(0, 0, 1)));
    if (!(glm::length(direction) > 0)) properties.refuse_parameter("direction", "direction has length zero");
    emitter.direction = glm::normalize(direction);
    return emitter;
}

Emitter read_unplaced(Properties& properties, Emitter::Type type)
{
    Emitter emitter{.type = type};
    emitter.value = properties.light_colour("radiance", Rgb(1));
    return emitter;
}

/// Pixels of a map: its tables take twenty bytes for each.
constexpr std::int64_t most_environment_pixels = std::int64_t{1} << 25;

EnvironmentMap map_of(Picture&& picture, const Properties& properties, const std::string& name)
{
    const auto refuse_file = [&](const std::string& why) { properties.refuse_parameter("filename", printable(name) + ": " + why); };
    if (picture.width < 2 || picture.height < 2 || std::int64_t{picture.width} * picture.height > most_environment_pixels)
        refuse_file(fmt::format("has {} x {} pixels; an envmap has at least 2 x 2, and at most {}", picture.width, picture.height, most_environment_pixels));
    const std::size_t channels = static_cast<std::size_t>(picture.channels), row = static_cast<std::size_t>(picture.width) * channels;
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        if (picture.values[i] < 0) refuse_file(fmt::format("pixel ({}, {}) is {}; radiance must not be negative", i % row / channels, i / row, picture.values[i]));
    EnvironmentMap map{.name = name, .width = picture.width, .height = picture.height, .texels = std::move(picture.values), .where = properties.where()};
    if (channels == 1) {
        std::vector<float> grey = std::move(map.texels);
        map.texels.resize(3 * grey.size());
        for (std::size_t i = 0; i < map.texels.size(); ++i) map.texels[i] = grey[i / 3];
    }
    prepare_environment(map);
    return map;
}

/// The directions of the columns of to_world's linear part.
Mat3 turning_of(Properties& properties)
{
    const Mat3 linear(properties.transform("to_world"));
    Mat3 turning;
    for (int i = 0; i < 3; ++i) turning[i] = glm::normalize(linear[i]);
    for (int i = 0; i < 3; ++i)
        if (std::abs(glm::dot(turning[i], turning[(i + 1) % 3])) > 1e-6)  // as for spheres (scene/shapes.cpp)
            properties.refuse_parameter("to_world", "to_world shears, which directions cannot follow; turn the map only");
    return turning;
}

Emitter read_envmap(SceneBuilder& builder, Properties& properties)
{
    const std::string name = properties.text("filename", "");
    Emitter emitter{.type = Emitter::Type::envmap};
    emitter.value = Rgb(properties.real("scale", 1, Range::not_negative()));
    emitter.map_to_world = turning_of(properties);
    builder.scene.environment_maps.push_back(map_of(read_scene_picture(builder, properties, false), properties, name));
    emitter.map = static_cast<int>(builder.scene.environment_maps.size()) - 1;
    return emitter;
}

Emitter read_typed(SceneBuilder& builder, Properties& properties)
{
    if (properties.type() == "envmap") return read_envmap(builder, properties);
    if (properties.type() == "point") return read_point(properties);
    if (properties.type() == "spot") return read_spot(properties);
    if (properties.type() == "directional") return read_directional(properties);
    if (properties.type() == "constant") return read_unplaced(properties, Emitter::Type::constant);
    if (properties.type() == "area") return read_unplaced(properties, Emitter::Type::area);
    properties.refuse_type({"point", "spot", "area", "directional", "constant", "envmap"});
}

}  // namespace

int read_emitter(SceneBuilder& builder, const XmlElement& element, int shape)
{
    Properties properties(element, builder.document);
    Emitter emitter = read_typed(builder, properties);
    const bool is_area = emitter.type == Emitter::Type::area;
    if (is_area && shape == none) refuse(properties.where(), properties.title() + ": an area emitter stands inside the <shape> that glows");
    if (!is_area && shape != none)
        refuse(properties.where(), fmt::format("{}: type {} cannot stand inside a <shape>; only an area emitter can", properties.title(),
                                               in_quotes(properties.type())));
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(emitter.position[axis]) <= largest_coordinate))
            refuse(properties.where(), properties.title() + ": the position is too far out");
    emitter.medium = read_only_medium(builder, properties);
    emitter.shape = shape, emitter.name = properties.id_or_type(), emitter.where = properties.where();
    properties.finish();
    builder.scene.emitters.push_back(std::move(emitter));
    return static_cast<int>(builder.scene.emitters.size()) - 1;
}

}  // namespace tyndall
