// What can be rendered but is probably not meant.
#include "scene/scene_warnings.hpp"

#include "scene_text.hpp"

namespace tyndall::test {

const std::string fog = R"(<medium type="homogeneous" id="fog"/>)",
                  lamp = R"(<emitter type="point"><point name="position" z="9"/></emitter>)";
const std::string outside_camera =
    R"(<sensor type="perspective"><float name="fov" value="45"/><transform name="to_world"><translate z="9"/></transform></sensor>)";

/// The warnings of a scene whose camera stands at z = 9; the body starts line 2.
std::vector<std::string> warnings_of(const std::string& body)
{
    return parse("<scene version=\"3.0.0\">" + outside_camera + "\n" + body + "</scene>").warnings;
}

TEST(Warning, MediumReferencedByNothing)
{
    const auto warnings = warnings_of(fog + lamp);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0],
              "scene.xml:2:1: medium \"fog\": nothing refers to it, so it is nowhere; give a shape <ref name=\"interior\" id=\"fog\"/>");
    EXPECT_TRUE(warnings_of(fog + lamp + R"(<shape type="cube"><ref name="interior" id="fog"/></shape>)").empty());
}

TEST(Warning, LeakingContainer)
{
    const TemporaryFolder folder;
    folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");  // a tetrahedron without its largest face
    const auto leaks = [&](const std::string& shape) {
        const auto file = folder.write("scene.xml", "<scene version=\"3.0.0\">" + outside_camera + fog + lamp + "\n" + shape + "</scene>");
        std::size_t count = 0;
        for (const std::string& warning : load_scene(file).warnings)
            count += warning.find(":2:") != std::string::npos && warning.find("the medium leaks") != std::string::npos;
        return count;
    };
    const std::string inside = R"(<ref name="interior" id="fog"/></shape>)";
    EXPECT_EQ(leaks(R"(<shape type="obj"><string name="filename" value="open.obj"/>)" + inside), 1u);
    EXPECT_EQ(leaks(R"(<shape type="rectangle">)" + inside), 1u);
    EXPECT_EQ(leaks(R"(<shape type="cylinder">)" + inside), 1u);
    EXPECT_EQ(leaks(R"(<shape type="cube">)" + inside), 0u);
    EXPECT_EQ(leaks(R"(<shape type="sphere">)" + inside), 0u);
    EXPECT_EQ(leaks(R"(<shape type="rectangle"></shape>)"), 0u);
    // the missing face as a shape of its own, facing outwards or inwards
    folder.write("lid.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
    folder.write("inverted.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\n");
    const std::string open = R"(<shape type="obj"><string name="filename" value="open.obj"/>)" + inside;
    EXPECT_EQ(leaks(open + R"(<shape type="obj"><string name="filename" value="lid.obj"/>)" + inside), 0u);
    EXPECT_EQ(leaks(open + R"(<shape type="obj"><string name="filename" value="inverted.obj"/>)" + inside), 2u);
    EXPECT_EQ(leaks(open + R"(<shape type="obj"><string name="filename" value="lid.obj"/></shape>)"), 1u);
}

TEST(Warning, GlassThatDoesNotEndTheMediumAroundIt)
{
    const std::string box = R"(<shape type="cube"><bsdf type="null"/><ref name="interior" id="fog"/></shape>)";
    const auto ball = [](const std::string& bsdf, const std::string& content, const std::string& where = "0") {
        return "<shape type=\"sphere\" id=\"ball\"><point name=\"center\" x=\"" + where + "\"/><float name=\"radius\" value=\".3\"/><bsdf type=\"" + bsdf + "\"/>" + content + "</shape>";
    };
    for (const char* glass : {"dielectric", "roughdielectric"}) {
        const auto warnings = warnings_of(fog + lamp + box + ball(glass, ""));
        ASSERT_EQ(warnings.size(), 1u) << glass;
        EXPECT_EQ(warnings[0].find("scene.xml:2:"), 0u);
        EXPECT_NE(warnings[0].find("shape \"ball\": lets light through and names no interior medium, so medium \"fog\" goes on inside of it"), std::string::npos) << warnings[0];
        EXPECT_TRUE(warnings_of(fog + lamp + box + ball(glass, R"(<ref name="exterior" id="fog"/>)")).empty());
        EXPECT_TRUE(warnings_of(fog + lamp + box + ball(glass, "", "5")).empty()) << "it stands outside of the fog";
    }
    for (const char* other : {"diffuse", "thindielectric", "conductor"}) EXPECT_TRUE(warnings_of(fog + lamp + box + ball(other, "")).empty()) << other;
    const std::string cube = R"(<shape type="cube"><transform name="to_world"><scale value=".2"/></transform><bsdf type="dielectric"/></shape>)";
    EXPECT_EQ(warnings_of(fog + lamp + box + cube).size(), 1u);
}

TEST(Warning, LightInsideAMediumWithoutItsRef)
{
    const std::string box = R"(<shape type="cube"><bsdf type="null"/><ref name="interior" id="fog"/></shape>)";
    for (const char* light :
         {R"(<emitter type="point"/>)", R"(<emitter type="spot"/>)",
          R"(<shape type="rectangle"><transform name="to_world"><scale value="0.1"/></transform><emitter type="area"/></shape>)",
          R"(<shape type="sphere"><float name="radius" value="0.1"/><emitter type="area"/></shape>)",
          R"(<shape type="disk"><transform name="to_world"><scale value="0.1"/></transform><emitter type="area"/></shape>)",
          R"(<shape type="cylinder"><transform name="to_world"><scale value="0.1"/></transform><emitter type="area"/></shape>)"}) {
        const auto warnings = warnings_of(fog + box + light);
        ASSERT_EQ(warnings.size(), 1u) << light;
        EXPECT_NE(warnings[0].find("seems to stand inside medium \"fog\" without saying so"), std::string::npos) << light;
        EXPECT_EQ(warnings[0].find("scene.xml:2:"), 0u);
    }
    EXPECT_TRUE(warnings_of(fog + box + R"(<emitter type="point"><ref id="fog"/></emitter>)").empty());
    EXPECT_TRUE(warnings_of(fog + box + R"(<emitter type="point"><point name="position" x="3"/></emitter>)").empty());
    EXPECT_TRUE(warnings_of(fog + box + R"(<emitter type="directional"/><emitter type="constant"/>)").empty());
}

TEST(Warning, LightInUnboundedFogOfTheCamera)
{
    const std::string scene = "<scene version=\"3.0.0\">" + fog +
                              R"(<sensor type="perspective"><ref id="fog"/></sensor><emitter type="point"><point name="position" x="1"/>)";
    EXPECT_EQ(parse(scene + "</emitter></scene>").warnings.size(), 1u);
    EXPECT_TRUE(parse(scene + "<ref id=\"fog\"/></emitter></scene>").warnings.empty());
}

TEST(Warning, CameraInsideAMediumWithoutItsRef)
{
    const auto warnings = load_body(fog + lamp + R"(<shape type="sphere"><ref name="interior" id="fog"/></shape>)").warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0], "scene.xml:1:24: the sensor seems to stand inside medium \"fog\" without saying so; give it <ref id=\"fog\"/>");
}

TEST(Warning, SceneWithoutLightIsBlack)
{
    ASSERT_EQ(load_body("").warnings.size(), 1u);
    EXPECT_NE(load_body("").warnings[0].find("has no emitter"), std::string::npos);
}

TEST(MediumAt, FollowsNestedFlippedAndRoundBoundaries)
{
    const Scene scene = load_body(R"(<medium type="homogeneous" id="outer"/><medium type="homogeneous" id="inner"/>
        <shape type="sphere"><float name="radius" value="4"/><ref name="interior" id="outer"/></shape>
        <shape type="cube"><boolean name="flip_normals" value="true"/><ref name="exterior" id="inner"/><ref name="interior" id="outer"/></shape>)");
    const Vec3 far = Vec3(10, .3, .2) / scene.unit;
    const auto at = [&](double x) { return medium_at(scene, far, vacuum, Vec3(x, .01, .02) / scene.unit); };
    EXPECT_EQ(at(5), vacuum);
    EXPECT_EQ(at(2), 0);
    EXPECT_EQ(at(.5), 1) << "flipped: the cube's exterior side is its inside";
    EXPECT_EQ(at(-2), 0);
    EXPECT_EQ(at(-5), vacuum);
}

}  // namespace tyndall::test
