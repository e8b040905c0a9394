// Shapes: rectangle, cube, obj, ply (meshes), sphere, disk, cylinder (analytic).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scene/mesh_files.hpp"
#include "scene/mesh_geometry.hpp"
#include "scene/scene_builder.hpp"
#include "scene/text.hpp"
#include "scene/transforms.hpp"

namespace tyndall {

namespace {

constexpr std::uintmax_t largest_mesh_file = std::uintmax_t{1} << 31;

/// Lengths of the axes of to_world, after checking that they are perpendicular.
Vec3 axis_lengths(Properties& properties, const Mat4& to_world)
{
    const Vec3 x(to_world[0]), y(to_world[1]), z(to_world[2]), lengths(glm::length(x), glm::length(y), glm::length(z));
    const double shear = std::max({std::abs(glm::dot(x, y)) / (lengths.x * lengths.y), std::abs(glm::dot(y, z)) / (lengths.y * lengths.z),
                                   std::abs(glm::dot(z, x)) / (lengths.z * lengths.x)});
    if (shear > 1e-6)
        properties.refuse_parameter("to_world", fmt::format("to_world shears, which a {} cannot follow; use a mesh", properties.type()));
    return lengths;
}

void require_same(Properties& properties, double a, double b, const char* which)
{
    if (std::abs(a - b) > 1e-6 * std::max(a, b))
        properties.refuse_parameter(
            "to_world", fmt::format("to_world scales {} differently ({} and {}), which a {} cannot follow; use a mesh", which, a, b,
                                    properties.type()));
}

/// The same set of points with a right-handed, exactly perpendicular frame: the first axis follows from the other two.
Mat4 right_handed(const Mat4& to_world, const Vec3& lengths)
{
    const Vec3 z = glm::normalize(Vec3(to_world[2])), y = glm::normalize(Vec3(to_world[1]) - glm::dot(Vec3(to_world[1]), z) * z);
    return Mat4(glm::dvec4(lengths.x * glm::cross(y, z), 0), glm::dvec4(lengths.y * y, 0), glm::dvec4(lengths.z * z, 0), to_world[3]);
}

void read_sphere(Properties& properties, Shape& shape, const Mat4& to_world)
{
    const Vec3 lengths = axis_lengths(properties, to_world);
    require_same(properties, lengths.x, lengths.y, "x and y");
    require_same(properties, lengths.x, lengths.z, "x and z");
    const double radius = properties.real("radius", 1, Range::positive());
    const Vec3 centre = transform_point(to_world, properties.vector("center", Vec3(0)));
    shape.type = Shape::Type::sphere;
    shape.to_world = translation(centre) * scaling(Vec3(lengths.x * radius));
}

void read_disk(Properties& properties, Shape& shape, const Mat4& to_world)
{
    shape.type = Shape::Type::disk;
    shape.to_world = right_handed(to_world, axis_lengths(properties, to_world));
}

void read_cylinder(Properties& properties, Shape& shape, const Mat4& to_world)
{
    const Vec3 lengths = axis_lengths(properties, to_world);
    require_same(properties, lengths.x, lengths.y, "x and y");
    const double radius = properties.real("radius", 1, Range::positive());
    const Vec3 p0 = properties.vector("p0", Vec3(0)), p1 = properties.vector("p1", Vec3(0, 0, 1));
    if (p0 == p1) properties.refuse_parameter("p1", "p0 and p1 are the same point; a cylinder needs a length");
    const bool along_z = p0.x == p1.x && p0.y == p1.y;
    if (!along_z) require_same(properties, lengths.x, lengths.z, "x and z");
    const Vec3 a = transform_point(to_world, p0), b = transform_point(to_world, p1), axis = glm::normalize(b - a);
    const Vec3 aside = std::abs(axis.x) < .5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0), y = glm::normalize(glm::cross(axis, aside));
    shape.type = Shape::Type::cylinder;
    shape.to_world = Mat4(glm::dvec4(radius * lengths.x * glm::cross(y, axis), 0), glm::dvec4(radius * lengths.x * y, 0),
                          glm::dvec4(b - a, 0), glm::dvec4(a, 1));
}

Mesh read_mesh_file(SceneBuilder& builder, Properties& properties)
{
    const std::string name = properties.text("filename", "");
    if (name.empty()) properties.refuse_parameter("filename", "needs <string name=\"filename\" value=\"...\"/>");
    const bool is_obj = properties.type() == "obj", face_normals = properties.boolean("face_normals", false);
    const bool flip = properties.boolean("flip_tex_coords", is_obj);
    const SourceLocation where = properties.where_is("filename");
    const SceneFiles::Content content = builder.files.read(name, where, largest_mesh_file);
    MeshFile file;
    try {
        file = is_obj ? read_obj(content.bytes) : read_ply(content.bytes);
    } catch (const MeshFault& fault) {
        refuse(where, fmt::format("{}: {}: {}", properties.title(), printable(name), fault.what()));
    }
    for (const std::string& remark : file.remarks)
        builder.warn(where, fmt::format("{}: {}: {}", properties.title(), printable(name), remark));
    if (face_normals) file.mesh.normals.clear();
    if (!face_normals && file.mesh.normals.empty())
        builder.warn(where, fmt::format("{}: {}: has no vertex normals and is shaded flat (Mitsuba would smooth it); write face_normals = "
                                        "true if flat is meant, or "
                                        "export normals",
                                        properties.title(), printable(name)));
    if (flip)
        for (Vec2& uv : file.mesh.uvs) uv.y = 1 - uv.y;
    return std::move(file.mesh);
}

void read_mesh(SceneBuilder& builder, Properties& properties, Shape& shape, const Mat4& to_world)
{
    shape.type = Shape::Type::mesh;
    shape.mesh = properties.type() == "rectangle" ? rectangle_mesh()
                 : properties.type() == "cube"    ? cube_mesh()
                                                  : read_mesh_file(builder, properties);
    transform_mesh(shape.mesh, to_world);
    classify_mesh(shape.mesh);
    if (shape.mesh.triangles.empty()) refuse(properties.where(), properties.title() + ": no triangle of it has an area");
    const bool from_file = properties.type() == "obj" || properties.type() == "ply";
    if (from_file && glm::determinant(glm::dmat3(to_world)) < 0)
        builder.warn(properties.where_is("to_world"),
                     properties.title() + ": to_world mirrors; its outside stays outside here, while Mitsuba turns the mesh inside out");
}

void read_geometry(SceneBuilder& builder, Properties& properties, Shape& shape)
{
    const Mat4 to_world = properties.transform("to_world");
    const std::string& type = properties.type();
    if (type == "sphere")
        read_sphere(properties, shape, to_world);
    else if (type == "disk")
        read_disk(properties, shape, to_world);
    else if (type == "cylinder")
        read_cylinder(properties, shape, to_world);
    else if (type == "rectangle" || type == "cube" || type == "obj" || type == "ply")
        read_mesh(builder, properties, shape, to_world);
    else
        properties.refuse_type({"rectangle", "cube", "sphere", "disk", "cylinder", "obj", "ply"});
    const Bounds bounds = bounds_of(shape);
    for (const Vec3& corner : {bounds.low, bounds.high})
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(corner[axis]) <= largest_coordinate))
                refuse(properties.where(), fmt::format("{}: reaches beyond {:g}", properties.title(), largest_coordinate));
}

