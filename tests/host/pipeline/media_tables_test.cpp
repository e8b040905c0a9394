/// Media and grids as the device gets them.
#include "pipeline/media_tables.hpp"

#include <gtest/gtest.h>

#include <random>

#include "scene/transforms.hpp"

namespace tyndall::test {
namespace {

/// Two grids in boxes that are turned, stretched and mirrored, and media that use them in every way.
Scene scene_of_grids()
{
    Scene scene;
    scene.volumes.push_back({.name = "density", .size_x = 2, .size_y = 3, .size_z = 4, .channels = 3, .to_world = translation({.1, -.2, .3}) * rotation({1, 2, 3}, 40) * scaling({.5, -.25, 2})});
    scene.volumes.push_back({.name = "albedo", .size_x = 5, .to_world = scaling(Vec3(2))});
    for (Volume& volume : scene.volumes)
        for (int i = 0; i < volume.size_x * volume.size_y * volume.size_z * volume.channels; ++i) volume.values.push_back(static_cast<float>(i) + (volume.channels == 1 ? .5f : 0));
    scene.media.push_back({.name = "plain", .sigma_t = {1, 2, 4}, .albedo = {.5, .25, 1}});
    scene.media.push_back({.name = "smoke", .sigma_t = Rgb(8), .albedo = {.5, .25, 1}, .density = 0});
    scene.media.push_back({.name = "both", .sigma_t = Rgb(8), .albedo = {.5, .25, 1}, .density = 0, .albedo_volume = 1});
    return scene;
}

TEST(MediaTables, ScatteringIsExtinctionWhereAGridMultipliesIt)
{
    const MediaTables tables = media_tables(scene_of_grids(), {});
    const auto sigma_s = [&](std::size_t i) { return std::array{tables.media[i].sigma_s_r, tables.media[i].sigma_s_g, tables.media[i].sigma_s_b}; };
    ASSERT_EQ(tables.media.size(), 4u);
    EXPECT_EQ(tables.media[3].sigma_t_r, 0) << "the last is vacuum";
    EXPECT_EQ(tables.media[3].density_grid, NO_GRID);
    EXPECT_EQ(sigma_s(0), (std::array{.5f, .5f, 4.f}));
    EXPECT_EQ(sigma_s(1), (std::array{4.f, 2.f, 8.f}));
    EXPECT_EQ(sigma_s(2), (std::array{8.f, 8.f, 8.f}));
    EXPECT_EQ(tables.media[2].sigma_t_g, 8);
    EXPECT_EQ(tables.media[0].density_grid, NO_GRID);
    EXPECT_EQ(tables.media[0].albedo_grid, NO_GRID);
    EXPECT_EQ(tables.media[1].density_grid, 0u);
    EXPECT_EQ(tables.media[1].albedo_grid, NO_GRID);
    EXPECT_EQ(tables.media[2].albedo_grid, 1u);
    EXPECT_EQ(tables.media[0].grid_colours, 0u);
    EXPECT_EQ(tables.media[2].grid_colours, DENSITY_GRID_COLOURED);
}

TEST(MediaTables, EveryGridSaysWhetherItHasColours)
{
    Scene scene = scene_of_grids();
    scene.media[2].density = 1, scene.media[2].albedo_volume = 0;
    EXPECT_EQ(media_tables(scene, {}).media[2].grid_colours, ALBEDO_GRID_COLOURED);
    scene.media[2].density = 0;
    EXPECT_EQ(media_tables(scene, {}).media[2].grid_colours, DENSITY_GRID_COLOURED + ALBEDO_GRID_COLOURED);
}

TEST(MediaTables, VoxelsStandOneGridAfterTheOther)
{
    const Scene scene = scene_of_grids();
    const MediaTables tables = media_tables(scene, {});
    ASSERT_EQ(tables.voxels.size(), 2u * 3 * 4 * 3 + 5);
    ASSERT_EQ(tables.grids.size(), 2u);
    EXPECT_EQ(tables.grids[0].first, 0u);
    EXPECT_EQ(tables.grids[1].first, 72u);
    for (std::size_t i = 0; i < 72; ++i) EXPECT_EQ(tables.voxels[i], scene.volumes[0].values[i]);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(tables.voxels[72 + i], scene.volumes[1].values[i]);
    EXPECT_EQ(tables.grids[0].size_x, 2u);
    EXPECT_EQ(tables.grids[0].size_y, 3u);
    EXPECT_EQ(tables.grids[0].size_z, 4u);
}

TEST(MediaTables, RowsLeadFromRenderSpaceToVoxels)
{
    const Scene scene = scene_of_grids();
    const MediaTables tables = media_tables(scene, {});
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1, 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const Volume& volume = scene.volumes[i];
        const GridRecord& g = tables.grids[i];
        for (int trial = 0; trial < 100; ++trial) {
            const Vec3 voxel(uniform(random) * volume.size_x, uniform(random) * volume.size_y, uniform(random) * volume.size_z);
            const Vec3 p = transform_point(volume.to_world, voxel / Vec3(volume.size_x, volume.size_y, volume.size_z));
            const Vec3 found(g.x_x * p.x + g.x_y * p.y + g.x_z * p.z + g.x_0, g.y_x * p.x + g.y_y * p.y + g.y_z * p.z + g.y_0, g.z_x * p.x + g.z_y * p.y + g.z_z * p.z + g.z_0);
            // float coefficients of at most 12 voxels per unit, four of them, at points within 5 units: 12 x 5 x 4 x 2^-24 = 1.4e-5
            for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[axis], voxel[axis], 1.5e-5);
        }
    }
}

}  // namespace
}  // namespace tyndall::test
