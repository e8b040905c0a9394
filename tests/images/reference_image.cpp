#include "reference_image.hpp"

#include <gtest/gtest.h>

#include <iostream>

#include "pipeline/render.hpp"
#include "scene/load_scene.hpp"

namespace tyndall::test {
namespace {

const std::filesystem::path folder = std::filesystem::path(TYNDALL_SOURCE_DIR) / "tests/images";
constexpr std::uint64_t seeds[] = {1, 2, 3, 4, 5, 6, 7, 8};

ImageRgb render_once(const Scene& scene, const RenderSettings& settings)
{
    const RenderOutcome outcome = render(scene, settings);
    EXPECT_EQ(outcome.film.not_finite().count, 0u);
    EXPECT_EQ(outcome.report.ledger.not_finite_pairs, 0u);
    EXPECT_EQ(outcome.report.ledger.runaway_walks, 0u);
    ImageRgb image{outcome.film.width(), outcome.film.height(), outcome.film.beauty()};
    return image;
}

std::string letter(const std::string& scene) { return scene.substr(0, 1); }

}  // namespace

void PrintTo(const ReferenceCase& test_case, std::ostream* out) { *out << test_case.name; }

std::vector<ImageRgb> eight_renders(const ReferenceCase& test_case)
{
    const Scene scene = load_scene(folder / "scenes" / (test_case.scene + ".xml"));
    std::vector<ImageRgb> renders;
    for (const std::uint64_t seed : seeds) {
        RenderSettings settings = test_case.settings;
        settings.seed = seed;
        if (!test_case.layers.empty()) {
            settings.layers = {};
            for (const Layer layer : test_case.layers) settings.layers.add(layer);
        }
        renders.push_back(render_once(scene, settings));
    }
    return renders;
}

ImageComparison compare_with_reference(const std::vector<ImageRgb>& renders, const std::string& reference)
{
    const auto file = [&](const char* what) { return folder / "references" / (reference + what); };
    return compare_images(renders, read_rgb(file(".mean.exr")), read_rgb(file(".stderr.exr")));
}

void expect_agreement(const ReferenceCase& test_case)
{
    const ImageComparison result = compare_with_reference(eight_renders(test_case), test_case.reference);
    EXPECT_TRUE(result.passed()) << to_string(result);
    EXPECT_LE(result.block_error, largest_block_error) << to_string(result);
    std::cout << to_string(result) << '\n';
}

ReferenceCase whole_image(const std::string& scene, const RenderSettings& settings)
{
    return {letter(scene) + "_whole_image", scene, scene + ".full.inf", {}, settings};
}

ReferenceCase at_most_one_scattering(const std::string& scene, const RenderSettings& settings)
{
    return {letter(scene) + "_emitted_and_single", scene + ".black", scene + ".black.D2", {Layer::emitted, Layer::single}, settings};
}

ReferenceCase all_media_to_media(const std::string& scene, const RenderSettings& settings)
{
    return {letter(scene) + "_media_to_media", scene + ".black", scene + ".comp.ms", {Layer::media_to_media}, settings};
}

ReferenceCase double_scattering(const std::string& scene, RenderSettings settings)
{
    if (settings.method == Method::path)
        settings.max_depth = 3;
    else
        settings.light_segments = LightSegments::first;
    return {letter(scene) + "_double_scattering", scene + ".black", scene + ".comp.ds", {Layer::media_to_media}, settings};
}

}  // namespace tyndall::test
