/// Another driver's device beside PoCL's: the same values within 1e-5, the same image. TYNDALL_OTHER_DEVICE names it, TYNDALL_OTHER_LANES its lane widths, with commas (1): tests/rusticl.sh and
/// tests/intel.sh set them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "../host/pipeline/whole_renderer.hpp"
#include "kernels/shared/host_features.hpp"
#include "tests/device/grid_pairs.hpp"
#include "tests/device/random_pairs.hpp"

namespace tyndall::test {
namespace {

using testing::RandomPairs;

constexpr const char* default_device = "portable:";  ///< PoCL's platform, whatever else the loader finds

class OtherDevice : public ::testing::Test {
protected:
    void SetUp() override
    {
        const char* named = std::getenv("TYNDALL_OTHER_DEVICE");
        if (!named) GTEST_SKIP() << "TYNDALL_OTHER_DEVICE names no device; tests/rusticl.sh does";
        name = named;
        const char* widths = std::getenv("TYNDALL_OTHER_LANES");
        std::istringstream list(widths ? widths : "1");
        for (std::string width; std::getline(list, width, ',');) lanes.push_back(std::stoi(width));
    }
    std::string name;
    std::vector<int> lanes{};
};

/// Values of both devices: finite, not all zero, and within 1e-5 of each other or of a thousandth of the largest (values that nearly cancel).
void expect_agreement(const std::vector<double>& a, const std::vector<double>& b)
{
    ASSERT_EQ(a.size(), b.size());
    double largest = 0;
    for (const double value : a) largest = std::max(largest, std::abs(value));
    EXPECT_GT(largest, 0);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-5 * std::max(std::abs(a[i]), 1e-3 * largest)) << i;
}

std::vector<double> sums_on(const std::string& device_name, const RandomPairs& pairs, const PairProgram& program)
{
    Device device(device_name);
    PairStage stage(device, program, pairs.tables);
    return testing::gathered(stage, pairs, program.eyes, 1000, 1024);
}

TEST_F(OtherDevice, GathersTheSameSums)
{
    const RandomPairs plain = testing::random_pairs({.eyes = 16, .lights = 21}), coloured = testing::random_pairs({.eyes = 16, .lights = 21, .g = .55, .coloured = true, .short_lights = true});
    const std::uint32_t mask = feature_bit::anisotropic | feature_bit::coloured | feature_bit::short_lights;
    for (const int width : lanes) {
        SCOPED_TRACE(width);
        for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
            const PairProgram program{.eyes = kind, .lanes = width};
            expect_agreement(sums_on(default_device, plain, program), sums_on(name, plain, program));
        }
        const PairProgram program{.features = mask, .lanes = width};
        expect_agreement(sums_on(default_device, coloured, program), sums_on(name, coloured, program));
    }
}

/// Both ways to find transmittances through a grid.
constexpr int every_transmittance[] = {TRANSMITTANCE_MARCH, TRANSMITTANCE_EXACT};

TEST_F(OtherDevice, GathersTheSameSumsThroughDensityGrids)
{
    const RandomPairs pairs = testing::grid_pairs({});
    for (const int width : lanes)
        for (const int transmittance : every_transmittance) {
            SCOPED_TRACE(std::to_string(width) + " lanes, " + std::to_string(transmittance));
            const PairProgram program{.eyes = EyeKind::points, .features = feature_bit::heterogeneous, .lanes = width, .transmittance = transmittance};
            expect_agreement(sums_on(default_device, pairs, program), sums_on(name, pairs, program));
        }
}

// rusticl is not done with these programs after eight minutes: TYNDALL_OTHER_GRID_SEGMENTS says where they are worth waiting for.
TEST_F(OtherDevice, GathersTheSameSumsOfSegmentsThroughDensityGrids)
{
    if (!std::getenv("TYNDALL_OTHER_GRID_SEGMENTS")) GTEST_SKIP() << "TYNDALL_OTHER_GRID_SEGMENTS is not set; tests/intel.sh does";
    const RandomPairs pairs = testing::grid_pairs({.g = .6, .coloured = true, .albedo = true});
    const std::uint32_t mask = feature_bit::heterogeneous | feature_bit::anisotropic | feature_bit::coloured | feature_bit::coloured_grids;
    for (const int width : lanes)
        for (const int transmittance : every_transmittance) {
            SCOPED_TRACE(std::to_string(width) + " lanes, " + std::to_string(transmittance));
            const PairProgram program{.features = mask, .lanes = width, .transmittance = transmittance};
            expect_agreement(sums_on(default_device, pairs, program), sums_on(name, pairs, program));
        }
}

