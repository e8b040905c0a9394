/// Shipped scenes of forward scattering, by virtual ray lights and by path tracing, layer by layer: no reference but each other. Slow, eleven minutes of one core: at g = .95
/// connections along both lobes at once are so rare and bright that twenty times the work halves the noise at best; 8 % is what a few minutes can prove there.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "pipeline/render.hpp"
#include "scene/load_scene.hpp"

using namespace tyndall;

namespace {

constexpr Layer layers[] = {Layer::single, Layer::media_to_media, Layer::media_to_surface};
constexpr int runs = 8;

struct Mean {
    double value = 0, error = 0;  ///< of the mean of the runs: standard error
};

/// Mean of a layer over pixels and channels, per seed 1 to 8, then over the seeds.
std::array<Mean, 3> means(const Scene& scene, RenderSettings settings)
{
    std::array<std::array<double, runs>, 3> each{};
    settings.layers = {};
    for (const Layer layer : layers) settings.layers.add(layer);
    for (int run = 0; run < runs; ++run) {
        settings.seed = static_cast<std::uint64_t>(run + 1);
        const RenderOutcome outcome = render(scene, settings);
        EXPECT_EQ(outcome.film.not_finite().count, 0u);
        for (std::size_t l = 0; l < 3; ++l)
            for (const Rgb& pixel : outcome.film.mean(layers[l])) each[l][std::size_t(run)] += (pixel.r + pixel.g + pixel.b) / (3. * scene.camera.crop_width * scene.camera.crop_height);
    }
    std::array<Mean, 3> result;
    for (std::size_t l = 0; l < 3; ++l) {
        for (const double x : each[l]) result[l].value += x / runs;
        for (const double x : each[l]) result[l].error += (x - result[l].value) * (x - result[l].value) / (runs * (runs - 1.));
        result[l].error = std::sqrt(result[l].error);
    }
    return result;
}

/// What the comparison must be able to see: half the width of the 95 % interval of the ratio, per layer.
struct Twins {
    const char* scene;
    RenderSettings vrl, path;
    std::array<double, 3> precision;
};
void PrintTo(const Twins& twins, std::ostream* out) { *out << twins.scene; }

class ShippedTwins : public testing::TestWithParam<Twins> {};

TEST_P(ShippedTwins, AgreeLayerByLayer)
{
    Scene scene = load_scene(std::string(TYNDALL_SOURCE_DIR) + "/scenes/" + GetParam().scene + "/scene.xml");
    scene.camera.width = scene.camera.height = scene.camera.crop_width = scene.camera.crop_height = 32;
    scene.camera.crop_x = scene.camera.crop_y = 0;
    const auto vrl = means(scene, GetParam().vrl), path = means(scene, GetParam().path);
    for (std::size_t l = 0; l < 3; ++l) {
        const double relative = std::hypot(vrl[l].error / vrl[l].value, path[l].error / path[l].value), bias = vrl[l].value / path[l].value - 1;
        std::cout << name(layers[l]) << ": " << 100 * bias << " % +- " << 214.5 * relative << " % (95 %)\n";  // 2.145: Student's t for 14 degrees of freedom
        EXPECT_LE(2.145 * relative, GetParam().precision[l]) << name(layers[l]) << ": the comparison sees too little";
        EXPECT_LE(std::abs(bias), 4 * relative) << name(layers[l]);  // 4: one false alarm in 400 comparisons, with 14 degrees of freedom or fewer
    }
}

INSTANTIATE_TEST_SUITE_P(Of, ShippedTwins,
                         testing::Values(Twins{"glossy_medium", {.method = Method::vrl, .passes = 500, .lights = 4096}, {.method = Method::path, .passes = 10000}, {.004, .08, .04}},
                                         Twins{"backlit_smoke", {.method = Method::vrl, .passes = 250, .lights = 1024}, {.method = Method::path, .passes = 2500}, {.01, .015, .02}}),
                         [](const auto& info) { return std::string(info.param.scene); });

}  // namespace
