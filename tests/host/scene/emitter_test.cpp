// Lights: each parameter, each default, each refusal.
#include <numbers>

#include "scene/render_space.hpp"
#include "scene_text.hpp"

namespace tyndall::test {

constexpr double degree = std::numbers::pi / 180;

Emitter emitter_of(const std::string& type, const std::string& inside = "", Scene* whole = nullptr)
{
    const Scene scene = load_body("<emitter type=\"" + type + "\">" + inside + "</emitter>" + unit_sphere);
    if (whole) *whole = scene;
    Emitter emitter = scene.emitters.at(0);
    emitter.position = to_file_space(scene, emitter.position);
    if (emitter.type == Emitter::Type::point || emitter.type == Emitter::Type::spot) emitter.value *= scene.unit * scene.unit;
    return emitter;
}
std::string emitter_fault(const std::string& type, const std::string& inside = "")
{
    return fault_of_body("<emitter type=\"" + type + "\">\n" + inside + "</emitter>");
}

TEST(Emitter, PointHasIntensityAndPosition)
{
    EXPECT_EQ(emitter_of("point").value, Rgb(1));
    EXPECT_EQ(emitter_of("point").position, Vec3(0));
    const Emitter point = emitter_of("point", R"(<rgb name="intensity" value="1 2 3"/><point name="position" x=".25" y=".5"/>)");
    EXPECT_EQ(point.value, Rgb(1, 2, 3));
    EXPECT_EQ(point.position, Vec3(.25, .5, 0));
    EXPECT_EQ(emitter_of("point", R"(<transform name="to_world"><translate x=".5"/></transform>)").position, Vec3(.5, 0, 0));
    EXPECT_EQ(emitter_of("point", R"(<point name="position" value="0.5, 0.25, 0"/>)").position, Vec3(.5, .25, 0));
    EXPECT_EQ(emitter_of("point", R"(<float name="intensity" value="5"/>)").value, Rgb(5));
    EXPECT_NE(emitter_fault("point", R"(<point name="position" x="1"/><transform name="to_world"/>)").find("exclude each other"),
              std::string::npos);
}

TEST(Emitter, SpotShinesAlongItsLocalZ)
{
    const Emitter plain = emitter_of("spot");
    EXPECT_EQ(plain.value, Rgb(1));
    EXPECT_EQ(plain.direction, Vec3(0, 0, 1));
    EXPECT_DOUBLE_EQ(plain.cutoff, 20 * degree);
    EXPECT_DOUBLE_EQ(plain.beam, 15 * degree);
    const Emitter spot = emitter_of(
        "spot", R"(<float name="intensity" value="7"/><float name="cutoff_angle" value="30"/><float name="beam_width" value="10"/>
        <transform name="to_world"><lookat origin="0,0.5,0" target="0,-1,0" up="0,0,1"/></transform>)");
    EXPECT_EQ(spot.value, Rgb(7));
    EXPECT_EQ(spot.position, Vec3(0, .5, 0));
    EXPECT_EQ(spot.direction, Vec3(0, -1, 0));
    EXPECT_DOUBLE_EQ(spot.cutoff, 30 * degree);
    EXPECT_DOUBLE_EQ(spot.beam, 10 * degree);
    EXPECT_DOUBLE_EQ(emitter_of("spot", R"(<float name="cutoff_angle" value="40"/>)").beam, 30 * degree);  // three quarters
    EXPECT_EQ(emitter_fault("spot", R"(<float name="beam_width" value="25"/>)"),
              "scene.xml:3:1: emitter \"spot\": beam_width = 25 must not exceed cutoff_angle = 20");
    EXPECT_EQ(emitter_fault("spot", R"(<float name="cutoff_angle" value="0"/>)"),
              "scene.xml:3:1: emitter \"spot\": cutoff_angle = 0 must lie strictly between 0 and 180");
    EXPECT_EQ(emitter_fault("spot", R"(<texture name="texture" type="bitmap"/>)")
                  .find("scene.xml:3:1: emitter \"spot\": <texture type=\"bitmap\"> is not supported here"),
              0u);
}

TEST(Emitter, DirectionalTravelsAlongItsDirection)
{
    EXPECT_EQ(emitter_of("directional").direction, Vec3(0, 0, 1));
    EXPECT_EQ(emitter_of("directional").value, Rgb(1));
    EXPECT_EQ(emitter_of("directional", R"(<vector name="direction" x="0" y="-2" z="0"/><rgb name="irradiance" value="3"/>)").direction,
              Vec3(0, -1, 0));
    EXPECT_EQ(emitter_of("directional", R"(<vector name="direction" x="0" y="-2" z="0"/><rgb name="irradiance" value="3"/>)").value,
              Rgb(3));
    EXPECT_EQ(emitter_of("directional", R"(<transform name="to_world"><rotate x="1" angle="90"/></transform>)").direction, Vec3(0, -1, 0));
    EXPECT_NE(emitter_fault("directional", R"(<vector name="direction" x="0"/>)").find("direction has length zero"), std::string::npos);
    EXPECT_NE(emitter_fault("directional", R"(<vector name="direction" x="1"/><transform name="to_world"/>)").find("exclude each other"),
              std::string::npos);
}

TEST(Emitter, ConstantHasRadiance)
{
    EXPECT_EQ(emitter_of("constant").value, Rgb(1));
    EXPECT_EQ(emitter_of("constant", R"(<rgb name="radiance" value="1 2 4"/>)").value, Rgb(1, 2, 4));
}

TEST(Emitter, AreaStandsInItsShape)
{
    const Scene scene =
        load_body(R"(<shape type="rectangle" id="lamp"><emitter type="area"><rgb name="radiance" value="12"/></emitter></shape>)");
    ASSERT_EQ(scene.emitters.size(), 1u);
    EXPECT_EQ(scene.emitters[0].type, Emitter::Type::area);
    EXPECT_EQ(scene.emitters[0].shape, 0);
    EXPECT_EQ(scene.shapes[0].emitter, 0);
    EXPECT_EQ(scene.emitters[0].value, Rgb(12));
    EXPECT_EQ(scene.bsdfs[static_cast<std::size_t>(scene.shapes[0].bsdf)].reflectance, Rgb(0));
    EXPECT_NE(emitter_fault("area").find("stands inside the <shape> that glows"), std::string::npos);
    EXPECT_THROW(load_body(R"(<shape type="sphere"><bsdf type="null"/><emitter type="area"/></shape>)"), SceneError) << "nothing is there to glow";
    EXPECT_NE(fault_of_body("<shape type=\"cube\">\n<emitter type=\"point\"/></shape>")
                  .find("scene.xml:3:1: emitter \"point\": type \"point\" cannot stand inside"),
              std::string::npos);
}

TEST(Emitter, MediumComesFromTheRefOrTheShapesOutside)
{
    const std::string fog = R"(<medium type="homogeneous" id="fog"/><medium type="homogeneous" id="other"/>)";
    EXPECT_EQ(load_body(fog + R"(<emitter type="point"><ref id="other"/></emitter>)").emitters[0].medium, 1);
    EXPECT_EQ(load_body(fog + R"(<shape type="sphere"><emitter type="area"><ref id="other"/></emitter></shape>)").emitters[0].medium, 1);
    EXPECT_EQ(load_body(fog + R"(<shape type="sphere"><ref name="exterior" id="fog"/><emitter type="area"/></shape>)").emitters[0].medium,
              0);
    EXPECT_EQ(load_body(fog + R"(<shape type="sphere"><ref name="interior" id="fog"/><emitter type="area"/></shape>)").emitters[0].medium,
              vacuum);
    EXPECT_EQ(load_body("<emitter type=\"point\"><medium type=\"homogeneous\"/></emitter>").emitters[0].medium, 0);
}

TEST(Emitter, SpectraAreRefusedByName)
{
    for (const char* type : {"point", "spot", "directional", "constant"}) {
        const std::string name = type == std::string("constant")      ? "radiance"
                                 : type == std::string("directional") ? "irradiance"
                                                                      : "intensity";
        EXPECT_EQ(emitter_fault(type, "<spectrum name=\"" + name + "\" value=\"3\"/>"),
                  std::string("scene.xml:3:1: emitter \"") + type + "\": " + name +
                      " as <spectrum> is not supported: a flat spectrum of light is not white in RGB; write it as <rgb>");
    }
}

TEST(Emitter, WrongValuesAreSentences)
{
    EXPECT_EQ(emitter_fault("point", R"(<rgb name="intensity" value="1 -2 3"/>)"),
              "scene.xml:3:1: emitter \"point\": intensity = -2 must not be negative");
    EXPECT_EQ(emitter_fault("point", R"(<rgb name="intensty" value="1"/>)")
                  .find("scene.xml:3:1: emitter \"point\": unknown parameter \"intensty\" (did you mean \"intensity\"?)"),
              0u);
    EXPECT_EQ(emitter_fault("sunsky"),
              "scene.xml:2:1: emitter type \"sunsky\" is not supported; supported: point, spot, area, directional, constant, envmap");
    EXPECT_NE(emitter_fault("point", R"(<point name="position" x="1e200"/>)").find("too far out"), std::string::npos);
    EXPECT_EQ(emitter_fault("point", R"(<point name="position" x="abc"/>)"), "scene.xml:3:1: <point> x = \"abc\" is not a finite number");
}

}  // namespace tyndall::test
