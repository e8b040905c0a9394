// Media of type heterogeneous and their volumes, in scenes.
#include <limits>
#include <random>

#include "scene/render_space.hpp"
#include "scene/transforms.hpp"
#include "scene/volume_values.hpp"
#include "scene_text.hpp"
#include "tests/support/vol_file.hpp"

namespace tyndall::test {
namespace {

/// Scenes in a folder with files of voxels. The medium's tag is line 2, what stands inside starts line 3; a cube [-1, 1]^3 holds it.
class Heterogeneous : public testing::Test {
protected:
    TemporaryFolder folder;

    Heterogeneous()
    {
        file("two.vol", two_voxels(1, 3));
        file("half.vol", two_voxels(.25f, .5f));
        file("rgb.vol", {.size = {1, 2, 1}, .channels = 3, .values = {.5f, 1, 2, 3, 4, 5}, .box = {1, 2, 3, 5, 4, 4}});
    }
    void file(const std::string& name, const VolFile& vol) const { folder.write(name, vol_bytes(vol)); }

    static std::string grid(const std::string& role, const std::string& name, const std::string& rest = "")
    {
        return "<volume name=\"" + role + "\" type=\"gridvolume\"><string name=\"filename\" value=\"" + name + "\"/>" + rest + "</volume>";
    }
    static std::string constant(const std::string& role, const std::string& value)
    {
        return "<volume name=\"" + role + "\" type=\"constvolume\"><rgb name=\"value\" value=\"" + value + "\"/></volume>";
    }
    static std::string placed(const std::string& steps) { return "<transform name=\"to_world\">" + steps + "</transform>"; }
    static std::string text(const std::string& inside, const std::string& more = "")
    {
        const std::string away = placed(R"(<translate z="9"/>)");
        return "<scene version=\"3.0.0\"><sensor type=\"perspective\"><float name=\"fov\" value=\"45\"/>" + away + "</sensor>\n<medium type=\"heterogeneous\" id=\"smoke\">\n" + inside +
               "</medium>\n<emitter type=\"point\">" + away + "</emitter>" + more + "<shape type=\"cube\"><bsdf type=\"null\"/><ref name=\"interior\" id=\"smoke\"/></shape></scene>";
    }
    Scene load(const std::string& inside, const std::string& more = "") const { return load_scene(folder.write("scene.xml", text(inside, more))); }
    std::string fault(const std::string& inside) const
    {
        const std::string message = fault_of_file(folder.write("scene.xml", text(inside))), place = (folder.path() / "scene.xml").string() + ":";
        return message.starts_with(place) ? message.substr(place.size()) : message;
    }
    /// Of the scene, in its file's space.
    static Vec3 corner(const Scene& scene, int volume, const Vec3& corner)
    {
        return to_file_space(scene, transform_point(scene.volumes.at(static_cast<std::size_t>(volume)).to_world, corner));
    }
};

TEST_F(Heterogeneous, ExtinctionIsScaleTimesVoxels)
{
    const Scene scene = load(grid("sigma_t", "two.vol") + R"(<float name="scale" value="4"/><rgb name="albedo" value="0.25 0.5 1"/><phase type="hg"/>)");
    const Medium& medium = scene.media.at(0);
    EXPECT_EQ(medium.density, 0);
    EXPECT_EQ(medium.albedo_volume, none);
    EXPECT_FALSE(medium.homogeneous());
    EXPECT_EQ(medium.sigma_t, Rgb(4) * scene.unit);
    EXPECT_EQ(medium.albedo, Rgb(.25, .5, 1));
    EXPECT_EQ(medium.phase.g, .8);
    ASSERT_EQ(scene.volumes.size(), 1u);
    EXPECT_EQ(scene.volumes[0].name, "two.vol");
    EXPECT_EQ(scene.volumes[0].values, (std::vector<float>{1, 3}));
    EXPECT_EQ(scene.volumes[0].where.line, 3);
    EXPECT_EQ(largest_extinction(scene, medium), Rgb(12) * scene.unit);
    expect_near(corner(scene, 0, Vec3(0)), Vec3(0), 1e-15);
    expect_near(corner(scene, 0, Vec3(1)), Vec3(1), 1e-15);
}

TEST_F(Heterogeneous, DefaultsAreMitsubas)
{
    const Scene scene = load(grid("sigma_t", "two.vol"));
    EXPECT_EQ(scene.media.at(0).sigma_t, Rgb(1) * scene.unit);
    EXPECT_EQ(scene.media[0].albedo, Rgb(.75));
    EXPECT_EQ(scene.media[0].phase.type, PhaseFunction::Type::isotropic);
}

TEST_F(Heterogeneous, BoxFollowsToWorldAndTheFilesBoxOnRequest)
{
    const std::string stretch = placed(R"(<scale x="10"/><translate y="1"/>)"), use = R"(<boolean name="use_grid_bbox" value="true"/>)";
    const Scene unit = load(grid("sigma_t", "rgb.vol", stretch)), own = load(grid("sigma_t", "rgb.vol", stretch + use)), plain = load(grid("sigma_t", "rgb.vol", use));
    expect_near(corner(unit, 0, Vec3(0)), Vec3(0, 1, 0), 1e-14);
    expect_near(corner(unit, 0, Vec3(1)), Vec3(10, 2, 1), 1e-14);
    expect_near(corner(own, 0, Vec3(0)), Vec3(10, 3, 3), 1e-14);  // the file's box first, then to_world, as Mitsuba 3.9.1 does
    expect_near(corner(own, 0, Vec3(1)), Vec3(50, 5, 4), 1e-14);
    expect_near(corner(plain, 0, Vec3(0)), Vec3(1, 2, 3), 1e-14);
    expect_near(corner(plain, 0, Vec3(1)), Vec3(5, 4, 4), 1e-14);
}

TEST_F(Heterogeneous, AlbedoMayBeAGridOfItsOwn)
{
    const std::string box = placed(R"(<scale value="2"/><translate value="-1 -1 -1"/>)");
    const Scene scene = load(grid("sigma_t", "rgb.vol", box) + grid("albedo", "half.vol", box));
    const Medium& medium = scene.media.at(0);
    EXPECT_EQ(medium.density, 0);
    ASSERT_EQ(medium.albedo_volume, 1);
    EXPECT_EQ(medium.albedo, Rgb(.5));
    EXPECT_EQ(scene.volumes.at(0).channels, 3);
    EXPECT_EQ(scene.volumes[0].values, (std::vector<float>{.5f, 3, 1, 4, 2, 5}));
    EXPECT_EQ(scene.volumes.at(1).values, (std::vector<float>{.25f, .5f}));
    EXPECT_EQ(scene.volumes[1].size_x, 2);
}

/// The value at a point of file space by a plain trilinear look-up; beyond the box that of the nearest place on it.
double clamped_value(const Scene& scene, const Volume& volume, const Vec3& point)
{
    const Vec3 local = transform_point(glm::inverse(volume.to_world), (point - scene.centre) / scene.unit);
    const int size[3] = {volume.size_x, volume.size_y, volume.size_z};
    int low[3], high[3];
    double share[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double at = std::clamp(local[axis] * size[axis] - .5, 0., size[axis] - 1.);
        low[axis] = static_cast<int>(at), high[axis] = std::min(low[axis] + 1, size[axis] - 1), share[axis] = at - low[axis];
    }
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int x = corner & 1 ? high[0] : low[0], y = corner & 2 ? high[1] : low[1], z = corner & 4 ? high[2] : low[2];
        const double weight = (corner & 1 ? share[0] : 1 - share[0]) * (corner & 2 ? share[1] : 1 - share[1]) * (corner & 4 ? share[2] : 1 - share[2]);
        sum += weight * static_cast<double>(volume.values[static_cast<std::size_t>((z * size[1] + y) * size[0] + x)]);
    }
    return sum;
}

TEST_F(Heterogeneous, AlbedoGoesOnBeyondItsOwnBoxAsInMitsuba)
{
    VolFile small{.size = {3, 2, 2}};
    for (int i = 0; i < 12; ++i) small.values.push_back(static_cast<float>(i) / 16);
    file("small.vol", small);
    const std::string box = placed(R"(<scale value="2"/><translate value="-1 -1 -1"/>)"), inside = placed(R"(<scale value="0.3"/><rotate z="1" angle="20"/><translate x="-.1" y=".3"/>)");
    const Scene over = load(grid("sigma_t", "two.vol", box) + grid("albedo", "small.vol", inside));
    const Volume& volume = over.volumes.at(1);
    const Bounds grid_box = bounds_of(over.volumes[0]);
    EXPECT_GT(volume.size_x, 3 + 6);
    // its box holds that of the density
    const Mat4 to_albedo = glm::inverse(volume.to_world) * over.volumes[0].to_world;
    for (int i = 0; i < 8; ++i) {
        const Vec3 local = transform_point(to_albedo, Vec3(i & 1, i >> 1 & 1, i >> 2 & 1));
        for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(local[axis] > -1e-8 && local[axis] < 1 + 1e-8) << local[axis];
    }
    // and has the values of the small one, clamped
    Volume original = volume;
    original.size_x = 3, original.size_y = original.size_z = 2, original.values = small.values;
    original.to_world = Mat4(glm::dmat3(1 / over.unit)) * (translation({-.1, .3, 0}) * rotation({0, 0, 1}, 20) * scaling(Vec3(.3)));
    original.to_world[3] = glm::dvec4((Vec3(-.1, .3, 0) - over.centre) / over.unit, 1);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p = to_file_space(over, glm::mix(grid_box.low, grid_box.high, Vec3(uniform(random), uniform(random), uniform(random))));
        EXPECT_NEAR(clamped_value(over, volume, p), clamped_value(over, original, p), 1e-12);
    }
}

