// Grids out of .vdb files that OpenVDB writes here.
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "scene/render_space.hpp"
#include "scene/transforms.hpp"
#include "scene/volume_files.hpp"
#include "scene_text.hpp"

namespace tyndall::test {
namespace {

using openvdb::Coord;
using openvdb::FloatGrid;

FloatGrid::Ptr float_grid(const std::string& name = "density")
{
    openvdb::initialize();
    FloatGrid::Ptr grid = FloatGrid::create(0);
    grid->setName(name);
    return grid;
}

/// Three active voxels in a box of 4 x 2 x 3 whose lowest corner is (-2, 5, 7).
FloatGrid::Ptr smoke(const std::string& name = "density")
{
    const FloatGrid::Ptr grid = float_grid(name);
    grid->tree().setValue(Coord(-2, 5, 9), .25f);
    grid->tree().setValue(Coord(1, 6, 8), 2);
    grid->tree().setValue(Coord(0, 5, 7), 1);
    return grid;
}

std::string vdb_bytes(const openvdb::GridPtrVec& grids)
{
    std::ostringstream stream(std::ios::binary);
    openvdb::io::Stream(stream).write(grids);
    return stream.str();
}

std::string vdb_fault(const std::string& bytes, const std::string& name = "density")
{
    try {
        read_vdb(bytes, name);
    } catch (const VolumeFault& fault) {
        return fault.what();
    }
    return "";
}

TEST(OpenVdb, ActiveVoxelsBecomeABoxWithXRunningFastest)
{
    const VolumeFile file = read_vdb(vdb_bytes({smoke()}), "density");
    EXPECT_EQ(file.size_x, 4);
    EXPECT_EQ(file.size_y, 2);
    EXPECT_EQ(file.size_z, 3);
    EXPECT_EQ(file.channels, 1);
    std::vector<float> expected(24, 0.f);
    expected[(2 * 2 + 0) * 4 + 0] = .25f, expected[(1 * 2 + 1) * 4 + 3] = 2, expected[(0 * 2 + 0) * 4 + 2] = 1;
    EXPECT_EQ(file.values, expected);
}

TEST(OpenVdb, FilesWithOffsetsAndCompressionAreReadToo)
{
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "smoke.vdb").string();
    openvdb::io::File file(path);
    file.setCompression(openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK);
    file.write({smoke("fuel"), smoke()});
    file.close();
    std::stringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    EXPECT_EQ(read_vdb(bytes.str(), "density").values, read_vdb(vdb_bytes({smoke()}), "density").values);
}

TEST(OpenVdb, VoxelsHaveTheirCentresAtWholeNumbersOfTheGridsTransform)
{
    const FloatGrid::Ptr grid = smoke();
    openvdb::math::Transform::Ptr transform = openvdb::math::Transform::createLinearTransform(.5);
    transform->postRotate(.7, openvdb::math::Z_AXIS);
    transform->postScale({1, 2, 3});
    transform->postTranslate({10, 20, 30});
    grid->setTransform(transform);
    const VolumeFile file = read_vdb(vdb_bytes({grid}), "density");
    const openvdb::Vec3d low(-2.5, 4.5, 6.5), size(4, 2, 3);
    for (const openvdb::Vec3d& local : {openvdb::Vec3d(0, 0, 0), openvdb::Vec3d(1, 0, 0), openvdb::Vec3d(0, 1, 0), openvdb::Vec3d(.3, .6, .9)}) {
        const openvdb::Vec3d world = transform->indexToWorld(low + local * size);
        expect_near(transform_point(file.placement, Vec3(local.x(), local.y(), local.z())), Vec3(world.x(), world.y(), world.z()), 1e-12);
    }
}

TEST(OpenVdb, TilesAndBackgroundAreVoxelsToo)
{
    const FloatGrid::Ptr grid = FloatGrid::create(.5f);
    grid->setName("density");
    grid->fill({Coord(0, 0, 0), Coord(7, 7, 7)}, 3);  // a tile, where nothing else is
    grid->tree().setValue(Coord(8, 0, 0), 1);
    const VolumeFile file = read_vdb(vdb_bytes({grid}), "density");
    ASSERT_EQ(file.values.size(), 9u * 8 * 8);
    EXPECT_EQ(file.values[0], 3);
    EXPECT_EQ(file.values[8], 1);
    EXPECT_EQ(file.values[9 + 8], .5f);
}

TEST(OpenVdb, WhatIsNoGridOfSmokeIsASentence)
{
    const std::string bytes = vdb_bytes({smoke("fuel"), openvdb::Vec3SGrid::create()});
    EXPECT_EQ(vdb_fault(bytes).find("has no grid named \"density\"; it holds \"fuel\" (float), \"\" (vec3s)"), 0u) << vdb_fault(bytes);
    EXPECT_EQ(vdb_fault(bytes, "fuel"), "");
    EXPECT_EQ(vdb_fault(bytes, ""), "the grid \"\" holds values of the type \"vec3s\"; only grids of the type float are read");
    EXPECT_EQ(vdb_fault(vdb_bytes({})), "has no grid named \"density\"; it is empty");
    EXPECT_EQ(vdb_fault(vdb_bytes({float_grid()})), "the grid \"density\" has no active voxel");
    const FloatGrid::Ptr level_set = smoke(), frustum = smoke();
    level_set->setGridClass(openvdb::GRID_LEVEL_SET);
    EXPECT_EQ(vdb_fault(vdb_bytes({level_set})), "the grid \"density\" is a level set, a distance to a surface; export it as a fog volume");
    frustum->setTransform(openvdb::math::Transform::createFrustumTransform(openvdb::BBoxd({0, 0, 0}, {9, 9, 9}), .5, 10, 1));
    EXPECT_EQ(vdb_fault(vdb_bytes({frustum})), "the grid \"density\" lies in a frustum; resample it into a box");
}

TEST(OpenVdb, ValuesAndSizesAreChecked)
{
    const auto with = [](const Coord& at, float value) {
        const FloatGrid::Ptr grid = smoke();
        grid->tree().setValue(at, value);
        return vdb_fault(vdb_bytes({grid}));
    };
    EXPECT_EQ(with(Coord(-2, 6, 7), -1), "voxel (0, 1, 0) is -1; every value must be finite and not negative");
    EXPECT_EQ(with(Coord(-2, 6, 7), std::numeric_limits<float>::infinity()), "voxel (0, 1, 0) is inf; every value must be finite and not negative");
    EXPECT_NE(with(Coord(-2, 6, 7), std::numeric_limits<float>::quiet_NaN()).find("voxel (0, 1, 0) is nan"), std::string::npos);
    const int most = std::numeric_limits<int>::max() - 8;
    for (const Coord& far_away : {Coord(2000, 2000, 2000), Coord(most, most, most), Coord(-most, most, -most)})
        EXPECT_NE(with(far_away, 1).find("voxels as a box, of which 5.36871e+08 are possible; crop it"), std::string::npos) << with(far_away, 1);
    const FloatGrid::Ptr both = smoke();  // further apart than an int
    both->tree().setValue(Coord(most, 0, 0), 1), both->tree().setValue(Coord(-most, 0, 0), 1);
    EXPECT_NE(vdb_fault(vdb_bytes({both})).find("voxels as a box"), std::string::npos);
}

TEST(OpenVdb, EveryTruncationIsRefused)
{
    const std::string whole = vdb_bytes({smoke()});
    EXPECT_EQ(vdb_fault(whole), "");
    const std::size_t ends_of_header = 1200;  // from there on it is voxels, all of which are read the same way
    for (std::size_t size = 0; size < whole.size(); size += size < ends_of_header ? 1 : 97) EXPECT_NE(vdb_fault(whole.substr(0, size)), "") << size << " of " << whole.size();
    EXPECT_NE(vdb_fault(whole.substr(0, whole.size() - 1)), "");
    EXPECT_NE(vdb_fault("VOL\x03 is another format"), "");
}

TEST(OpenVdb, RandomDamageIsRefusedOrRead)
{
    const std::string good = vdb_bytes({smoke()});
    std::mt19937 random(13);
    int refused = 0;
    for (int trial = 0; trial < 100; ++trial) {
        std::string bytes = good;
        const std::size_t at = random() % (trial % 2 ? 1100 : good.size());
        bytes[at] = static_cast<char>(bytes[at] ^ 1 << random() % 8);
        refused += !vdb_fault(bytes).empty();
    }
    EXPECT_GT(refused, 10);
    EXPECT_LT(refused, 90);
}

// Found by tests/fuzz: OpenVDB would take the memory first, up to 4 GiB for a file of 100 bytes.
TEST(OpenVdb, LengthsInTheHeaderAreCheckedAgainstTheFile)
{
    const std::string good = vdb_bytes({smoke()});
    const auto lying = [&](const std::string& before, const std::string& length) {
        std::string bytes = good;
        const auto at = bytes.find(before);
        EXPECT_NE(at, std::string::npos) << before;
        return vdb_fault(bytes.replace(at + before.size(), length.size(), length));
    };
    const std::string gibibytes = "\xff\xff\xff\x7f", uuid_ends = good.substr(21 + 30, 6);
    for (const std::string& before : {std::string("density"), std::string("file_bbox_max"), std::string("Tree_float_5_4_3"), uuid_ends})
        EXPECT_NE(lying(before, gibibytes).find("it is damaged"), std::string::npos) << before << ": " << lying(before, gibibytes);
    for (const auto& [format, name] : {std::pair(std::string("\xdd\0\0\0", 4), "221"), {std::string("\0\1\0\0", 4), "256"}})
        EXPECT_EQ(lying(std::string(" BDV\0\0\0\0", 8), format).substr(0, 48), std::string("is of OpenVDB's format ") + name + "; formats from 222 (20");
}

/// A scene in a folder with smoke.vdb; the volume's tag stands in line 3.
std::string scene_with(const std::string& inside)
{
    return "<scene version=\"3.0.0\">" + plain_sensor + "\n<medium type=\"heterogeneous\" id=\"m\">\n<volume name=\"sigma_t\" type=\"openvdbvolume\">" + inside +
           "</volume></medium>\n<shape type=\"cube\"><transform name=\"to_world\"><scale value=\"20\"/></transform><ref name=\"interior\" id=\"m\"/></shape></scene>";
}
const std::string smoke_file = R"(<string name="filename" value="smoke.vdb"/>)";

TEST(OpenVdb, ScenesNameFileAndGrid)
{
    const TemporaryFolder folder;
    const FloatGrid::Ptr grid = smoke();
    grid->setTransform(openvdb::math::Transform::createLinearTransform(2));
    folder.write("smoke.vdb", vdb_bytes({grid, smoke("fuel")}));
    const Scene scene = load_scene(folder.write("scene.xml", scene_with(smoke_file + R"(<transform name="to_world"><translate x="1"/></transform>)")));
    EXPECT_EQ(scene.media.at(0).density, 0);
    EXPECT_EQ(scene.volumes.at(0).name, "smoke.vdb");
    expect_near(to_file_space(scene, transform_point(scene.volumes[0].to_world, Vec3(0))), Vec3(-4, 9, 13), 1e-12);  // 2 x (-2.5, 4.5, 6.5), then x + 1
    expect_near(to_file_space(scene, transform_point(scene.volumes[0].to_world, Vec3(1))), Vec3(4, 13, 19), 1e-12);
    const Scene fuel = load_scene(folder.write("scene.xml", scene_with(smoke_file + R"(<string name="grid" value="fuel"/>)")));
    expect_near(to_file_space(fuel, transform_point(fuel.volumes.at(0).to_world, Vec3(0))), Vec3(-2.5, 4.5, 6.5), 1e-12);
}

TEST(OpenVdb, FaultsInScenesHaveTheirPlace)
{
    const TemporaryFolder folder;
    folder.write("smoke.vdb", vdb_bytes({smoke()}));
    const std::string place = (folder.path() / "scene.xml").string() + ":3:";
    const auto fault = [&](const std::string& inside) { return fault_of_file(folder.write("scene.xml", scene_with(inside))); };
    EXPECT_EQ(fault(smoke_file), "");
    EXPECT_EQ(fault(smoke_file + R"(<string name="grid" value="heat"/>)").find(place + "45: volume \"openvdbvolume\": smoke.vdb: has no grid named \"heat\"; it holds \"density\" (float)"), 0u);
    EXPECT_EQ(fault(smoke_file + R"(<boolean name="use_grid_bbox" value="true"/>)").find(place), 0u);
    EXPECT_EQ(fault("").find(place + "1: volume \"openvdbvolume\": needs <string name=\"filename\""), 0u);
    const FloatGrid::Ptr distant = smoke();
    distant->setTransform(openvdb::math::Transform::createLinearTransform(1e60));
    folder.write("smoke.vdb", vdb_bytes({distant}));
    EXPECT_EQ(fault(smoke_file + R"(<transform name="to_world"><scale value="1e60"/></transform>)"), place + "45: volume \"openvdbvolume\": the grid's transform leads beyond 1e+100");
}

}  // namespace
}  // namespace tyndall::test
