/// The connections alone through the C interface give the bytes of the C++ one.
#include <gmock/gmock.h>

#include <cmath>
#include <memory>

#include "support/environment_variable.hpp"
#include "tyndall/backend.hpp"
#include "tyndall/tyndall.h"

using namespace tyndall;
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

// Half of the box is fog: its planes, and what passes along a segment by the same planes.
const double planes[6][4]{{2, 0, 0, 2}, {-1, 0, 0, 1}, {0, 1, 0, .5}, {0, -1, 0, 1}, {0, 0, 1, 1}, {0, 0, -1, 1}};
const tyndall_eye_point outside{{.1f, .9f, 0}, TYNDALL_NO_MEDIUM, {0, -1, 0}, 0, {0, -1, 0}, 0, {.3f, .2f, .1f}, 0};

int through_half(void* user, const tyndall_shadow_segment* segments, size_t count, float* passed)
{
    static_cast<Asked*>(user)->segments += count;
    for (size_t i = 0; i < count; ++i) {
        const double *a = segments[i].from, *b = segments[i].to, length = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        const double inside = a[1] > .5 ? (.5 - b[1]) / (a[1] - b[1]) : 1;
        for (int c = 0; c < 3; ++c) passed[3 * i + size_t(c)] = static_cast<float>(std::exp(-sigma_t[c] * length * inside));
    }
    return static_cast<Asked*>(user)->answer;
}

