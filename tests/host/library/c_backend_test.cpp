/// The connections alone through the C interface give the bytes of the C++ one.
#include <gmock/gmock.h>

#include <memory>

#include "tyndall/backend.hpp"
#include "tyndall/tyndall.h"

using namespace tyndall::api;

namespace {

const double sigma_t[]{.5, 1, 2}, albedo[]{.9, .8, .7}, low[]{-1, -1, -1}, high[]{1, 1, 1};
const tyndall_ray_light ray{{-.5f, -.5f, 0}, .8f, {1, 0, 0}, 0, {1, 2, 3}, 0};
const tyndall_point_light point{{.2f, -.5f, 0}, 0, {0, 1, 0}, 0, {1, 2, 3}, 0};
const tyndall_eye_segment segment{{-.5f, .3f, .25f}, 1, {1, 0, 0}, 0, {1, .5f, .25f}, 0};
const tyndall_eye_point surface{{.1f, .8f, 0}, 0, {0, -1, 0}, 0, {0, -1, 0}, 0, {.3f, .2f, .1f}, 0};
const tyndall_connect how{5, 3, 0};

/// Blocks what starts left of x = 0; counts, and ends the call if it is told to.
struct Asked {
    std::size_t segments = 0;
    int answer = 0;
};
int left(void* user, const tyndall_shadow_segment* segments, size_t count, uint8_t* blocked)
{
    static_cast<Asked*>(user)->segments += count;
    for (size_t i = 0; i < count; ++i) blocked[i] = segments[i].from[0] < 0;
    return static_cast<Asked*>(user)->answer;
}

struct Destroyer {
    void operator()(tyndall_backend* backend) const { tyndall_backend_destroy(backend); }
    void operator()(tyndall_description* description) const { tyndall_description_destroy(description); }
    void operator()(tyndall_settings* settings) const { tyndall_settings_destroy(settings); }
};

class CBackend : public testing::Test {
protected:
    CBackend()
    {
        tyndall_description* media_made = nullptr;
        tyndall_settings* settings_made = nullptr;
        tyndall_backend* backend_made = nullptr;
        EXPECT_EQ(tyndall_description_create(&media_made), TYNDALL_OK);
        EXPECT_EQ(tyndall_settings_create(&settings_made), TYNDALL_OK);
        media.reset(media_made), settings.reset(settings_made);
        EXPECT_EQ(tyndall_add_medium(media.get(), sigma_t, albedo, .3, nullptr), TYNDALL_OK);
        EXPECT_EQ(tyndall_settings_set(settings.get(), "no-selftest", "true"), TYNDALL_OK);
        EXPECT_EQ(tyndall_backend_create(media.get(), settings.get(), low, high, left, &asked, &backend_made), TYNDALL_OK) << tyndall_last_error();
        backend.reset(backend_made);
    }

    Backend cpp() const
    {
        return Backend({.media = {{.sigma_t = {.5, 1, 2}, .albedo = {.9, .8, .7}, .phase = {.type = Phase::Type::henyey_greenstein, .g = .3}}},
                        .occluded = [](std::span<const ShadowSegment> s, std::span<std::uint8_t> blocked) { for (std::size_t i = 0; i < s.size(); ++i) blocked[i] = s[i].from[0] < 0; },
                        .selftest = false});
    }

    Asked asked;
    std::unique_ptr<tyndall_description, Destroyer> media;
    std::unique_ptr<tyndall_settings, Destroyer> settings;
    std::unique_ptr<tyndall_backend, Destroyer> backend;
};

TEST_F(CBackend, GivesTheBytesOfTheCppInterface)
{
    Backend other = cpp();
    const RayLight ray_cpp{.origin = {-.5f, -.5f, 0}, .length = .8f, .direction = {1, 0, 0}, .flux = {1, 2, 3}};
    const PointLight point_cpp{.position = {.2f, -.5f, 0}, .direction = {0, 1, 0}, .power = {1, 2, 3}};
    const EyeSegment segment_cpp{.origin = {-.5f, .3f, .25f}, .length = 1, .direction = {1, 0, 0}, .throughput = {1, .5f, .25f}};
    const EyePoint surface_cpp{.position = {.1f, .8f, 0}, .medium = 0, .normal = {0, -1, 0}, .facing = {0, -1, 0}, .throughput = {.3f, .2f, .1f}};
    const ConnectOptions options{.seed = 5, .rounds = 3};
    std::vector<float> radiance(3), variance(3);
    const auto expect = [&](tyndall_status status, const Estimates& wanted, const char* what) {
        EXPECT_EQ(status, TYNDALL_OK) << tyndall_last_error();
        EXPECT_EQ(radiance, wanted.radiance) << what;
        EXPECT_EQ(variance, wanted.variance) << what;
        EXPECT_GT(wanted.radiance[0], 0) << what;
    };
    const std::span<const RayLight> rays(&ray_cpp, 1);
    const std::span<const PointLight> lights(&point_cpp, 1);
    const std::span<const EyeSegment> segments(&segment_cpp, 1);
    const std::span<const EyePoint> points(&surface_cpp, 1);
    expect(tyndall_rays_to_segments(backend.get(), &ray, 1, &segment, 1, &how, radiance.data(), variance.data()), other.connect(rays, segments, options), "rays to segments");
    expect(tyndall_rays_to_points(backend.get(), &ray, 1, &surface, 1, &how, radiance.data(), variance.data()), other.connect(rays, points, options), "rays to points");
    expect(tyndall_points_to_segments(backend.get(), &point, 1, &segment, 1, &how, radiance.data(), variance.data()), other.connect(lights, segments, options), "points to segments");
    expect(tyndall_points_to_points(backend.get(), &point, 1, &surface, 1, &how, radiance.data(), variance.data()), other.connect(lights, points, options), "points to points");
    EXPECT_EQ(asked.segments, 12u);
}

TEST_F(CBackend, RefusesWhatMakesNoSense)
{
    float radiance[3];
    EXPECT_EQ(tyndall_rays_to_segments(backend.get(), nullptr, 1, &segment, 1, nullptr, radiance, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_rays_to_segments(backend.get(), &ray, 1, &segment, 1, nullptr, nullptr, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_rays_to_segments(nullptr, &ray, 1, &segment, 1, nullptr, radiance, nullptr), TYNDALL_USAGE_ERROR);
    asked.answer = 1;
    EXPECT_EQ(tyndall_rays_to_segments(backend.get(), &ray, 1, &segment, 1, nullptr, radiance, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_THAT(tyndall_last_error(), testing::HasSubstr("ended the call"));
    tyndall_backend* none = backend.get();
    EXPECT_EQ(tyndall_backend_create(nullptr, nullptr, low, high, nullptr, nullptr, &none), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(none, nullptr);
    tyndall_backend_destroy(nullptr);
}

}  // namespace
