// Virtual lights and eye segments in grids: clipped to what there is, dimmed by what lies before.
#include <cstring>

#include "../transport/statistics.hpp"
#include "eye_tracing/eye_tracing.hpp"
#include "grid_scene.hpp"
#include "light_tracing/light_tracing.hpp"
#include "transport/camera.hpp"
#include "volumes/medium_line.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

/// Two blots of smoke in one container, a lamp beside it.
struct Smoke {
    BuiltScene s;
    int volume, smoke;
    Vec3 lamp{-1, .1, .05};

    Smoke()
        : volume(add_volume(s, {6, 2, 2}, glm::translate(Mat4(1), Vec3(-.5)), [](int, const glm::ivec3& v) { return v.x == 1 || v.x == 4 ? 2. : 0.; })), smoke(add_grid_medium(s, volume, {.5, 1, 2}, Rgb(.8)))
    {
        s.container(Vec3(-.8), Vec3(.8), {.interior = smoke});
        s.point(lamp, Rgb(1));
        s.camera({-1.5, .05, 0}, {1, 0, 0}, 4, .3);
    }
};

/// What the tests look at of a virtual light, whatever its technique.
std::vector<LightPathSegment>& deposited()
{
    static std::vector<LightPathSegment> all;
    return all;
}
LightTechnique recorder()
{
    return {.name = "recorder", .title = "recorder", .record_bytes = 1, .unbiased = true, .deposit = [](const LightPathSegment& segment, std::vector<std::byte>& records) {
                deposited().push_back(segment), records.push_back({});
            }};
}

std::vector<LightPathSegment> lights_of(const Scene& scene, const LightTracingSettings& settings)
{
    deposited().clear();
    const Visibility visibility(scene, 1);
    visibility.in_arena([&] { trace_lights(scene, visibility, recorder(), settings); });
    return deposited();
}

double plain_depth(const Smoke& smoke, int channel, const Vec3& from, const Vec3& to)
{
    const double length = glm::length(to - from);
    if (length == 0) return 0;
    return smoke.s.scene.media[std::size_t(smoke.smoke)].sigma_t[channel] * plain_integral(smoke.s.scene.volumes[std::size_t(smoke.volume)], 0, from, (to - from) / length, 0, length);
}

TEST(GridLights, AreClippedToTheSmokeAndDimmedByWhatLiesBefore)
{
    const Smoke smoke;
    const auto lights = lights_of(smoke.s.scene, {.paths = 500, .light_segments = LightSegments::first});
    ASSERT_GT(lights.size(), 50u);
    for (const LightPathSegment& light : lights) {
        const Vec3 end = light.origin + light.length * light.direction;
        for (const Vec3& p : {light.origin, end}) EXPECT_LT(largest(glm::abs(p)), .5 + 1e-6) << "ends in the box";
        EXPECT_NEAR(plain_depth(smoke, 1, smoke.lamp, light.origin), 0, 1e-4) << "begins where the smoke does";
        const Vec3 wall = end + 2. * light.direction;
        EXPECT_NEAR(plain_depth(smoke, 1, end, wall), 0, 2e-4) << "ends where the smoke does";
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(light.flux[c], 4 * pi / 500, 1e-9) << "nothing dims the first light";
    }
}

/// A light in a second stretch of the medium carries the transmittance of the first.
TEST(GridLights, BehindAFirstStretchCarryItsTransmittance)
{
    Smoke smoke;
    smoke.s.container({-.05, -.7, -.7}, {.05, .7, .7}, {.interior = vacuum, .exterior = smoke.smoke});  // a gap between the two blots
    const auto lights = lights_of(smoke.s.scene, {.paths = 500, .light_segments = LightSegments::first});
    int behind = 0;
    for (const LightPathSegment& light : lights) {
        if (light.origin.x < 0) continue;
        ++behind;
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(light.flux[c], 4 * pi / 500 * std::exp(-plain_depth(smoke, c, smoke.lamp, light.origin)), 2e-4 * 4 * pi / 500);
    }
    EXPECT_GT(behind, 20);
}

TEST(GridLights, ShortOnesEndAtTheirCollision)
{
    const Smoke smoke;
    const auto lights = lights_of(smoke.s.scene, {.paths = 2000, .light_segments = LightSegments::first, .segment_length = SegmentLength::short_});
    Mean passed;
    for (const LightPathSegment& light : lights) {
        EXPECT_TRUE(light.is_short);
        EXPECT_NEAR(sum(light.channel), 1, 1e-12) << "no smoke lies before";
        const Vec3 end = light.origin + light.length * light.direction;
        // The share of light that gets to the end of the smoke on this ray, in the balance of channels.
        double through = 0;
        for (int c = 0; c < 3; ++c) through += std::exp(-plain_depth(smoke, c, light.origin, light.origin + 2. * light.direction)) / 3;
        passed.add((plain_depth(smoke, 1, end, end + 2. * light.direction) < 1e-4 ? 1 : 0) - through);
    }
    ASSERT_GT(lights.size(), 200u);
    expect_mean(passed, 0, "as many as pass reach the end");
}

TEST(GridEyeSegments, AreClippedToTheSmokeAndDimmedByWhatLiesBefore)
{
    Smoke smoke;
    smoke.s.container({-.05, -.7, -.7}, {.05, .7, .7}, {.interior = vacuum, .exterior = smoke.smoke});
    const Visibility visibility(smoke.s.scene, 1);
    const EyeRecords eyes = trace_eyes(smoke.s.scene, visibility, {.seed = 3, .pass = 0});
    ASSERT_EQ(eyes.segments.size(), 32u) << "two blots for each of 16 pixels";
    for (const EyeSegment& segment : eyes.segments) {
        const Vec3 from = sample_camera(smoke.s.scene.camera, int(segment.pixel % 4), int(segment.pixel / 4), 3, 0).ray.origin;
        const Vec3 origin(segment.origin_x, segment.origin_y, segment.origin_z), direction(segment.direction_x, segment.direction_y, segment.direction_z);
        EXPECT_LT(std::abs(origin.x), .5 + 1e-6);
        EXPECT_NEAR(segment.length, 1. / 3 * 1.5 / (1 * direction.x), .2) << "a blot with its slopes";
        const float throughput[] = {segment.throughput_r, segment.throughput_g, segment.throughput_b};
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(throughput[c], std::exp(-plain_depth(smoke, c, from, origin)), 3e-4);
        EXPECT_NEAR(plain_depth(smoke, 1, origin + double(segment.length) * direction, Vec3(origin.x < 0 ? 0 : 1, origin.y, origin.z)), 0, 2e-2);
    }
}

}  // namespace