TEST_F(Heterogeneous, AlbedoInTheSameBoxIsLeftAlone)
{
    const std::string box = placed(R"(<rotate x="1" y="2" z="3" angle="40"/><scale value="0.3"/><translate x="123" y="-77"/>)");
    EXPECT_EQ(load(grid("sigma_t", "two.vol", box) + grid("albedo", "half.vol", box)).volumes.at(1).values.size(), 2u);
}

TEST_F(Heterogeneous, WhatDoesNotVaryIsConstant)
{
    file("grey.vol", {.size = {1, 1, 2}, .values = {.5f, .5f}});
    EXPECT_EQ(load(grid("sigma_t", "two.vol") + constant("albedo", "0.1 0.2 0.3")).media.at(0).albedo, Rgb(.1, .2, .3));
    const Scene grey = load(grid("sigma_t", "two.vol") + grid("albedo", "grey.vol"));
    EXPECT_EQ(grey.media.at(0).albedo, Rgb(.5));
    EXPECT_EQ(grey.media[0].albedo_volume, none);
    EXPECT_EQ(grey.volumes.size(), 1u);
    const Scene flat = load(constant("sigma_t", "1 2 3") + grid("albedo", "grey.vol") + R"(<float name="scale" value="2"/>)");
    EXPECT_TRUE(flat.media.at(0).homogeneous());
    EXPECT_EQ(flat.media[0].sigma_t, Rgb(2, 4, 6) * flat.unit);
    ASSERT_EQ(flat.warnings.size(), 1u);
    EXPECT_NE(flat.warnings[0].find("medium \"smoke\": nothing about it varies, so it fills its shape"), std::string::npos) << flat.warnings[0];
}

