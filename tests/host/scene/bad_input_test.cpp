// One wrong character at a time in a scene that is right: the message starts with the place, and nothing crashes.
#include <algorithm>
#include <array>
#include <random>

#include "scene/mesh_files.hpp"
#include "scene_text.hpp"

namespace tyndall::test {

const std::string good = R"(<scene version="3.0.0">
  <default name="g" value="0.5"/>
  <integrator type="volpath"><integer name="max_depth" value="5"/></integrator>
  <medium type="homogeneous" id="juice">
    <rgb name="sigma_t" value="0.1, 0.2, 0.3"/>
    <float name="albedo" value="0.9"/>
    <phase type="hg"><float name="g" value="$g"/></phase>
  </medium>
  <sensor type="perspective">
    <float name="fov" value="40"/>
    <transform name="to_world"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="8"/><rfilter type="box"/></film>
  </sensor>
  <shape type="sphere"><ref name="interior" id="juice"/><bsdf type="null"/></shape>
  <emitter type="point"><rgb name="intensity" value="3"/><point name="position" x="0" y="3" z="0"/></emitter>
</scene>
)";

/// `good` with one text replaced.
std::string with(const std::string& from, const std::string& to)
{
    std::string xml = good;
    const auto at = xml.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return xml.replace(at, from.size(), to);
}

TEST(BadInput, TheSceneItselfIsRight)
{
    const Scene scene = parse(good);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
}

TEST(BadInput, EveryMistakeHasItsPlaceAndSentence)
{
    const std::array<std::array<std::string, 3>, 17> mistakes{{
        {"value=\"$g\"", "value=\"1.2\"", "scene.xml:7:22: medium \"juice\": g = 1.2 must lie strictly between -1 and 1"},
        {"0.1, 0.2, 0.3", "0.1, -0.2, 0.3", "scene.xml:5:5: medium \"juice\": sigma_t = -0.2 must not be negative"},
        {"0.1, 0.2, 0.3", "0.1, NaN, 0.3", "scene.xml:5:5: medium \"juice\": sigma_t = \"NaN\" is not a finite number"},
        {"value=\"0.9\"", "value=\"1.5\"", "scene.xml:6:5: medium \"juice\": albedo = 1.5 must lie between 0 and 1"},
        {"name=\"albedo\"", "name=\"albeedo\"",
         "scene.xml:6:5: medium \"juice\": unknown parameter \"albeedo\" (did you mean \"albedo\"?)"},
        {"<float name=\"albedo\"", "<flaot name=\"albedo\"",
         "scene.xml:6:5: medium \"juice\": unknown element <flaot> (did you mean \"float\"?)"},
        {"name=\"width\" value=\"8\"", "name=\"width\" value=\"0\"", "scene.xml:12:26: film \"hdrfilm\": width = 0 must be at least 1"},
        {"name=\"fov\" value=\"40\"", "name=\"fov\" value=\"200\"",
         "scene.xml:10:5: sensor \"perspective\": fov = 200 must lie strictly between 0 and 180"},
        {"name=\"fov\" value=\"40\"", "name=\"fov\" value=\"forty\"",
         "scene.xml:10:5: sensor \"perspective\": fov = \"forty\" is not a finite number"},
        {"id=\"juice\"/>", "id=\"jiuce\"/>", "scene.xml:14:24: nothing has the id \"jiuce\" (did you mean \"juice\"?)"},
        {"type=\"homogeneous\"", "type=\"homogenous\"",
         "scene.xml:4:3: medium type \"homogenous\" is not supported (did you mean \"homogeneous\"?)"},
        {"type=\"sphere\"", "type=\"sphare\"", "scene.xml:14:3: shape type \"sphare\" is not supported (did you mean \"sphere\"?)"},
        {"type=\"null\"", "type=\"principled\"", "scene.xml:14:57: bsdf type \"principled\" is not supported; supported: "},
        {"<lookat", "<lookta", "scene.xml:11:32: <lookta> is no step of a <transform> (did you mean \"lookat\"?)"},
        {"value=\"5\"/></integrator>", "value=\"5.5\"/></integrator>",
         "scene.xml:3:30: integrator \"volpath\": max_depth = \"5.5\" is not an integer"},
        {"name=\"position\" x=\"0\"", "name=\"position\" w=\"0\"", "scene.xml:15:58: <point> has no attribute \"w\""},
        {"</scene>", "<cube/></scene>", "scene.xml:16:1: scene: unknown element <cube>"},
    }};
    for (const auto& [from, to, message] : mistakes) EXPECT_EQ(fault(with(from, to)).substr(0, message.size()), message);
}

TEST(BadInput, RandomDamageIsRefusedOrRead)
{
    // 3000 scenes with a few bytes replaced, dropped or doubled: a Scene or a SceneError, nothing else. Each error names a place in the
    // scene or the definition.
    std::mt19937 random(7);
    int refused = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        std::string xml = good;
        for (int edits = 1 + static_cast<int>(random() % 3); edits > 0; --edits) {
            const std::size_t at = random() % xml.size();
            switch (random() % 4) {
                case 0:
                    xml[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    xml.erase(at, 1 + random() % 5);
                    break;
                case 2:
                    xml.insert(at, xml.substr(random() % xml.size(), random() % 30));
                    break;
                case 3:
                    xml[at] = "<>\"'/&$-.e0 9"[random() % 13];
                    break;
            }
        }
        const std::string message = fault(xml);
        refused += !message.empty();
        if (!message.empty()) {
            EXPECT_EQ(message.find("scene.xml:"), 0u) << message << "\n" << xml;
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 3000);
}

TEST(BadInput, RandomMeshesAreRefusedOrRead)
{
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1/1\n";
    std::mt19937 random(11);
    int refused = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const bool is_ply = trial % 2 == 0;
        std::string bytes = is_ply ? ply : obj;
        for (int edits = 1 + static_cast<int>(random() % 3); edits > 0; --edits) {
            const std::size_t at = random() % bytes.size();
            if (random() % 2)
                bytes[at] = "0123456789-.e/ \nnaif"[random() % 20];
            else
                bytes.erase(at, 1 + random() % 4);
        }
        try {
            const Mesh mesh = (is_ply ? read_ply(bytes) : read_obj(bytes)).mesh;
            for (const auto& t : mesh.triangles) ASSERT_LT(std::max({t.x, t.y, t.z}), mesh.vertices.size()) << bytes;
        } catch (const MeshFault&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 20000);
}

}  // namespace tyndall::test
