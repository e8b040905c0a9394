/// The rows of the hard cases that concern the renderer rather than one formula (host/docs/hard_cases.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>

#include "kernels/shared/host_features.hpp"
#include "pipeline/render.hpp"
#include "scene/load_scene.hpp"
#include "tests/device/random_pairs.hpp"
#include "transport/medium.hpp"
#include "visibility/visibility.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall {
namespace maths_float {
#include "kernels/math/long_sum.h"
}
#undef LONG_SUM_H
namespace maths_double {
#include "kernels/math/long_sum.h"
}

namespace {

/// Fog in a cube around a point light, seen from outside, with a wall behind it. `shift` moves everything along x.
std::string foggy_scene(double shift, const std::string& intensity, int size = 8)
{
    const auto at = [&](const char* name, double x, double y, double z) {
        return "<translate x=\"" + std::to_string(x + shift) + "\" y=\"" + std::to_string(y) + "\" z=\"" + std::to_string(z) + "\"/>" + std::string(name);
    };
    return "<scene version=\"3.0.0\"><medium type=\"homogeneous\" id=\"fog\"><float name=\"sigma_t\" value=\"1\"/><float name=\"albedo\" value=\"0.75\"/>"
           "<phase type=\"isotropic\"/></medium><sensor type=\"perspective\"><float name=\"fov\" value=\"40\"/><transform name=\"to_world\">" +
           at("", 0, 0, -4) + "</transform><film type=\"hdrfilm\"><integer name=\"width\" value=\"" + std::to_string(size) + "\"/><integer name=\"height\" value=\"" +
           std::to_string(size) + "\"/><rfilter type=\"box\"/></film></sensor><shape type=\"cube\"><transform name=\"to_world\">" + at("", 0, 0, 0) +
           "</transform><bsdf type=\"null\"/><ref name=\"interior\" id=\"fog\"/></shape><shape type=\"rectangle\"><transform name=\"to_world\"><scale value=\"4\"/>" +
           "<rotate y=\"1\" angle=\"180\"/>" + at("", 0, 0, 2) + "</transform></shape><emitter type=\"point\"><transform name=\"to_world\">" + at("", .25, .5, -.25) +
           "</transform><rgb name=\"intensity\" value=\"" + intensity + "\"/><ref id=\"fog\"/></emitter></scene>";
}

std::vector<Rgb> beauty(const std::string& xml, RenderSettings settings = {})
{
    if (settings.passes == 0) settings.passes = 2;
    if (settings.lights == 0) settings.lights = 64;
    const RenderOutcome outcome = render(parse_scene(xml, ".", "hard case"), settings);
    EXPECT_EQ(outcome.report.ledger.not_finite_pairs, 0u);
    EXPECT_EQ(outcome.film.not_finite().count, 0u);
    return outcome.film.beauty();
}

TEST(HardCases, Row22ColouredExtinctionHasBoundedWeightsAndTheRightMeans)
{
    Scene scene;
    scene.media.push_back({.name = "ink", .sigma_t = {.1, 1, 30}, .albedo = {.9, .8, .7}});
    const std::vector<MediumPiece> pieces{{0, 0, 2}};
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> uniform;
    Rgb collided(0), passed(0);
    constexpr int draws = 400000;
    for (int i = 0; i < draws; ++i) {
        const FreeFlight flight = sample_free_flight(scene, std::span(pieces), Rgb(1), {uniform(engine), uniform(engine)});
        (flight.collided ? collided : passed) += flight.weight;
        for (int c = 0; c < 3; ++c) ASSERT_LE(flight.weight[c], 3 * (1 + 1e-12)) << "balance over three channels";
    }
    for (int c = 0; c < 3; ++c) {
        const double transmitted = std::exp(-2 * scene.media[0].sigma_t[c]);
        // Weights lie in [0, 3]: the standard error of a mean is below 3 / (2 sqrt(draws)) = .0024; five of them.
        EXPECT_NEAR(collided[c] / draws, scene.media[0].albedo[c] * (1 - transmitted), .012);
        EXPECT_NEAR(passed[c] / draws, transmitted, .012);
    }
}

TEST(HardCases, Row23FarFromTheOriginNothingChanges)
{
    for (const int lanes : {1, 4, 8, 16}) {
        const auto here = beauty(foggy_scene(0, "5, 5, 5"), {.lanes = lanes});
        for (const double shift : {1024.0, 65536.0, 1048576.0}) EXPECT_EQ(beauty(foggy_scene(shift, "5, 5, 5"), {.lanes = lanes}), here) << "moved by " << shift << ", " << lanes << " lanes";
    }
}

TEST(HardCases, Row25FluxOfAnySizeAndDarkChannels)
{
    const auto one = beauty(foggy_scene(0, "1, 0, 1"));
    for (const auto& [value, scale] : {std::pair("1e-20, 0, 1e20", 1e20), std::pair("1e20, 0, 1e-20", 1e-20)}) {
        const auto other = beauty(foggy_scene(0, value));
        for (std::size_t i = 0; i < one.size(); ++i) {
            EXPECT_EQ(other[i].g, 0);
            EXPECT_NEAR(other[i].b, one[i].b * scale, 2e-2 * one[i].b * scale) << "the choice of channels differs, not the mean";
        }
    }
}

TEST(HardCases, Row26SumsOfManyTermsDoNotStagnate)
{
    const float term = .1f;
    constexpr int blocks = 120000, block = 256;  // 3e7 terms
    maths_float::LongSum sum{0, 0};
    maths_double::LongSum twice{0, 0};
    float naive = 0;
    for (int b = 0; b < blocks; ++b) {
        float partial = 0;
        for (int i = 0; i < block; ++i) partial += term, naive += term;
        sum = maths_float::add_to(sum, partial);
        twice = maths_double::add_to(twice, double(term) * block);
    }
    const double exact = double(term) * block * blocks;
    EXPECT_NEAR((double(sum.high) + double(sum.low)) / exact, 1, 1e-5) << "256 roundings of the block's partial sum at most";
    EXPECT_EQ(twice.high + twice.low, exact) << "in double nothing is lost at all";
    EXPECT_GT(std::abs(double(naive) / exact - 1), .05) << "one float would have stagnated";
}

TEST(HardCases, Row33InAClosedBoxEverythingIsVisibleAlsoFromItsWalls)
{
    const Scene scene = parse_scene("<scene version=\"3.0.0\"><sensor type=\"perspective\"><float name=\"fov\" value=\"40\"/></sensor><shape type=\"cube\"/></scene>", ".", "box");
    const Visibility visibility(scene);
    std::mt19937_64 engine(2);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double half = bounds_of(scene).high.x;
    const auto on_wall = [&] {  // as a virtual ray light ends: on the wall, to the rounding of float
        Vec3 p = half * Vec3(uniform(engine), uniform(engine), uniform(engine));
        p[static_cast<int>(engine() % 3)] = half * (engine() % 2 ? 1 : -1);
        return Vec3(glm::vec3(p));
    };
    int blocked = 0;
    for (int i = 0; i < 200000; ++i) blocked += visibility.occluded(half * Vec3(uniform(engine), uniform(engine), uniform(engine)), on_wall());
    EXPECT_EQ(blocked, 0);
}

TEST(HardCases, Row34ANumberThatIsNotOneIsCountedAndPoisonsNothing)
{
    auto pairs = testing::random_pairs({.eyes = 16, .lights = 30});
    Device device;
    testing::set_flux(pairs, 7, std::numeric_limits<float>::infinity());
    for (const int lanes : {1, 4, 8, 16}) {
        PairStage stage(device, {.lanes = lanes}, pairs.tables);
        for (const double x : testing::gathered(stage, pairs, EyeKind::segments, 100, 256)) EXPECT_TRUE(std::isfinite(x));
        EXPECT_EQ(stage.ledger().not_finite, 16u) << lanes << " lanes";
    }
}

TEST(HardCases, Row35BuildOptionsAreFixedAndAThousandSumsAgreeWithTheHost)
{
    const auto pairs = testing::random_pairs({.eyes = 1008, .lights = 16, .g = .3, .coloured = true});
    const auto golden = testing::host_sums(pairs, EyeKind::segments);
    Device device;
    for (const int lanes : {1, 4, 8, 16}) {
        const PairProgram program{.features = feature_bit::anisotropic | feature_bit::coloured, .lanes = lanes};
        const std::string options = build_options(program);
        for (const char* forbidden : {"fast", "unsafe", "mad", "denorms", "finite"}) EXPECT_EQ(options.find(forbidden), std::string::npos) << options;
        PairStage stage(device, program, pairs.tables);
        const auto ours = testing::gathered(stage, pairs, EyeKind::segments, 1000, 256);
        std::vector<double> errors;
        for (std::size_t i = 0; i < ours.size(); ++i) errors.push_back(std::abs(ours[i] / golden[i] - 1));
        std::sort(errors.begin(), errors.end());
        EXPECT_LT(errors[errors.size() / 2], 1e-6) << lanes << " lanes";
        EXPECT_LT(errors.back(), 1e-3) << lanes << " lanes: pairs that nearly cross magnify the rounding of their ends (row 4)";
    }
}

TEST(HardCases, Row36AnyNumberOfPixelsLightsAndTilesGivesTheSameBytes)
{
    const std::string xml = foggy_scene(0, "5, 5, 5", 1);
    for (const std::uint32_t lights : {1u, 255u, 257u}) {
        const auto whole = beauty(xml, {.lights = lights});
        EXPECT_EQ(beauty(xml, {.lights = lights, .tile_pairs = 1}), whole);
        EXPECT_EQ(beauty(xml, {.lights = lights, .tile_pairs = 5000}), whole);
    }
    const auto dark = beauty(foggy_scene(0, "0, 0, 0", 1));
    EXPECT_EQ(dark[0], Rgb(0)) << "no virtual light at all";
}

}  // namespace
}  // namespace tyndall
