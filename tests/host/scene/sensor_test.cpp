// Camera and film: each parameter, each default.
#include <cmath>
#include <numbers>

#include "scene/render_space.hpp"
#include "scene/transforms.hpp"
#include "scene_text.hpp"

namespace tyndall::test {

Scene with_sensor(const std::string& inside, const std::string& film = "", const std::string& more = "")
{
    return parse("<scene version=\"3.0.0\"><sensor type=\"perspective\">" + inside + "<film type=\"hdrfilm\">" + film + "</film></sensor>" +
                 more + "</scene>");
}
std::string sensor_fault(const std::string& inside, const std::string& film = "")
{
    return fault("<scene version=\"3.0.0\"><sensor type=\"perspective\">\n" + inside + "<film type=\"hdrfilm\">\n" + film +
                 "</film></sensor></scene>");
}
const std::string fov45 = R"(<float name="fov" value="45"/>)";
const std::string wide = R"(<integer name="width" value="64"/><integer name="height" value="32"/>)",
                  tall = R"(<integer name="width" value="32"/><integer name="height" value="64"/>)";

double fov_degrees(const std::string& axis, const std::string& film)
{
    return with_sensor(R"(<float name="fov" value="40"/><string name="fov_axis" value=")" + axis + "\"/>", film).camera.fov_x * 180 /
           std::numbers::pi;
}

TEST(Sensor, DefaultsAreMitsubas)
{
    const Camera camera = parse("<scene version=\"3.0.0\"><sensor type=\"perspective\"/></scene>").camera;
    EXPECT_EQ(camera.width, 768);
    EXPECT_EQ(camera.height, 576);
    EXPECT_EQ(camera.crop_x, 0);
    EXPECT_EQ(camera.crop_width, 768);
    EXPECT_EQ(camera.crop_height, 576);
    EXPECT_EQ(camera.filter.type, Filter::Type::gaussian);
    EXPECT_EQ(camera.filter.stddev, .5);
    EXPECT_EQ(camera.near_clip, .01);  // the scene is one point: the unit is 1
    EXPECT_EQ(camera.far_clip, 1e4);
    EXPECT_EQ(camera.medium, vacuum);
    EXPECT_EQ(camera.principal_x, 0);
    EXPECT_EQ(camera.principal_y, 0);
    // 50 mm on 36 x 24 mm film; Mitsuba 3.9 prints 38.1848 for 4:3
    EXPECT_NEAR(camera.fov_x * 180 / std::numbers::pi, 38.1848, 5e-5);
}

TEST(Sensor, FovIsMeasuredAlongItsAxis)
{
    const double half = 20 * std::numbers::pi / 180, doubled = 360 / std::numbers::pi * std::atan(2 * std::tan(half)),
                 halved = 360 / std::numbers::pi * std::atan(std::tan(half) / 2);
    EXPECT_NEAR(fov_degrees("x", wide), 40, 1e-12);
    EXPECT_NEAR(fov_degrees("x", tall), 40, 1e-12);
    EXPECT_NEAR(fov_degrees("y", wide), doubled, 1e-12);
    EXPECT_NEAR(fov_degrees("y", tall), halved, 1e-12);
    EXPECT_NEAR(fov_degrees("smaller", wide), doubled, 1e-12);
    EXPECT_NEAR(fov_degrees("smaller", tall), 40, 1e-12);
    EXPECT_NEAR(fov_degrees("larger", wide), 40, 1e-12);
    EXPECT_NEAR(fov_degrees("larger", tall), halved, 1e-12);
    // Mitsuba 3.9 prints these four, with six digits
    EXPECT_NEAR(fov_degrees("y", wide), 72.1048, 5e-5);
    EXPECT_NEAR(fov_degrees("y", tall), 20.6282, 5e-5);
    EXPECT_NEAR(fov_degrees("diagonal", wide), 36.0648, 5e-5);
    EXPECT_NEAR(fov_degrees("diagonal", tall), 18.4902, 5e-5);
    // across the diagonal of 2 x 1: its tangent is shared out as 2 : sqrt(5)
    EXPECT_NEAR(fov_degrees("diagonal", wide), 360 / std::numbers::pi * std::atan(std::tan(half) * 2 / std::sqrt(5.)), 1e-12);
}

TEST(Sensor, FocalLengthIsOfThirtyFiveMillimetreFilm)
{
    const double diagonal = std::sqrt(36. * 36 + 24. * 24), aspect = 2;
    for (const char* text : {"35mm", "35"}) {
        const Camera camera = with_sensor(std::string(R"(<string name="focal_length" value=")") + text + "\"/>", wide).camera;
        EXPECT_NEAR(camera.fov_x, 2 * std::atan(diagonal / 70 / std::sqrt(1 + 1 / (aspect * aspect))), 1e-14);
    }
    EXPECT_NE(sensor_fault(fov45 + R"(<string name="focal_length" value="35mm"/>)").find("exclude each other"), std::string::npos);
    EXPECT_NE(sensor_fault(R"(<string name="focal_length" value="35cm"/>)").find("is not a length"), std::string::npos);
    EXPECT_NE(sensor_fault(R"(<string name="fov_axis" value="x"/>)").find("fov_axis goes with fov"), std::string::npos);
}

