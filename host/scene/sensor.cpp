// The camera and its film.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/scene_builder.hpp"
#include "scene/text.hpp"
#include "scene/transforms.hpp"

namespace tyndall {

namespace {

constexpr int largest_side = 65536;
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;  ///< 268 million: 24 bytes each is 6 GiB of film

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

Filter read_filter(SceneBuilder& builder, const XmlElement& element)
{
    Properties properties(element, builder.document);
    Filter filter;
    if (properties.type() == "box")
        filter.type = Filter::Type::box;
    else if (properties.type() == "gaussian")
        // 8 pixels: a wider filter is a blur, and reaches 32 pixels to each side.
        filter.stddev = properties.real("stddev", .5, Range{.low = 0, .high = 8, .open = true});
    else
        properties.refuse_type({"box", "gaussian"});
    properties.finish();
    return filter;
}

void read_crop(Properties& properties, Camera& camera)
{
    camera.crop_x = properties.integer("crop_offset_x", 0, 0, largest_side);
    camera.crop_y = properties.integer("crop_offset_y", 0, 0, largest_side);
    camera.crop_width = properties.integer("crop_width", camera.width, 1, largest_side);
    camera.crop_height = properties.integer("crop_height", camera.height, 1, largest_side);
    const auto check = [&](const char* name, int offset, int size, int whole) {
        if (offset + size > whole)
            properties.refuse_parameter(
                name, fmt::format("{} = {} from offset {} does not fit into the film's {} pixels", name, size, offset, whole));
    };
    check("crop_width", camera.crop_x, camera.crop_width, camera.width);
    check("crop_height", camera.crop_y, camera.crop_height, camera.height);
}

void read_film(SceneBuilder& builder, const XmlElement& element, Camera& camera)
{
    Properties properties(element, builder.document);
    if (properties.type() != "hdrfilm") properties.refuse_type({"hdrfilm"});
    camera.width = properties.integer("width", 768, 1, largest_side);
    camera.height = properties.integer("height", 576, 1, largest_side);
    if (std::int64_t{camera.width} * camera.height > most_pixels)
        properties.refuse_parameter("width",
                                    fmt::format("{} x {} pixels; at most {} are rendered", camera.width, camera.height, most_pixels));
    read_crop(properties, camera);
    // What is written, and how, is the command line's choice: these are checked, and change nothing.
    properties.choice("pixel_format", "rgb", {"rgb", "rgba"});
    properties.choice("component_format", "float16", {"float16", "float32"});
    properties.choice("file_format", "openexr", {"openexr", "exr"});
    for (const char* name : {"sample_border", "compensate"})
        if (properties.boolean(name, false)) properties.refuse_parameter(name, fmt::format("{} = true is not supported", name));
    if (const XmlElement* filter = properties.single("rfilter")) camera.filter = read_filter(builder, *filter);
    properties.finish();
}

/// "35mm" or "35": millimetres on 36 x 24 mm film.
double read_focal_length(Properties& properties)
{
    std::string text = properties.text("focal_length", "50mm");
    if (text.ends_with("mm")) text.resize(text.size() - 2);
    const auto millimetres = parse_real(text);
    if (!millimetres || !(*millimetres > 0))
        properties.refuse_parameter("focal_length", fmt::format("focal_length = {} is not a length such as \"50mm\"", in_quotes(text)));
    return *millimetres;
}

/// Full horizontal angle of the uncropped film, radians.
double read_horizontal_fov(Properties& properties, double aspect)
{
    const std::vector<std::string> axes{"x", "y", "diagonal", "smaller", "larger"};
    if (properties.has("fov") && properties.has("focal_length"))
        properties.refuse_parameter("focal_length", "fov and focal_length exclude each other");
    const bool by_angle = properties.has("fov");
    const double fov = properties.real("fov", 0, Range::strictly_between(0, 180));
    std::string axis = properties.choice("fov_axis", "x", axes);
    double tangent = std::tan(radians(fov) / 2);
    if (!by_angle) {
        if (properties.has("fov_axis"))
            properties.refuse_parameter("fov_axis", "fov_axis goes with fov; a focal_length is across the diagonal");
        tangent = std::sqrt(36. * 36 + 24. * 24) / (2 * read_focal_length(properties));
        axis = "diagonal";
    }
    if (axis == "smaller") axis = aspect > 1 ? "y" : "x";
    if (axis == "larger") axis = aspect > 1 ? "x" : "y";
    if (axis == "y") tangent *= aspect;
    if (axis == "diagonal") tangent /= std::sqrt(1 + 1 / (aspect * aspect));
    const double result = 2 * std::atan(tangent);
    if (!(result > 0 && result < std::numbers::pi * (1 - 1e-9)))
        properties.refuse_parameter("fov", fmt::format("the horizontal field of view is {} degrees; it must lie strictly between 0 and 180",
                                                       result * 180 / std::numbers::pi));
    return result;
}

/// The rigid motion (or mirroring) that to_world is within a thousandth, made exact.
Mat4 rigid(Properties& properties, const Mat4& to_world)
{
    const Vec3 x(to_world[0]), y(to_world[1]), z(to_world[2]);
    constexpr double tolerance = 1e-3;  // matrices are written with few digits; Mitsuba allows as much
    for (const Vec3& axis : {x, y, z})
        if (std::abs(glm::dot(axis, axis) - 1) > tolerance)
            properties.refuse_parameter(
                "to_world",
                fmt::format("to_world scales (an axis has length {}); a camera can be moved and turned only", glm::length(axis)));
    if (std::abs(glm::dot(x, y)) + std::abs(glm::dot(y, z)) + std::abs(glm::dot(z, x)) > tolerance)
        properties.refuse_parameter("to_world", "to_world shears; a camera can be moved and turned only");
    const Vec3 forward = glm::normalize(z), up = glm::normalize(y - glm::dot(y, forward) * forward);
    const Vec3 left = glm::cross(up, forward) * (glm::dot(glm::cross(up, forward), x) < 0 ? -1. : 1.);
    return Mat4(glm::dvec4(left, 0), glm::dvec4(up, 0), glm::dvec4(forward, 0), to_world[3]);
}

void check_sampler(SceneBuilder& builder, const XmlElement& element)
{
    Properties properties(element, builder.document);  // passes and random numbers are the command line's
    properties.ignore_parameters();
    properties.finish();
}

}  // namespace

Camera read_sensor(SceneBuilder& builder, const XmlElement& element)
{
    Properties properties(element, builder.document);
    if (properties.type() != "perspective") properties.refuse_type({"perspective"});
    Camera camera{.where = properties.where()};
    if (const XmlElement* film = properties.single("film")) read_film(builder, *film, camera);
    if (const XmlElement* sampler = properties.single("sampler")) check_sampler(builder, *sampler);
    camera.fov_x = read_horizontal_fov(properties, static_cast<double>(camera.width) / camera.height);
    camera.near_clip = properties.real("near_clip", .01, Range::positive());
    camera.far_clip = properties.real("far_clip", 1e4, Range::positive());
    if (!(camera.near_clip < camera.far_clip))
        properties.refuse_parameter("near_clip",
                                    fmt::format("near_clip = {} must be less than far_clip = {}", camera.near_clip, camera.far_clip));
    camera.principal_x = properties.real("principal_point_offset_x", 0);
    camera.principal_y = properties.real("principal_point_offset_y", 0);
    for (const char* no_effect : {"focus_distance", "shutter_open", "shutter_close"})
        properties.real(no_effect, 0);  // a pinhole, and nothing moves
    camera.to_world = rigid(properties, properties.transform("to_world"));
    camera.medium = read_only_medium(builder, properties);
    properties.finish();
    return camera;
}

}  // namespace tyndall
