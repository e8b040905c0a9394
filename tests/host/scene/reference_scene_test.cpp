// The scenes that reference images exist for must load, and mean what they say.
#include <algorithm>

#include "scene/describe.hpp"
#include "scene/render_space.hpp"
#include "scene_text.hpp"

namespace tyndall::test {

Scene reference(const std::string& name) { return load_scene(std::string(TYNDALL_SOURCE_DIR) + "/tests/images/scenes/" + name + ".xml"); }

TEST(ReferenceScene, AllLoadWithoutWarning)
{
    for (const char* scene : {"a_cornell_iso", "b_juice_spot", "d_plume_iso", "i_bounded_fog"})
        for (const char* variant : {"", ".black", ".alb0"}) {
            const Scene loaded = reference(std::string(scene) + variant);
            EXPECT_TRUE(loaded.warnings.empty()) << scene << variant << ": " << loaded.warnings[0];
            EXPECT_EQ(loaded.camera.width, 64);
            EXPECT_EQ(loaded.camera.filter.type, Filter::Type::box);
            EXPECT_EQ(loaded.max_depth, -1);
        }
}

TEST(ReferenceScene, CornellRoomIsFullOfFog)
{
    const Scene scene = reference("a_cornell_iso");
    EXPECT_EQ(scene.shapes.size(), 7u);
    EXPECT_EQ(scene.camera.medium, 0);
    EXPECT_EQ(scene.emitters.at(0).medium, 0);
    EXPECT_EQ(scene.emitters[0].value, Rgb(12));
    EXPECT_EQ(scene.media.at(0).sigma_t, Rgb(.6) * scene.unit);
    EXPECT_EQ(scene.media[0].albedo, Rgb(.85));
    EXPECT_EQ(reference("a_cornell_iso.alb0").media[0].albedo, Rgb(0));
    EXPECT_EQ(reference("a_cornell_iso.black").bsdfs[0].reflectance, Rgb(0));
}

TEST(ReferenceScene, JuiceIsAChromaticCube)
{
    const Scene scene = reference("b_juice_spot");
    expect_near(scene.media.at(0).sigma_t / scene.unit, Rgb(.75, 2, 5), 1e-15);
    EXPECT_EQ(scene.media[0].phase.g, .55);
    EXPECT_TRUE(scene.shapes[0].mesh.convex);
    EXPECT_TRUE(scene.shapes[0].medium_boundary);
    EXPECT_EQ(scene.shapes[0].exterior, vacuum);
    EXPECT_EQ(scene.emitters.at(0).type, Emitter::Type::spot);
    expect_near(to_file_space(scene, scene.emitters[0].position), Vec3(1.6, 1.8, .6), 1e-15);
}

TEST(ReferenceScene, PlumeIsAGridInTheCube)
{
    const Scene scene = reference("d_plume_iso");
    const Volume& volume = scene.volumes.at(0);
    EXPECT_EQ(scene.media.at(0).density, 0);
    EXPECT_EQ(scene.media[0].sigma_t, Rgb(7) * scene.unit);
    EXPECT_EQ(scene.media[0].albedo, Rgb(.9));
    EXPECT_EQ(volume.size_x * volume.size_y * volume.size_z, 64 * 64 * 64);
    EXPECT_EQ(volume.channels, 1);
    const Bounds grid = bounds_of(volume), cube = bounds_of(scene.shapes.at(0));
    expect_near(grid.low, cube.low, 1e-15);
    expect_near(grid.high, cube.high, 1e-15);
    // Where the densest voxel is tells the axes apart; the place is from the file's bytes by another reader.
    EXPECT_EQ(std::max_element(volume.values.begin(), volume.values.end()) - volume.values.begin(), (27 * 64 + 30) * 64 + 39);
    EXPECT_EQ(std::count(volume.values.begin(), volume.values.end(), 0.f), 216874);
    EXPECT_EQ(reference("d_plume_iso.alb0").media[0].albedo, Rgb(0));
    const Scene transmittance = reference("u_plume_transmittance");
    EXPECT_TRUE(transmittance.warnings.empty());
    EXPECT_EQ(transmittance.volumes.at(0).values, volume.values);
}

TEST(ReferenceScene, BoundedFogIsABoxBesideASphere)
{
    const Scene scene = reference("i_bounded_fog");
    EXPECT_EQ(scene.media.at(0).phase.g, .3);
    EXPECT_EQ(scene.shapes.at(3).type, Shape::Type::sphere);
    EXPECT_NEAR(glm::length(Vec3(scene.shapes[3].to_world[0])) * scene.unit, .35, 1e-15);
    EXPECT_EQ(scene.emitters.at(0).type, Emitter::Type::area);
    EXPECT_EQ(scene.emitters[0].medium, vacuum);
}

}  // namespace tyndall::test