TEST(Sensor, FilmParametersAreRead)
{
    const Camera camera = with_sensor(fov45, R"(<integer name="width" value="640"/><integer name="height" value="480"/>
        <integer name="crop_offset_x" value="10"/><integer name="crop_offset_y" value="20"/><integer name="crop_width" value="100"/><integer name="crop_height" value="50"/>
        <string name="pixel_format" value="rgba"/><string name="component_format" value="float32"/><string name="file_format" value="openexr"/>
        <rfilter type="gaussian"><float name="stddev" value="0.75"/></rfilter>)")
                              .camera;
    EXPECT_EQ(camera.width, 640);
    EXPECT_EQ(camera.height, 480);
    EXPECT_EQ(camera.crop_x, 10);
    EXPECT_EQ(camera.crop_y, 20);
    EXPECT_EQ(camera.crop_width, 100);
    EXPECT_EQ(camera.crop_height, 50);
    EXPECT_EQ(camera.filter.stddev, .75);
    EXPECT_EQ(with_sensor(fov45, "<rfilter type=\"box\"/>").camera.filter.type, Filter::Type::box);
}

TEST(Sensor, CameraParametersAreRead)
{
    const Scene scene = with_sensor(
        fov45 +
            R"(<float name="near_clip" value="0.5"/><float name="far_clip" value="80"/><float name="principal_point_offset_x" value="0.25"/>
        <float name="principal_point_offset_y" value="-0.125"/><sampler type="independent"><integer name="sample_count" value="16"/></sampler>
        <transform name="to_world"><lookat origin="0,0,4" target="0,0,0" up="0,1,0"/></transform><ref id="fog"/>)",
        "", R"(<medium type="homogeneous" id="fog"/>)" + unit_sphere);
    EXPECT_EQ(scene.camera.near_clip * scene.unit, .5);
    EXPECT_EQ(scene.camera.far_clip * scene.unit, 80);
    EXPECT_EQ(scene.camera.principal_x, .25);
    EXPECT_EQ(scene.camera.principal_y, -.125);
    EXPECT_EQ(scene.camera.medium, 0);
    EXPECT_EQ(to_file_space(scene, Vec3(scene.camera.to_world[3])), Vec3(0, 0, 4));
    EXPECT_EQ(Vec3(scene.camera.to_world[2]), Vec3(0, 0, -1));
}

TEST(Sensor, RowZeroIsAtTheTopAndColumnsGoRight)
{
    // The first pixel's centre of a 2 x 2 film, by the convention of Camera: right is local -x, up is local +y. Mitsuba 3.9 sends the
    // corner of a 90 degree camera at the origin that looks along -z to (-1, 1, -1): left and up.
    const Camera camera =
        with_sensor(
            R"(<float name="fov" value="90"/><transform name="to_world"><lookat origin="0,0,0" target="0,0,-1" up="0,1,0"/></transform>)")
            .camera;
    const double tangent = std::tan(camera.fov_x / 2);
    const Vec3 top_left = transform_direction(camera.to_world, Vec3(tangent, tangent, 1));
    expect_near(top_left, Vec3(-1, 1, -1), 1e-15);
}

TEST(Sensor, ToWorldIsMadeExactlyRigid)
{
    const Camera camera =
        with_sensor(fov45 +
                    R"(<transform name="to_world"><matrix value="0.7071 0 0.7071 1  0 1 0 2  -0.7071 0 0.7071 3  0 0 0 1"/></transform>)")
            .camera;
    const glm::dmat3 m(camera.to_world), product = glm::transpose(m) * m;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) EXPECT_NEAR(product[c][r], c == r, 1e-15);
    EXPECT_NEAR(m[2].x, std::sqrt(.5), 1e-12);
    const Camera mirrored = with_sensor(fov45 + R"(<transform name="to_world"><scale x="-1"/></transform>)").camera;
    EXPECT_EQ(Vec3(mirrored.to_world[0]), Vec3(-1, 0, 0));
}