TEST_F(Heterogeneous, EmptyGridsAreEmptyMedia)
{
    file("nothing.vol", two_voxels(0, 0));
    for (const std::string& inside : {grid("sigma_t", "nothing.vol"), grid("sigma_t", "nothing.vol") + grid("albedo", "half.vol"), grid("sigma_t", "two.vol") + R"(<float name="scale" value="0"/>)"}) {
        const Scene scene = load(inside);
        EXPECT_TRUE(scene.media.at(0).homogeneous());
        EXPECT_EQ(scene.media[0].sigma_t, Rgb(0));
        EXPECT_TRUE(scene.volumes.empty());
        ASSERT_EQ(scene.warnings.size(), 1u);
        EXPECT_NE(scene.warnings[0].find("; the medium is empty"), std::string::npos) << scene.warnings[0];
        EXPECT_NE(scene.warnings[0].find(":3:1: "), std::string::npos) << scene.warnings[0];
    }
}

TEST_F(Heterogeneous, AFileIsReadOnceAndAVolumeIsThereOnce)
{
    const std::string box = placed(R"(<scale value="2"/>)");
    const std::string shared = R"(<volume id="grid" type="gridvolume"><string name="filename" value="half.vol"/></volume><medium type="heterogeneous" id="other"><ref name="sigma_t" id="grid"/></medium>
        <shape type="cube"><transform name="to_world"><translate x="4"/></transform><bsdf type="null"/><ref name="interior" id="other"/></shape>)";
    const Scene scene = load(R"(<ref name="sigma_t" id="grid"/>)" + grid("albedo", "half.vol", box), shared);
    EXPECT_EQ(scene.media.at(0).density, scene.media.at(1).density);
    EXPECT_NE(scene.media[0].density, scene.media[0].albedo_volume);
    EXPECT_EQ(scene.volumes.size(), 2u);
}

