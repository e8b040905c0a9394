/// Candidates of a region where a pass has more lights than a region looks at: every light still counts once on average.
#include "pipeline/region_lights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "lights/light_technique.hpp"

using namespace tyndall;

namespace {

/// Lights of equal power side by side, numbered by their depth field.
VirtualLights row_of_lights(std::uint32_t count)
{
    const LightTechnique& technique = *technique_of(Method::vrl);
    VirtualLights lights{{}, count};
    for (std::uint32_t i = 0; i < count; ++i)
        technique.deposit({.origin = {.1 * i, 0, 0}, .direction = {0, 1, 0}, .length = 1, .medium = 0, .flux = Rgb(1), .depth = static_cast<int>(i), .is_short = false, .channel = Rgb(1)}, lights.records);
    return lights;
}

MediaTables fog()
{
    MediumRecord medium{};
    medium.sigma_t_r = medium.sigma_t_g = medium.sigma_t_b = .5f, medium.sigma_s_r = medium.sigma_s_g = medium.sigma_s_b = .4f, medium.density_grid = NO_GRID;
    return {.media = {medium}, .containers = {}, .planes = {}};
}

TEST(RegionLights, CountEveryLightOnceOnAverageOverTheParts)
{
    constexpr std::uint32_t count = 100;
    constexpr int repeats = 4000;
    const VirtualLights lights = row_of_lights(count);
    Device device;
    PairStage stage(device, {.eyes = EyeKind::segments, .lanes = device.info().default_lanes, .selection = true}, fog());
    EyeSegment eye{};
    eye.origin_z = -1, eye.direction_x = 1, eye.length = 10, eye.throughput_r = eye.throughput_g = eye.throughput_b = 1;
    const std::vector<EyeSegment> eyes(16, eye);
    std::vector<EyePlace> places;
    for (std::uint32_t i = 0; i < 16; ++i) places.push_back({i, 0, 0, 0});
    const EyeBlocks all = block_eyes(places, {.width = 16, .size = 16});
    const SelectionPlan plan{.lights = count, .chosen = true, .slots = 4, .candidates = 8, .offered = 30};
    std::vector<double> sum(count), squares(count);
    std::size_t record = lights.records.size() / count, most = 0;
    for (std::uint64_t repeat = 0; repeat < repeats; ++repeat) {
        RegionLights region(stage, lights, plan, 0xffffffffu, repeat * 0x9e3779b97f4a7c15ull);
        ASSERT_TRUE(region.wanted());
        const LightBatch batch = region.of(std::span<const EyeSegment>(eyes), all, 0, all.blocks.size());
        ASSERT_EQ(batch.weights.size(), batch.count);
        most = std::max<std::size_t>(most, batch.count);
        for (std::uint32_t i = 0; i < batch.count; ++i) {
            float x = 0;
            std::memcpy(&x, batch.records.data() + i * record, sizeof x);   // the origin's first coordinate is the light's number, in tenths
            const auto number = static_cast<std::size_t>(std::lround(10 * x));
            sum[number] += double(batch.weights[i]), squares[number] += double(batch.weights[i]) * double(batch.weights[i]);
        }
    }
    EXPECT_LE(most, 8u);
    double chi = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double mean = sum[i] / repeats, variance = squares[i] / repeats - mean * mean, z = (mean - 1) / std::sqrt(variance / repeats);
        EXPECT_LT(std::abs(z), 5) << "light " << i << ": " << mean;
        chi += z * z;
    }
    EXPECT_LT(chi, 100 + 5 * std::sqrt(200.));
}

TEST(RegionLights, AreNotAskedForWhereLightsAreFew)
{
    const VirtualLights lights = row_of_lights(16);
    Device device;
    PairStage stage(device, {.eyes = EyeKind::segments, .lanes = device.info().default_lanes, .selection = true}, fog());
    EXPECT_FALSE(RegionLights(stage, lights, {.candidates = 8}, 1, 1).wanted());
    EXPECT_FALSE(RegionLights(stage, lights, {.candidates = 0}, 1, 1).wanted());
    EXPECT_TRUE(RegionLights(stage, lights, {.candidates = 7}, 1, 1).wanted());
}

}  // namespace