std::vector<double> contributions_on(const std::string& device_name, const RandomPairs& pairs, int lanes)
{
    Device device(device_name);
    PairStage stage(device, {.features = feature_bit::occluders, .lanes = lanes}, pairs.tables);
    stage.begin(std::as_bytes(std::span(pairs.segments)), static_cast<std::uint32_t>(pairs.segments.size()), pairs.lights, 0xffffffffu);
    stage.sample(0, {0, stage.groups(), 0, pairs.light_count});
    const auto values = stage.sampled(0).contributions;
    std::vector<double> contributions(values.begin(), values.end());
    stage.accumulate(0);
    const std::vector<double> sums = stage.sums();
    contributions.insert(contributions.end(), sums.begin(), sums.end());
    return contributions;
}

TEST_F(OtherDevice, SamplesAndAccumulatesTheSamePairs)
{
    const RandomPairs pairs = testing::random_pairs({.eyes = 16, .lights = 21});
    for (const int width : lanes) {
        SCOPED_TRACE(width);
        expect_agreement(contributions_on(default_device, pairs, width), contributions_on(name, pairs, width));
    }
}

/// Root of the relative mean square of the difference. Both have the same random numbers, so that it is rounding: far below any standard error, z-equal a fortiori.
double difference(const std::string& a, const std::string& b, const Scene& scene, RenderSettings settings)
{
    settings.device = a;
    const std::vector<Rgb> here = render(scene, settings).film.beauty();
    settings.device = b;
    const std::vector<Rgb> there = render(scene, settings).film.beauty();
    EXPECT_EQ(here.size(), there.size());
    Rgb squares(0), differences(0);
    for (std::size_t i = 0; i < std::min(here.size(), there.size()); ++i) squares += here[i] * here[i], differences += (here[i] - there[i]) * (here[i] - there[i]);
    EXPECT_GT(squares.g, 0);
    return std::sqrt(differences.g / squares.g);
}

const std::string fog = medium("fog", Rgb(1), Rgb(.8), 0) + container(Vec3(-.5), Vec3(.5), "fog") + point_light({.5, 1, .5}, Rgb(2)) + sensor({.origin = {.3, .6, 3}, .pixels = 16});

TEST_F(OtherDevice, RendersTheSameImage)
{
    for (const int width : lanes)
        EXPECT_LT(difference(default_device, name, scene_of(fog), {.passes = 2, .lights = 50, .lanes = width, .selection = Selection::all, .selftest = false}), 1e-5) << width;
}

// Shadow segments, surfaces and media, points, beams and photons: the widest lanes alone, so that the programs of all methods are built once.
TEST_F(OtherDevice, RendersTheSameImageByEveryMethod)
{
    const Scene scene = scene_of(fog + horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75))) + sphere({.1, .1, .1}, .2, diffuse(Rgb(.5))));
    for (const char* method : {"vrl", "vpl", "vpl-clamped", "vbl", "beams", "photons"})
        EXPECT_LT(difference(default_device, name, scene, {.method = Method(method), .passes = 1, .lights = 50, .lanes = lanes.back(), .selection = Selection::all, .selftest = false}), 1e-5) << method;
}

// Lights that are chosen: where a random number falls on the edge between two lights, rounding decides which one it is, and the pixels of that square differ by noise. The images are equal within their
// error bars all the same, and far more than images of other random numbers, whose share is 1.
TEST_F(OtherDevice, RendersTheSameImageWithChosenLights)
{
    const Scene scene = scene_of(fog + sphere({.1, .1, .1}, .2, diffuse(Rgb(.5))));
    for (const int width : lanes) {
        RenderSettings settings{.passes = 4, .lights = 200, .lanes = width, .selection = Selection::tile, .selected_lights = 16, .selftest = false};
        settings.layers = LayerSet().add(Layer::media_to_media);
        settings.device = default_device;
        const Film here = render(scene, settings).film;
        settings.device = name;
        const Film there = render(scene, settings).film;
        double differences = 0, variances = 0;
        for (std::size_t i = 0; i < here.beauty().size(); ++i) {
            const Rgb d = here.beauty(i) - there.beauty(i), v = here.variance_of_mean(i) + there.variance_of_mean(i);
            differences += d.g * d.g, variances += v.g;
        }
        EXPECT_GT(variances, 0);
        EXPECT_LT(differences / variances, .01) << width;
        EXPECT_LT(difference(default_device, name, scene, settings), 1e-3) << width;
    }
}

}  // namespace
}  // namespace tyndall::test