TEST_F(Heterogeneous, TheHashFollowsEveryByteOfTheFile)
{
    const std::uint64_t before = load(grid("sigma_t", "two.vol")).hash;
    EXPECT_EQ(load(grid("sigma_t", "two.vol")).hash, before);
    file("two.vol", two_voxels(1, 3.0000002f));
    EXPECT_NE(load(grid("sigma_t", "two.vol")).hash, before);
}

TEST_F(Heterogeneous, RenderSpaceMovesTheBoxAndKeepsTheOpticalDepth)
{
    // the same scene a thousand times as large, elsewhere: extinction times length and the box within the bounds stay
    const auto scene_at = [&](const std::string& size, const std::string& extinction, const std::string& place) {
        const std::string steps = "<scale value=\"" + size + "\"/><translate x=\"" + place + "\"/>";
        return load_scene(folder.write("scene.xml", "<scene version=\"3.0.0\"><sensor type=\"perspective\"><float name=\"fov\" value=\"9\"/>" +
                                                        placed("<translate x=\"" + place + "\"/>") + "</sensor><medium type=\"heterogeneous\" id=\"m\">" +
                                                        grid("sigma_t", "two.vol", placed(steps)) + "<float name=\"scale\" value=\"" + extinction +
                                                        "\"/></medium><shape type=\"cube\">" + placed(steps) + "<ref name=\"interior\" id=\"m\"/></shape></scene>"));
    };
    const Scene one = scene_at("1", "1", "0"), large = scene_at("1024", "0.0009765625", "4096");
    EXPECT_EQ(large.unit, 1024 * one.unit);
    EXPECT_EQ(large.media.at(0).sigma_t, one.media.at(0).sigma_t);
    EXPECT_EQ(large.volumes.at(0).to_world, one.volumes.at(0).to_world);
}

TEST_F(Heterogeneous, WrongParametersAreSentences)
{
    const std::string title = "medium \"smoke\": ", g = "volume \"gridvolume\": ";
    EXPECT_EQ(fault("<volume name=\"sigma_t\" type=\"gridvolume\"/>"), "3:1: " + g + "needs <string name=\"filename\" value=\"...\"/>");
    EXPECT_EQ(fault("<volume name=\"sigma_t\" type=\"gird\"/>"), "3:1: volume type \"gird\" is not supported; supported: gridvolume, openvdbvolume, constvolume");
    EXPECT_EQ(fault(grid("sigma_t", "gone.vol")), "3:42: cannot find \"gone.vol\" in \"" + folder.path().string() + "\"");
    EXPECT_EQ(fault(grid("sigma_t", "two.vol", R"(<string name="filter_type" value="nearest"/>)")),
              "3:83: " + g + "filter_type = \"nearest\" is not supported; supported: trilinear");
    EXPECT_EQ(fault(grid("sigma_t", "two.vol", R"(<string name="wrap_mode" value="repeat"/>)")), "3:83: " + g + "wrap_mode = \"repeat\" is not supported; supported: clamp");
    EXPECT_EQ(fault(grid("sigma_t", "two.vol", R"(<boolean name="use_grid_box" value="true"/>)"))
                  .find("3:83: " + g + "unknown parameter \"use_grid_box\" (did you mean \"use_grid_bbox\"?)"),
              0u);
    EXPECT_EQ(fault(grid("sigma_t", "two.vol", placed(R"(<scale z="0"/>)"))), "3:83: <transform> flattens space (a scale of 0?); it must have an inverse");
    EXPECT_EQ(fault(grid("sigma", "two.vol")), "3:1: " + title + "the volume needs name=\"sigma_t\" or name=\"albedo\" (did you mean \"sigma_t\"?)");
    EXPECT_EQ(fault(grid("sigma_t", "two.vol") + R"(<float name="sigma_t" value="1"/>)").find("3:92: " + title + "sigma_t is given twice"), 0u);
    EXPECT_EQ(fault(grid("sigma_t", "two.vol") + grid("sigma_t", "two.vol")), "3:92: " + title + "a second volume sigma_t");
    EXPECT_EQ(fault(grid("sigma_t", "two.vol") + R"(<float name="scale" value="-1"/>)"), "3:92: " + title + "scale = -1 must not be negative");
    EXPECT_EQ(fault(constant("sigma_t", "-1")), "3:43: volume \"constvolume\": value = -1 must not be negative");
    EXPECT_EQ(fault(R"(<float name="sigma_t" value="-1"/>)"), "3:1: " + title + "sigma_t = -1 must not be negative");
    EXPECT_EQ(fault_of_body("<volume type=\"constvolume\"/>").find("scene.xml:2:1: <volume> at the top of the scene needs an id"), 0u);
}

