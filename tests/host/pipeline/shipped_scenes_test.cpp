/// Every scene of the repository renders without a value that is not finite.
#include <algorithm>
#include <filesystem>

#include "support/every_variant.hpp"
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

std::vector<std::filesystem::path> shipped_scenes()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TYNDALL_SOURCE_DIR) / "scenes"))
        if (std::filesystem::exists(entry.path() / "scene.xml")) files.push_back(entry.path() / "scene.xml");
    std::ranges::sort(files);
    return files;
}

class ShippedScene : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(ShippedScene, RendersWithAnEmptyLedger)
{
    Scene scene = load_scene(GetParam());
    scene.camera.width = scene.camera.height = scene.camera.crop_width = scene.camera.crop_height = 24;
    scene.camera.crop_x = scene.camera.crop_y = 0;
    for (const Method method : {Method::vrl, Method::path})
        for (const SegmentLength length : {SegmentLength::long_, SegmentLength::short_}) {
            const WholeRender r =
                render_whole(scene, {.method = method, .passes = 2, .lights = 256, .segment_length = length});  // which expects it
            double total = 0;
            for (const Rgb& pixel : r.film().beauty()) total += pixel.r + pixel.g + pixel.b;
            EXPECT_GT(total, 0);
        }
}

/// By one of the ways, which scenes share out between them; EVERY_VARIANT: by each.
TEST_P(ShippedScene, RendersWithAnEmptyLedgerByEverySamplerAndLaneWidth)
{
    using Way = std::pair<Sampler, int>;
    const std::vector<Way> ways{{Sampler::paper_isotropic, 16}, {Sampler::paper, 16}, {Sampler::paper, 1}, {Sampler::paper_6, 16}, {Sampler::table, 16}, {Sampler::table_4x4, 8}, {Sampler::table_3x2, 16}};
    Scene scene = load_scene(GetParam());
    scene.camera.width = scene.camera.height = scene.camera.crop_width = scene.camera.crop_height = 16;
    scene.camera.crop_x = scene.camera.crop_y = 0;
    for (const auto& [sampler, lanes] : covering_part(std::span<const Way>(ways), place_in(shipped_scenes(), GetParam()), ways.size()))
        render_whole(scene, {.passes = 2, .lights = 256, .sampler = sampler, .lanes = lanes});  // which expects it
}

INSTANTIATE_TEST_SUITE_P(Of, ShippedScene, testing::ValuesIn(shipped_scenes()),
                         [](const auto& info) { return info.param.parent_path().filename().string(); });

TEST(ShippedScenes, AreThere) { EXPECT_GE(shipped_scenes().size(), 6u); }

}  // namespace
