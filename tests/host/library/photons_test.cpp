/// The example that traces its own photons and leaves only connections to Tyndall, against the renderer's image of the same scene.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "../../support/child_process.hpp"
#include "../../support/image_comparison.hpp"
#include "tyndall/tyndall.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

ImageRgb read_pfm(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::string kind, order;
    int width = 0, height = 0;
    stream >> kind >> width >> height >> order;
    stream.get();
    EXPECT_EQ(kind + order, "PF-1.0");
    ImageRgb image{width, height, std::vector<Vec3>(std::size_t(width) * std::size_t(height))};
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x) {
            float rgb[3];
            stream.read(reinterpret_cast<char*>(rgb), sizeof rgb);
            image.at(x, y) = {rgb[0], rgb[1], rgb[2]};
        }
    EXPECT_TRUE(stream);
    return image;
}

/// Of three floats a pixel.
ImageRgb image_of(std::span<const float> values, int width, int height, double power)
{
    ImageRgb image{width, height, std::vector<Vec3>(std::size_t(width) * std::size_t(height))};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t i = 3 * std::size_t(y * width + x);
            image.at(x, y) = {std::pow(values[i], power), std::pow(values[i + 1], power), std::pow(values[i + 2], power)};
        }
    return image;
}

TEST(Backend, APhotonTracerOfItsOwnGivesTheRenderersImage)
{
    const TemporaryFolder folder;
    std::vector<ImageRgb> runs;
    for (int seed = 1; seed <= 8; ++seed) {
        const ProcessResult ran = run_process({PHOTONS, "photons.pfm", std::to_string(seed), "24"}, {.folder = folder.path()});
        ASSERT_EQ(ran.exit_code, 0) << ran.err;
        runs.push_back(read_pfm(folder / "photons.pfm"));
    }
    RenderSettings settings;
    settings.passes = 128, settings.selftest = false;
    settings.layers = LayerSet().add(Layer::media_to_media);
    const api::Image image = api::render(api::Scene::load(std::filesystem::path(TYNDALL_SOURCE_DIR) / "host/examples/photons.xml"), settings);
    const ImageComparison result = compare_images(runs, image_of(image.beauty(), image.width(), image.height(), 1), image_of(image.variance(), image.width(), image.height(), .5));
    EXPECT_TRUE(result.passed()) << to_string(result);
}

}  // namespace
