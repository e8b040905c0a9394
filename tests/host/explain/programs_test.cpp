/// How many programs a scene builds: each costs most of a second before the first pixel.
#include <gtest/gtest.h>

#include <set>

#include "device/prebuild.hpp"
#include "kernels/shared/host_features.hpp"
#include "pipeline/pass_renderer.hpp"
#include "scene/load_scene.hpp"

namespace tyndall::test {
namespace {

Scene scene_at(const std::string& path)
{
    Scene scene = load_scene(std::string(TYNDALL_SOURCE_DIR) + "/" + path);
    scene.camera.width = scene.camera.height = scene.camera.crop_width = scene.camera.crop_height = 16;
    scene.camera.crop_x = scene.camera.crop_y = 0;
    return scene;
}

Scene shipped(const std::string& name) { return scene_at("scenes/" + name + "/scene.xml"); }

std::uint64_t programs_of(const Scene& scene, const RenderSettings& settings = {.passes = 1})
{
    Report report;
    PassRenderer(scene, settings).fill(report);
    return report.programs;
}

TEST(Programs, PerShippedScene)
{
    EXPECT_EQ(programs_of(shipped("plume")), 8u);          // gather_lights, tabulate_lights and estimate_lights for both, tabulate_eyes for segments, select_lights
    EXPECT_EQ(programs_of(shipped("six_vrls")), 3u);     // nothing to receive light but fog: estimate_lights, select_lights, gather_lights
    EXPECT_EQ(programs_of(shipped("fruit_juice")), 5u);  // estimate_lights and gather_lights for segments and for points, one select_lights for both
    EXPECT_EQ(programs_of(shipped("cornell_fog")), 6u);  // estimate_lights and sample_pairs for segments and for points, one select_lights and accumulate_pairs
    EXPECT_EQ(programs_of(shipped("fog_and_slit")), 6u);
    EXPECT_EQ(programs_of(shipped("glossy_medium")), 5u);
    EXPECT_EQ(programs_of(shipped("backlit_smoke")), 6u);  // both estimate_lights, select_lights, gather_lights for segments, sample_pairs and accumulate_pairs for points
}

TEST(Programs, NoneForPathTracingAndNoDeviceForLayersWithoutVirtualLights)
{
    EXPECT_EQ(programs_of(shipped("cornell_fog"), {.method = Method::path, .passes = 1}), 0u);
    EXPECT_EQ(programs_of(shipped("cornell_fog"), {.layers = LayerSet().add(Layer::single), .passes = 1}), 0u);
    EXPECT_EQ(programs_of(shipped("cornell_fog"), {.layers = LayerSet().add(Layer::media_to_media), .passes = 1}), 4u);
}

TEST(Programs, OfShippedScenesAreAmongThoseThatPrebuildBuilds)
{
    std::set<std::string> everyday;
    const auto add = [](const PairProgram& program, std::set<std::string>& set) {
        for (const KernelBuild& build : kernel_builds(program)) set.insert(build.name + (program.eyes == EyeKind::points ? " points " : " segments ") + build.options);
    };
    for (const PairProgram& program : everyday_programs(16)) add(program, everyday);
    EXPECT_LE(everyday.size(), 75u);
    for (const char* name : {"scenes/six_vrls/scene.xml", "scenes/fruit_juice/scene.xml", "scenes/cornell_fog/scene.xml", "scenes/fog_and_slit/scene.xml",
                             "scenes/glossy_medium/scene.xml", "scenes/backlit_smoke/scene.xml", "scenes/plume/scene.xml", "tests/images/scenes/d_plume_iso.xml"}) {
        const Scene scene = scene_at(name);
        const RenderSettings settings{.passes = 1};
        const SceneFeatures features = features_of(scene, false, scene.max_depth);
        const LayerPlan plan = plan_layers(scene, features, settings);
        const BuildMasks masks = build_masks(features, plan, {});
        std::set<std::string> needed;
        for (const Layer layer : connected_layers(plan)) add(pair_program(plan, settings, layer, masks, 16), needed);
        for (const std::string& program : needed) EXPECT_TRUE(everyday.contains(program)) << name << ": " << program;
    }
}

TEST(Programs, PrebuildRunsBothPipelines)
{
    Device device;
    prebuild(device, {.features = 0, .lanes = 4});
    EXPECT_EQ(device.programs_built(), 1u);
    prebuild(device, {.features = feature_bit::occluders, .lanes = 4});
    EXPECT_EQ(device.programs_built(), 3u);
    prebuild(device, {.eyes = EyeKind::points, .features = feature_bit::occluders, .lanes = 4});
    EXPECT_EQ(device.programs_built(), 4u) << "accumulate_pairs is shared";
    prebuild(device, {.features = 0, .lanes = 4, .selection = true});
    EXPECT_EQ(device.programs_built(), 7u) << "estimate_lights, select_lights and another gather_lights";
    prebuild(device, {.features = feature_bit::occluders, .lanes = 4, .selection = true});
    EXPECT_EQ(device.programs_built(), 8u) << "another sample_pairs; estimates do not ask what stands between";
    prebuild(device, {.features = feature_bit::heterogeneous, .lanes = 4});
    EXPECT_GT(device.programs_built(), 8u) << "a grid's kernels, run without a grid";
}

}  // namespace
}  // namespace tyndall::test