TEST_F(Heterogeneous, FilesAndValuesThatDoNotFitAreRefusedAtTheirPlace)
{
    file("short.vol", {.size = {3, 1, 1}, .values = {1, 2}});
    file("hole.vol", two_voxels(1, std::numeric_limits<float>::quiet_NaN()));
    file("flat.vol", {.values = {1}, .box = {0, 0, 0, 1, 0, 1}});
    file("nan_box.vol", {.values = {1}, .box = {0, 0, 0, 1, std::numeric_limits<float>::quiet_NaN(), 1}});
    file("huge.vol", two_voxels(1, 3e38f));
    EXPECT_EQ(fault(grid("sigma_t", "short.vol")).find("3:42: volume \"gridvolume\": short.vol: says that it holds 3 x 1 x 1 voxels of 1 channels, but 8 bytes follow its header"), 0u);
    EXPECT_EQ(fault(grid("sigma_t", "hole.vol")), "3:42: volume \"gridvolume\": hole.vol: voxel (1, 0, 0) is nan; every value must be finite and not negative");
    for (const std::string& name : std::vector<std::string>{"flat.vol", "nan_box.vol"})
        EXPECT_NE(fault(grid("sigma_t", name, R"(<boolean name="use_grid_bbox" value="true"/>)")).find("which is no box; leave use_grid_bbox out"), std::string::npos) << name;
    EXPECT_EQ(fault(grid("sigma_t", "flat.vol")), "");
    EXPECT_EQ(fault(grid("sigma_t", "two.vol") + "\n" + grid("albedo", "two.vol")), "4:1: medium \"smoke\": a voxel of two.vol is 3; albedo must lie between 0 and 1");
    EXPECT_EQ(fault(grid("sigma_t", "two.vol") + "\n" + R"(<float name="albedo" value="1.5"/>)"), "4:1: medium \"smoke\": albedo = 1.5 must lie between 0 and 1");
    EXPECT_EQ(fault(grid("albedo", "half.vol")).find("3:1: medium \"smoke\": albedo varies but sigma_t does not, so nothing says where the medium ends; give sigma_t as a gridvolume"), 0u);
    EXPECT_EQ(fault(grid("sigma_t", "huge.vol")).find("2:1: medium \"smoke\": sigma_t is too large"), 0u);
    EXPECT_NE(fault(grid("sigma_t", "two.vol") + grid("albedo", "half.vol", placed(R"(<scale value="1e-5"/>)"))).find("covers so little of that of sigma_t"), std::string::npos);
    EXPECT_NE(fault(grid("sigma_t", "../two.vol")).find("leads outside the scene's folder"), std::string::npos);
}

TEST_F(Heterogeneous, DamagedFilesNeverCrashTheLoader)
{
    std::mt19937 random(5);
    const std::string good = vol_bytes(ball_of_smoke(3));
    int refused = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        std::string bytes = good;
        for (int flips = 1 + static_cast<int>(random() % 3); flips > 0; --flips) {
            const std::size_t at = random() % bytes.size();
            bytes[at] = static_cast<char>(bytes[at] ^ 1 << random() % 8);
        }
        folder.write("bad.vol", bytes);
        const std::string message = fault(grid("sigma_t", "bad.vol", R"(<boolean name="use_grid_bbox" value="true"/>)"));
        refused += !message.empty();
        EXPECT_TRUE(message.empty() || message.starts_with("3:") || message.starts_with("2:1: ") || message.starts_with("1:")) << message;
    }
    EXPECT_GT(refused, 100);
    EXPECT_LT(refused, 900);
}

}  // namespace
}  // namespace tyndall::test
