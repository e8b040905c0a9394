/// Another driver's device beside the default one: the same values within 1e-5, the same image. TYNDALL_OTHER_DEVICE names it; tests/rusticl.sh sets it to Mesa's rusticl on llvmpipe.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "../host/pipeline/whole_renderer.hpp"
#include "kernels/shared/host_features.hpp"
#include "tests/device/random_pairs.hpp"

namespace tyndall::test {
namespace {

using testing::RandomPairs;

constexpr int lanes = 1;  ///< llvmpipe makes vectors of its own, and compiles programs of four lanes for minutes

class OtherDevice : public ::testing::Test {
protected:
    void SetUp() override
    {
        const char* named = std::getenv("TYNDALL_OTHER_DEVICE");
        if (!named) GTEST_SKIP() << "TYNDALL_OTHER_DEVICE names no device; tests/rusticl.sh does";
        name = named;
    }
    std::string name;
};

PairProgram program(EyeKind kind, std::uint32_t features) { return {.eyes = kind, .features = features, .lanes = lanes}; }

/// Values of both devices: finite, not all zero, and within 1e-5 of each other or of a thousandth of the largest (values that nearly cancel).
void expect_agreement(const std::vector<double>& a, const std::vector<double>& b)
{
    ASSERT_EQ(a.size(), b.size());
    double largest = 0;
    for (const double value : a) largest = std::max(largest, std::abs(value));
    EXPECT_GT(largest, 0);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-5 * std::max(std::abs(a[i]), 1e-3 * largest)) << i;
}

std::vector<double> sums_on(const std::string& device_name, const RandomPairs& pairs, EyeKind kind, std::uint32_t features)
{
    Device device(device_name);
    PairStage stage(device, program(kind, features), pairs.tables);
    return testing::gathered(stage, pairs, kind, 1000, 1024);
}

TEST_F(OtherDevice, GathersTheSameSums)
{
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points})
        expect_agreement(sums_on("", testing::random_pairs({.eyes = 16, .lights = 21}), kind, 0), sums_on(name, testing::random_pairs({.eyes = 16, .lights = 21}), kind, 0));
    const RandomPairs coloured = testing::random_pairs({.eyes = 16, .lights = 21, .g = .55, .coloured = true, .short_lights = true});
    const std::uint32_t mask = feature_bit::anisotropic | feature_bit::coloured | feature_bit::short_lights;
    expect_agreement(sums_on("", coloured, EyeKind::segments, mask), sums_on(name, coloured, EyeKind::segments, mask));
}

std::vector<double> contributions_on(const std::string& device_name, const RandomPairs& pairs)
{
    Device device(device_name);
    PairStage stage(device, program(EyeKind::segments, feature_bit::occluders), pairs.tables);
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
    expect_agreement(contributions_on("", pairs), contributions_on(name, pairs));
}

TEST_F(OtherDevice, RendersTheSameImage)
{
    const Scene scene = scene_of(medium("fog", Rgb(1), Rgb(.8), 0) + container(Vec3(-.5), Vec3(.5), "fog") + point_light({.5, 1, .5}, Rgb(2)) + sensor({.origin = {.3, .6, 3}, .pixels = 16}));
    RenderSettings settings{.passes = 2, .lights = 50, .lanes = lanes, .selection = Selection::all, .selftest = false};
    const std::vector<Rgb> here = render(scene, settings).film.beauty();
    settings.device = name;
    const std::vector<Rgb> there = render(scene, settings).film.beauty();
    ASSERT_EQ(here.size(), there.size());
    Rgb squares(0), differences(0);
    for (std::size_t i = 0; i < here.size(); ++i) squares += here[i] * here[i], differences += (here[i] - there[i]) * (here[i] - there[i]);
    // The same random numbers: far below any standard error, so z-equal a fortiori.
    EXPECT_GT(squares.g, 0);
    EXPECT_LT(std::sqrt(differences.g / squares.g), 1e-5);
}

}  // namespace
}  // namespace tyndall::test
