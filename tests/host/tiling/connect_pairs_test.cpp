/// Pairs with shadow segments: who answers them changes no bit, and what goes wrong while tiles are on their way is told once and leaves the stage as it was.
#include "tiling/connect_pairs.hpp"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

#include "kernels/shared/host_features.hpp"
#include "scene/mesh_geometry.hpp"
#include "throughput/workload.hpp"

namespace tyndall {
namespace {

constexpr float scale = .19f;  // the lights' cube has a side of .38

/// A cube of that side over four in the middle of the lights.
Scene cube_in_the_middle()
{
    Scene scene;
    scene.bsdfs.push_back({.type = Bsdf::Type::diffuse});
    Mesh cube = cube_mesh();
    transform_mesh(cube, glm::scale(Mat4(1), Vec3(.05)));
    scene.shapes.push_back({.name = "cube", .type = Shape::Type::mesh, .mesh = cube, .bsdf = 0});
    return scene;
}

class ConnectPairs : public testing::Test {
protected:
    static constexpr std::uint32_t features = feature_bit::occluders;

    std::vector<double> connect(const ConnectSettings& settings) { return connect_pairs(stage, visibility, batch(), lights(), settings, counts); }
    EyeBatch batch() const { return {work.eye_bytes(), static_cast<std::uint32_t>(work.eyes.size()), std::vector<int>(work.eyes.size(), vacuum)}; }
    LightBatch lights() const { return {work.lights, work.light_count}; }

    Scene scene = cube_in_the_middle();
    Visibility visibility{scene};
    Workload work = make_workload({.eyes = 512, .lights = 300, .g = 0, .scale = scale, .camera = true});
    Device device;
    PairStage stage{device, {.features = features}, work.tables};
    ConnectSettings by_device{.features = features, .lanes = 16}, by_host{.features = features, .lanes = 16, .native_kernels = false};
    ConnectCounts counts;
};

TEST_F(ConnectPairs, ByTheDevicesThreadsAndByTheHostAreTheSameForEveryTile)
{
    ASSERT_TRUE(stage.runs_native_kernels()) << "PoCL runs native kernels; without them this test compares nothing";
    const std::vector<double> expected = connect(by_host);
    const ConnectCounts host_counts = counts;
    EXPECT_GT(host_counts.shadow_segments, 0u);
    EXPECT_LT(host_counts.shadow_segments, host_counts.pairs + 1);
    for (const std::uint32_t tile_pairs : {0u, 4096u, 65536u}) {
        by_device.tile_pairs = tile_pairs;
        counts = {};
        EXPECT_EQ(connect(by_device), expected) << tile_pairs;
        EXPECT_EQ(counts.shadow_segments, host_counts.shadow_segments);
        EXPECT_EQ(counts.pairs, host_counts.pairs);
        EXPECT_GT(counts.visibility_seconds, 0);
    }
}

TEST_F(ConnectPairs, SomethingIsInTheWay)
{
    const std::vector<double> expected = connect(by_device);
    Scene empty = scene;
    empty.shapes.clear();
    const Visibility clear(empty);
    const std::vector<double> free = connect_pairs(stage, clear, batch(), lights(), by_device, counts);
    double blocked = 0, all = 0;
    for (std::size_t i = 0; i < free.size(); ++i) {
        EXPECT_GE(free[i], expected[i]);
        blocked += free[i] - expected[i], all += free[i];
    }
    EXPECT_GT(blocked, .01 * all);
}

TEST_F(ConnectPairs, WalksThroughBoundariesAreTheSameByTheDevicesThreads)
{
    constexpr std::uint32_t walked = features | feature_bit::nonconvex_media;
    PairStage walking(device, {.features = walked}, work.tables);
    by_device.features = by_host.features = walked;
    const auto sums = [&](const ConnectSettings& settings) { return connect_pairs(walking, visibility, batch(), lights(), settings, counts); };
    EXPECT_EQ(sums(by_device), sums(by_host));
}

TEST_F(ConnectPairs, WhatATilesWorkThrowsIsThrownOnceAndTheNextSumsAreRight)
{
    const std::vector<double> expected = connect(by_device);
    const EyeBatch eyes = batch();
    for (const int failing : {0, 1, 5, 30}) {
        stage.begin(eyes.records, eyes.count, work.lights, 0xffffffffu);
        std::atomic<int> begun{0};
        const auto chain_all = [&] {
            for (std::uint32_t group = 0; group < stage.groups(); ++group)
                stage.chain({group, 1, 0, light_block}, [&](const SampledTile&) {
                    if (begun++ == failing) throw std::runtime_error("no answer");
                });
            stage.end_chain();
        };
        EXPECT_THROW(chain_all(), std::runtime_error) << failing;
        stage.drop_chain();
        EXPECT_EQ(connect(by_device), expected) << failing;
    }
}

TEST_F(ConnectPairs, StopsBetweenTiles)
{
    const std::vector<double> expected = connect(by_device);
    StopFlag stop;
    stop.raise();
    by_device.stop = &stop;
    EXPECT_THROW(connect(by_device), Stopped);
    by_device.stop = nullptr;
    EXPECT_EQ(connect(by_device), expected);
}

}  // namespace
}  // namespace tyndall