void read_media(SceneBuilder& builder, Properties& properties, Shape& shape)
{
    std::array<bool, 2> seen{};
    for (const Nested& medium : properties.nested("medium")) {
        if (medium.role != "interior" && medium.role != "exterior")
            refuse(medium.mention->where,
                   fmt::format("{}: the medium {} needs name=\"interior\" or name=\"exterior\"{}", properties.title(),
                               in_quotes(medium.object->find("id") ? medium.object->value_of("id") : medium.object->value_of("type")),
                               suggestion(medium.role, {"interior", "exterior"})));
        const bool is_interior = medium.role == "interior";
        if (std::exchange(seen[is_interior], true))
            refuse(medium.mention->where, fmt::format("{}: a second {} medium", properties.title(), medium.role));
        (is_interior ? shape.interior : shape.exterior) = read_medium(builder, *medium.object);
        shape.medium_boundary = true;
    }
}

/// A picture on a mesh that does not say where on it.
void warn_without_coordinates(SceneBuilder& builder, const Shape& shape)
{
    if (shape.type != Shape::Type::mesh || !shape.mesh.uvs.empty()) return;
    const Bsdf& bsdf = builder.scene.bsdfs[static_cast<std::size_t>(shape.bsdf)];
    if (bsdf.reflectance_texture == none && bsdf.transmittance_texture == none && bsdf.diffuse_texture == none) return;
    builder.warn(shape.where, fmt::format("shape {}: has no texture coordinates, so that every triangle shows half of the unit square of its texture; export them", in_quotes(shape.name)));
}

}  // namespace

void read_shape(SceneBuilder& builder, const XmlElement& element)
{
    Properties properties(element, builder.document);
    Shape shape{.name = properties.id_or_type(), .where = properties.where()};
    read_geometry(builder, properties, shape);
    shape.flip_normals = properties.boolean("flip_normals", false);
    read_media(builder, properties, shape);
    const int index = static_cast<int>(builder.scene.shapes.size());
    if (const XmlElement* emitter = properties.single("emitter")) {
        shape.emitter = read_emitter(builder, *emitter, index);
        // The glowing side is the side of the normal: what lies there is the exterior, if the shape says what that is.
        Emitter& light = builder.scene.emitters[static_cast<std::size_t>(shape.emitter)];
        if (light.medium == vacuum && shape.medium_boundary) light.medium = shape.exterior;
    }
    const XmlElement* bsdf = properties.single("bsdf");
    shape.bsdf = bsdf ? read_bsdf(builder, *bsdf) : default_bsdf(builder, shape.emitter != none);
    warn_without_coordinates(builder, shape);
    if (shape.emitter != none && builder.scene.bsdfs[static_cast<std::size_t>(shape.bsdf)].type == Bsdf::Type::null)
        refuse(properties.where(), properties.title() + ": glows, but its bsdf is null: light cannot leave a surface that is not there; give it another bsdf");
    properties.finish();
    builder.scene.shapes.push_back(std::move(shape));
}

}  // namespace tyndall
