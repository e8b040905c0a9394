// Emitters of type envmap in scenes.
#include <gmock/gmock.h>

#include <limits>

#include "scene/describe.hpp"
#include "scene_text.hpp"
#include "tests/support/picture_file.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;

/// The emitter's tag is line 2, what stands inside starts line 3.
class Environments : public testing::Test {
protected:
    TemporaryFolder folder;

    void exr(const std::string& name, int width, int height, const std::vector<std::string>& channels, const std::vector<float>& values) const
    {
        folder.write(name, exr_bytes(width, height, channels, values, folder.path() / "scratch.exr"));
    }
    std::filesystem::path scene(const std::string& file, const std::string& rest = "") const
    {
        return folder.write("scene.xml", "<scene version=\"3.0.0\">" + plain_sensor + "\n<emitter type=\"envmap\">\n<string name=\"filename\" value=\"" + file + "\"/>" + rest + "</emitter>" + unit_sphere + "</scene>");
    }
    std::string fault(const std::string& file, const std::string& rest = "") const
    {
        const std::string message = fault_of_file(scene(file, rest)), place = folder.path().string() + "/";
        return message.starts_with(place) ? message.substr(place.size()) : message;
    }
};

TEST_F(Environments, AreReadWithScaleAndTurning)
{
    exr("sky.exr", 4, 2, {"Y"}, {1, 1, 1, 1, 3, 3, 3, 3});
    const Scene sky = load_scene(scene("sky.exr", R"(<float name="scale" value="2"/><transform name="to_world"><scale value="5"/><rotate x="1" angle="90"/></transform>)"));
    const Emitter& emitter = sky.emitters.at(0);
    ASSERT_EQ(emitter.map, 0);
    EXPECT_EQ(emitter.value, Rgb(2));
    expect_near(emitter.map_to_world * Vec3(0, 1, 0), {0, 0, 1}, 1e-15);
    EXPECT_EQ(sky.environment_maps[0].texels.size(), 24u) << "grey becomes three channels";
    expect_near(sky.environment_maps[0].mean, Rgb(2), 1e-12);
    EXPECT_THAT(describe(sky), HasSubstr("envmap 2 x \"sky.exr\" of 4 x 2 pixels, mean radiance 4"));
}

TEST_F(Environments, WhatCannotLightIsRefusedWithItsPlace)
{
    exr("sky.exr", 4, 2, {"Y"}, {1, 1, 1, 1, 3, 3, 3, 3});
    exr("thin.exr", 4, 1, {"Y"}, {1, 1, 1, 1});
    exr("dark.exr", 2, 2, {"R", "G", "B"}, {1, 1, 1, 1, -1, 1, 1, 1, 1, 1, 1, 1});
    exr("nan.exr", 2, 2, {"Y"}, {1, 1, std::numeric_limits<float>::infinity(), 1});
    folder.write("foreign.exr", "nothing");
    EXPECT_EQ(fault("thin.exr"), "scene.xml:3:1: emitter \"envmap\": thin.exr: has 4 x 1 pixels; an envmap has at least 2 x 2, and at most 33554432");
    EXPECT_EQ(fault("dark.exr"), "scene.xml:3:1: emitter \"envmap\": dark.exr: pixel (1, 0) is -1; radiance must not be negative");
    EXPECT_EQ(fault("nan.exr"), "scene.xml:3:1: emitter \"envmap\": nan.exr: pixel (0, 1) is inf; every value must be a finite number");
    EXPECT_EQ(fault("foreign.exr"), "scene.xml:3:1: emitter \"envmap\": foreign.exr: is neither a PNG nor an OpenEXR file");
    EXPECT_THAT(fault("none.exr"), testing::StartsWith("scene.xml:3:1: cannot find \"none.exr\""));
    EXPECT_THAT(fault("sky.exr", R"(<float name="scale" value="-1"/>)"), HasSubstr("scale = -1 must not be negative"));
    EXPECT_THAT(fault("sky.exr", R"(<transform name="to_world"><matrix value="1 1 0 0 1 0 0 0 1"/></transform>)"), HasSubstr("to_world shears"));
    EXPECT_THAT(fault("sky.exr", R"(<rgb name="radiance" value="1"/>)"), HasSubstr("unknown parameter \"radiance\""));
}

TEST_F(Environments, TheHashCoversTheFile)
{
    exr("sky.exr", 2, 2, {"Y"}, {1, 1, 1, 1});
    const auto before = load_scene(scene("sky.exr")).hash;
    exr("sky.exr", 2, 2, {"Y"}, {1, 1, 1, 2});
    EXPECT_NE(load_scene(scene("sky.exr")).hash, before);
}

}  // namespace
}  // namespace tyndall::test