TEST(Sensor, WrongValuesAreSentences)
{
    EXPECT_EQ(sensor_fault(R"(<float name="fov" value="180"/>)"),
              "scene.xml:2:1: sensor \"perspective\": fov = 180 must lie strictly between 0 and 180");
    EXPECT_EQ(sensor_fault(R"(<float name="fov" value="0"/>)"),
              "scene.xml:2:1: sensor \"perspective\": fov = 0 must lie strictly between 0 and 180");
    EXPECT_NE(
        sensor_fault(R"(<float name="fov" value="179.9"/><string name="fov_axis" value="z"/>)").find("fov_axis = \"z\" is not supported"),
        std::string::npos);
    EXPECT_EQ(sensor_fault(R"(<float name="near_clip" value="0"/>)"),
              "scene.xml:2:1: sensor \"perspective\": near_clip = 0 must be positive");
    EXPECT_NE(sensor_fault(R"(<float name="near_clip" value="2"/><float name="far_clip" value="1"/>)")
                  .find("near_clip = 2 must be less than far_clip = 1"),
              std::string::npos);
    EXPECT_NE(sensor_fault(R"(<transform name="to_world"><scale value="2"/></transform>)").find("a camera can be moved and turned only"),
              std::string::npos);
    EXPECT_NE(
        sensor_fault(R"(<transform name="to_world"><matrix value="1 .01 0 0  0 1 0 0  0 0 1 0  0 0 0 1"/></transform>)").find("shears"),
        std::string::npos);
    EXPECT_NE(fault("<scene version=\"3.0.0\"><sensor type=\"thinlens\"/></scene>").find("sensor type \"thinlens\" is not supported"),
              std::string::npos);
    EXPECT_NE(fault("<scene version=\"3.0.0\"/>").find("the scene has no <sensor>"), std::string::npos);
}

TEST(Sensor, WrongFilmsAreSentences)
{
    EXPECT_EQ(sensor_fault("", R"(<integer name="width" value="0"/>)"), "scene.xml:3:1: film \"hdrfilm\": width = 0 must be at least 1");
    EXPECT_EQ(sensor_fault("", R"(<integer name="height" value="-5"/>)"),
              "scene.xml:3:1: film \"hdrfilm\": height = -5 must be at least 1");
    EXPECT_EQ(sensor_fault("", R"(<integer name="crop_width" value="0"/>)"),
              "scene.xml:3:1: film \"hdrfilm\": crop_width = 0 must be at least 1");
    EXPECT_EQ(sensor_fault("", R"(<float name="width" value="64"/>)"),
              "scene.xml:3:1: film \"hdrfilm\": width is written as <float>; it must be <integer>");
    EXPECT_EQ(sensor_fault("", R"(<integer name="widht" value="64"/>)")
                  .find("scene.xml:3:1: film \"hdrfilm\": unknown parameter \"widht\" (did you mean \"width\"?); it takes: "),
              0u);
    EXPECT_NE(
        sensor_fault("", R"(<integer name="crop_width" value="700"/><integer name="crop_offset_x" value="100"/>)").find("does not fit"),
        std::string::npos);
    EXPECT_NE(sensor_fault("", R"(<integer name="width" value="60000"/><integer name="height" value="60000"/>)").find("at most 268435456"),
              std::string::npos);
    EXPECT_NE(sensor_fault("", R"(<integer name="width" value="1e3"/>)").find("is not an integer"), std::string::npos);
    EXPECT_NE(sensor_fault("", R"(<string name="pixel_format" value="luminance"/>)").find("pixel_format = \"luminance\" is not supported"),
              std::string::npos);
    EXPECT_NE(sensor_fault("", R"(<boolean name="sample_border" value="true"/>)").find("sample_border = true is not supported"),
              std::string::npos);
    EXPECT_NE(
        sensor_fault("", R"(<rfilter type="mitchell"/>)").find("rfilter type \"mitchell\" is not supported; supported: box, gaussian"),
        std::string::npos);
    EXPECT_NE(sensor_fault("", R"(<rfilter type="gaussian"><float name="stddev" value="0"/></rfilter>)")
                  .find("must lie strictly between 0 and 8"),
              std::string::npos);
}

TEST(Integrator, MaxDepthIsHonouredAndTheRestIsOurs)
{
    EXPECT_EQ(load_body("").max_depth, -1);
    EXPECT_EQ(load_body("").integrator, "");
    const Scene plain =
        load_body(R"(<integrator type="volpath"><integer name="max_depth" value="7"/><integer name="rr_depth" value="3"/></integrator>)");
    EXPECT_EQ(plain.max_depth, 7);
    EXPECT_EQ(plain.integrator, "volpath");
    const Scene nested = load_body(
        R"(<integrator type="aov"><string name="aovs" value="dd:depth"/><integrator type="path"><integer name="max_depth" value="4"/></integrator></integrator>)");
    EXPECT_EQ(nested.max_depth, 4);
    EXPECT_EQ(nested.integrator, "aov > path");
    EXPECT_EQ(fault_of_body("<integrator type=\"path\"><integer name=\"max_depth\" value=\"-2\"/></integrator>"),
              "scene.xml:2:25: integrator \"path\": max_depth = -2 must be at least -1");
    EXPECT_NE(fault_of_body("<integrator type=\"path\"><float name=\"max_depth\" value=\"2\"/></integrator>").find("it must be <integer>"),
              std::string::npos);
    const Scene misspelt = load_body(R"(<integrator type="path"><integer name="maxdepth" value="4"/></integrator>)");
    EXPECT_NE(misspelt.warnings[0].find("scene.xml:2:25: integrator \"path\": \"maxdepth\" is not looked at"), std::string::npos);
}

}  // namespace tyndall::test