TEST_F(CBackend, ContainersAreThoseOfTheCppInterface)
{
    ASSERT_EQ(tyndall_add_container(media.get(), 0, planes[0], 6), TYNDALL_OK) << tyndall_last_error();
    tyndall_backend* made = nullptr;
    ASSERT_EQ(tyndall_backend_create(media.get(), settings.get(), low, high, nullptr, nullptr, &made), TYNDALL_OK) << tyndall_last_error();
    const std::unique_ptr<tyndall_backend, Destroyer> contained(made);
    Container container{.medium = 0};
    for (const auto& p : planes) container.planes.push_back({p[0], p[1], p[2], p[3]});
    Backend cpp_contained({.media = {{.sigma_t = {.5, 1, 2}, .albedo = {.9, .8, .7}, .phase = {.type = Phase::Type::henyey_greenstein, .g = .3}}}, .containers = {container}, .selftest = false});
    const RayLight light{.origin = {-.5f, -.5f, 0}, .length = .8f, .direction = {1, 0, 0}, .flux = {1, 2, 3}};
    const EyePoint eye{.position = {.1f, .9f, 0}, .normal = {0, -1, 0}, .facing = {0, -1, 0}, .throughput = {.3f, .2f, .1f}};
    float radiance[3], variance[3];
    ASSERT_EQ(tyndall_rays_to_points(contained.get(), &ray, 1, &outside, 1, &how, radiance, variance), TYNDALL_OK) << tyndall_last_error();
    const Estimates wanted = cpp_contained.connect(std::span(&light, 1), std::span(&eye, 1), {.seed = 5, .rounds = 3});
    EXPECT_THAT(wanted.radiance, testing::ElementsAreArray(radiance));
    EXPECT_THAT(wanted.variance, testing::ElementsAreArray(variance));
    // The same medium by the caller's transmittance: other kernels, the same estimate up to their rounding.
    tyndall_description* bare = nullptr;
    ASSERT_EQ(tyndall_description_create(&bare), TYNDALL_OK);
    const std::unique_ptr<tyndall_description, Destroyer> without(bare);
    ASSERT_EQ(tyndall_add_medium(bare, sigma_t, albedo, .3, nullptr), TYNDALL_OK);
    ASSERT_EQ(tyndall_backend_create_passing(bare, settings.get(), low, high, through_half, &asked, &made), TYNDALL_OK) << tyndall_last_error();
    const std::unique_ptr<tyndall_backend, Destroyer> passing(made);
    float passed[3];
    ASSERT_EQ(tyndall_rays_to_points(passing.get(), &ray, 1, &outside, 1, &how, passed, nullptr), TYNDALL_OK) << tyndall_last_error();
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(passed[c], radiance[c], 1e-4f * radiance[c]) << c;
    EXPECT_EQ(asked.segments, 3u);
    asked.answer = 1;
    EXPECT_EQ(tyndall_rays_to_points(passing.get(), &ray, 1, &outside, 1, &how, passed, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_THAT(tyndall_last_error(), testing::HasSubstr("transmittance ended the call"));
}

TEST_F(CBackend, ContainersAndTransmittanceExcludeEachOther)
{
    tyndall_backend* made = nullptr;
    EXPECT_EQ(tyndall_add_container(media.get(), 1, planes[0], 6), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_add_container(media.get(), 0, nullptr, 6), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_backend_create_passing(media.get(), settings.get(), low, high, nullptr, nullptr, &made), TYNDALL_USAGE_ERROR);
    EXPECT_THAT(tyndall_last_error(), testing::HasSubstr("passed is NULL"));
    ASSERT_EQ(tyndall_add_container(media.get(), 0, planes[0], 6), TYNDALL_OK);
    EXPECT_EQ(tyndall_backend_create_passing(media.get(), settings.get(), low, high, through_half, &asked, &made), TYNDALL_USAGE_ERROR);
    EXPECT_THAT(tyndall_last_error(), testing::HasSubstr("exclude each other"));
    EXPECT_EQ(made, nullptr);
}

// The selftest cannot be remembered where there is no folder for it, which is a warning for whoever listens.
TEST_F(CBackend, WarningsReachTheLog)
{
    const test::EnvironmentVariable no_cache("XDG_CACHE_HOME", "/proc/no such folder");
    std::vector<std::string> heard;
    const tyndall_log_callback listen = [](void* user, int level, const char* text) { static_cast<std::vector<std::string>*>(user)->push_back(std::to_string(level) + " " + text); };
    tyndall_settings* with_selftest = nullptr;
    ASSERT_EQ(tyndall_settings_create(&with_selftest), TYNDALL_OK);
    const std::unique_ptr<tyndall_settings, Destroyer> listening(with_selftest);
    tyndall_settings_callbacks(with_selftest, nullptr, listen, &heard);
    tyndall_backend* made = nullptr;
    ASSERT_EQ(tyndall_backend_create(media.get(), with_selftest, low, high, nullptr, nullptr, &made), TYNDALL_OK) << tyndall_last_error();
    const std::unique_ptr<tyndall_backend, Destroyer> checked(made);
    float radiance[3];
    ASSERT_EQ(tyndall_points_to_points(checked.get(), &point, 1, &surface, 1, &how, radiance, nullptr), TYNDALL_OK) << tyndall_last_error();
    EXPECT_THAT(heard, testing::Contains(testing::StartsWith("1 ")));
}

TEST_F(CBackend, ErrorsReachTheLogToo)
{
    std::vector<std::string> heard;
    const tyndall_log_callback listen = [](void* user, int level, const char* text) { static_cast<std::vector<std::string>*>(user)->push_back(std::to_string(level) + " " + text); };
    tyndall_settings_callbacks(settings.get(), nullptr, listen, &heard);
    tyndall_backend* made = nullptr;
    ASSERT_EQ(tyndall_backend_create(media.get(), settings.get(), low, high, nullptr, nullptr, &made), TYNDALL_OK) << tyndall_last_error();
    const std::unique_ptr<tyndall_backend, Destroyer> listening(made);
    float radiance[3];
    const tyndall_connect no_rounds{.seed = 1, .rounds = 0, .lights_per_eye = 0};
    ASSERT_EQ(tyndall_points_to_points(listening.get(), &point, 1, &surface, 1, &no_rounds, radiance, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_THAT(heard, testing::ElementsAre(std::string("2 ") + tyndall_last_error()));
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
