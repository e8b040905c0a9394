// Shapes: each parameter, each default, each refusal; positions are checked in the scene file's units.
#include "scene/render_space.hpp"
#include "scene/transforms.hpp"
#include "scene_text.hpp"

namespace tyndall::test {

std::string shape_fault(const std::string& type, const std::string& inside = "")
{
    return fault_of_body("<shape type=\"" + type + "\">\n" + inside + "</shape>");
}

/// The first shape with its vertices, or its matrix, in the file's units.
Shape shape_of(const std::string& type, const std::string& inside = "")
{
    const Scene scene = load_body("<shape type=\"" + type + "\">" + inside + "</shape>");
    Shape shape = scene.shapes.at(0);
    for (Vec3& vertex : shape.mesh.vertices) vertex = to_file_space(scene, vertex);
    const Vec3 origin = to_file_space(scene, Vec3(shape.to_world[3]));
    shape.to_world =
        Mat4(shape.to_world[0] * scene.unit, shape.to_world[1] * scene.unit, shape.to_world[2] * scene.unit, glm::dvec4(origin, 1));
    return shape;
}

Vec3 normal_of(const Mesh& mesh, std::size_t triangle)
{
    const auto t = mesh.triangles[triangle];
    return glm::normalize(glm::cross(mesh.vertices[t.y] - mesh.vertices[t.x], mesh.vertices[t.z] - mesh.vertices[t.x]));
}

TEST(Shape, RectangleIsTwoTrianglesFacingZ)
{
    const Shape shape = shape_of("rectangle");
    EXPECT_EQ(shape.type, Shape::Type::mesh);
    ASSERT_EQ(shape.mesh.triangles.size(), 2u);
    EXPECT_EQ(bounds_of(shape).low, Vec3(-1, -1, 0));
    EXPECT_EQ(bounds_of(shape).high, Vec3(1, 1, 0));
    for (std::size_t t : {0, 1}) EXPECT_EQ(normal_of(shape.mesh, t), Vec3(0, 0, 1));
    EXPECT_TRUE(shape.mesh.normals.empty());
    EXPECT_FALSE(shape.mesh.closed);
    EXPECT_FALSE(shape.flip_normals);
    EXPECT_FALSE(shape.medium_boundary);
    EXPECT_EQ(shape.interior, vacuum);
    EXPECT_EQ(shape.exterior, vacuum);
    EXPECT_EQ(shape.emitter, none);
    EXPECT_EQ(shape.name, "rectangle");
}

TEST(Shape, CubeFacesOutwards)
{
    const Shape shape = shape_of("cube");
    ASSERT_EQ(shape.mesh.triangles.size(), 12u);
    EXPECT_EQ(bounds_of(shape).low, Vec3(-1));
    EXPECT_EQ(bounds_of(shape).high, Vec3(1));
    EXPECT_TRUE(shape.mesh.closed);
    EXPECT_TRUE(shape.mesh.convex);
    for (std::size_t t = 0; t < 12; ++t) EXPECT_GT(glm::dot(normal_of(shape.mesh, t), shape.mesh.vertices[shape.mesh.triangles[t].x]), .99);
}

TEST(Shape, MirroringKeepsTheOutsideOutside)
{
    const Shape cube = shape_of("cube", R"(<transform name="to_world"><scale x="-1"/></transform>)");
    for (std::size_t t = 0; t < 12; ++t) EXPECT_GT(glm::dot(normal_of(cube.mesh, t), cube.mesh.vertices[cube.mesh.triangles[t].x]), .99);
    const Shape rectangle = shape_of("rectangle", R"(<transform name="to_world"><scale x="-1"/></transform>)");
    EXPECT_EQ(normal_of(rectangle.mesh, 0), Vec3(0, 0, 1));
    const Shape disk = shape_of("disk", R"(<transform name="to_world"><scale x="-1"/></transform>)");
    EXPECT_GT(glm::determinant(glm::dmat3(disk.to_world)), 0);
    EXPECT_EQ(Vec3(disk.to_world[2]), Vec3(0, 0, 1));
}

TEST(Shape, SphereTakesCenterRadiusAndTransform)
{
    EXPECT_EQ(shape_of("sphere").type, Shape::Type::sphere);
    EXPECT_EQ(shape_of("sphere").to_world, Mat4(1));
    // Mitsuba 3.9 prints center (3, 4, 6), radius 4 for this
    const Shape shape = shape_of("sphere", R"(<point name="center" x="1" y="2" z="3"/><float name="radius" value="2"/>
        <transform name="to_world"><scale value="2"/><translate x="1"/></transform>)");
    EXPECT_EQ(Vec3(shape.to_world[3]), Vec3(3, 4, 6));
    EXPECT_EQ(glm::length(Vec3(shape.to_world[0])), 4);
    EXPECT_EQ(bounds_of(shape).low, Vec3(-1, 0, 2));
    EXPECT_EQ(bounds_of(shape).high, Vec3(7, 8, 10));
    EXPECT_NE(shape_fault("sphere", R"(<transform name="to_world"><scale x="2"/></transform>)")
                  .find("scene.xml:3:1: shape \"sphere\": to_world scales x and y differently"),
              std::string::npos);
    EXPECT_EQ(shape_fault("sphere", R"(<float name="radius" value="-1"/>)"),
              "scene.xml:3:1: shape \"sphere\": radius = -1 must be positive");
    EXPECT_EQ(shape_fault("sphere", R"(<float name="raduis" value="1"/>)")
                  .find("scene.xml:3:1: shape \"sphere\": unknown parameter \"raduis\" (did you mean \"radius\"?)"),
              0u);
}

TEST(Shape, RotatedSphereIsTheSameSphere)
{
    const Shape shape =
        shape_of("sphere", R"(<transform name="to_world"><rotate value="1 2 3" angle="40"/><translate x="1"/></transform>)");
    expect_near(Vec3(shape.to_world[3]), Vec3(1, 0, 0), 1e-15);
    expect_near(Vec3(shape.to_world[0]), Vec3(1, 0, 0), 1e-15);
}

TEST(Shape, DiskMayBeAnEllipse)
{
    EXPECT_EQ(shape_of("disk").to_world, Mat4(1));
    const Shape shape =
        shape_of("disk", R"(<transform name="to_world"><scale x="2"/><rotate x="1" angle="90"/><translate z="5"/></transform>)");
    EXPECT_EQ(shape.type, Shape::Type::disk);
    EXPECT_EQ(Vec3(shape.to_world[0]), Vec3(2, 0, 0));
    EXPECT_EQ(Vec3(shape.to_world[1]), Vec3(0, 0, 1));
    EXPECT_EQ(Vec3(shape.to_world[2]), Vec3(0, -1, 0));
    EXPECT_EQ(bounds_of(shape).low, Vec3(-2, 0, 4));
    EXPECT_EQ(bounds_of(shape).high, Vec3(2, 0, 6));
    EXPECT_NE(shape_fault("disk", R"(<transform name="to_world"><matrix value="1 .5 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/></transform>)")
                  .find("to_world shears"),
              std::string::npos);
}

TEST(Shape, CylinderRunsFromP0ToP1)
{
    EXPECT_EQ(shape_of("cylinder").type, Shape::Type::cylinder);
    EXPECT_EQ(Vec3(shape_of("cylinder").to_world[2]), Vec3(0, 0, 1));
    // Mitsuba 3.9: origin (3, 4, 6), axis (6, 0, 8), radius 1
    const Shape shape =
        shape_of("cylinder", R"(<point name="p0" x="1" y="2" z="3"/><point name="p1" x="4" y="2" z="7"/><float name="radius" value=".5"/>
        <transform name="to_world"><scale value="2"/><translate x="1"/></transform>)");
    EXPECT_EQ(Vec3(shape.to_world[3]), Vec3(3, 4, 6));
    EXPECT_EQ(Vec3(shape.to_world[2]), Vec3(6, 0, 8));
    for (int axis : {0, 1}) {
        EXPECT_NEAR(glm::length(Vec3(shape.to_world[axis])), 1, 1e-15);
        EXPECT_NEAR(glm::dot(Vec3(shape.to_world[axis]), Vec3(6, 0, 8)), 0, 1e-14);
    }
    EXPECT_GT(glm::determinant(glm::dmat3(shape.to_world)), 0);
    EXPECT_NE(shape_fault("cylinder", R"(<point name="p1" x="0"/>)").find("p0 and p1 are the same point"), std::string::npos);
    EXPECT_NE(shape_fault("cylinder", R"(<transform name="to_world"><scale x="2"/></transform>)").find("scales x and y differently"),
              std::string::npos);
    EXPECT_EQ(Vec3(shape_of("cylinder", R"(<transform name="to_world"><scale z="3"/></transform>)").to_world[2]), Vec3(0, 0, 3));
}

TEST(Shape, MediaAreReferencedOrNested)
{
    const Scene scene = load_body(R"(<medium type="homogeneous" id="juice"/><shape type="cube"><ref name="interior" id="juice"/>
        <medium name="exterior" type="homogeneous"><float name="albedo" value="0.5"/></medium><bsdf type="null"/></shape>)");
    EXPECT_TRUE(scene.shapes[0].medium_boundary);
    EXPECT_EQ(scene.media[static_cast<std::size_t>(scene.shapes[0].interior)].name, "juice");
    EXPECT_EQ(scene.media[static_cast<std::size_t>(scene.shapes[0].exterior)].albedo, Rgb(.5));
    EXPECT_EQ(shape_fault("cube", R"(<medium type="homogeneous"/>)"),
              "scene.xml:3:1: shape \"cube\": the medium \"homogeneous\" needs name=\"interior\" or name=\"exterior\"");
    EXPECT_NE(shape_fault("cube", R"(<medium type="homogeneous" name="inteiror"/>)").find("(did you mean \"interior\"?)"),
              std::string::npos);
    EXPECT_NE(shape_fault("cube", R"(<medium type="homogeneous" name="interior"/><medium type="homogeneous" name="interior"/>)")
                  .find("a second interior medium"),
              std::string::npos);
}

TEST(Shape, WithoutBsdfIsDiffuseHalfOrBlackIfItGlows)
{
    const Scene scene = load_body(R"(<shape type="cube"/><shape type="sphere"/><shape type="disk"><emitter type="area"/></shape>)");
    const auto bsdf = [&](std::size_t i) { return scene.bsdfs[static_cast<std::size_t>(scene.shapes[i].bsdf)]; };
    EXPECT_EQ(bsdf(0).type, Bsdf::Type::diffuse);
    EXPECT_EQ(bsdf(0).reflectance, Rgb(.5));
    EXPECT_EQ(scene.shapes[0].bsdf, scene.shapes[1].bsdf);
    EXPECT_EQ(bsdf(2).reflectance, Rgb(0));
}

TEST(Shape, BsdfIsNestedOrReferenced)
{
    const Scene scene = load_body(
        R"(<bsdf type="diffuse" id="white"><float name="reflectance" value="1"/></bsdf><shape type="cube"><ref id="white"/></shape>
        <shape type="cube" id="box"><bsdf type="null"/><boolean name="flip_normals" value="true"/></shape>)");
    EXPECT_EQ(scene.shapes[0].bsdf, 0);
    EXPECT_EQ(scene.bsdfs.size(), 2u);
    EXPECT_EQ(scene.bsdfs[static_cast<std::size_t>(scene.shapes[1].bsdf)].type, Bsdf::Type::null);
    EXPECT_TRUE(scene.shapes[1].flip_normals);
    EXPECT_EQ(scene.shapes[1].name, "box");
    EXPECT_NE(shape_fault("cube", "<bsdf type=\"null\"/><bsdf type=\"null\"/>").find("scene.xml:3:20: shape \"cube\": a second bsdf"),
              std::string::npos);
}

TEST(Shape, WrongThingsAreRefusedByName)
{
    EXPECT_EQ(fault_of_body("<shape type=\"instance\"/>"),
              "scene.xml:2:1: shape type \"instance\" is not supported; supported: rectangle, cube, sphere, disk, cylinder, obj, ply");
    EXPECT_EQ(shape_fault("cube", "<texture type=\"bitmap\" name=\"mask\"/>")
                  .find("scene.xml:3:1: shape \"cube\": <texture type=\"bitmap\"> is not supported here; it takes: bsdf, emitter, medium"),
              0u);
    EXPECT_EQ(shape_fault("cube", "<float name=\"to_world\" value=\"2\"/>"),
              "scene.xml:3:1: shape \"cube\": to_world is written as <float>; it must be <transform>");
    EXPECT_EQ(shape_fault("cube", "<boolean name=\"flip_normals\" value=\"yes\"/>"),
              "scene.xml:3:1: shape \"cube\": flip_normals = \"yes\" must be \"true\" or \"false\"");
    EXPECT_EQ(shape_fault("cube", "<sensor type=\"perspective\"/>")
                  .find("scene.xml:3:1: shape \"cube\": <sensor type=\"perspective\"> is not supported here"),
              0u);
    EXPECT_NE(shape_fault("sphere", "<point name=\"center\" x=\"1e150\"/>").find("reaches beyond 1e+100"), std::string::npos);
}

}  // namespace tyndall::test
