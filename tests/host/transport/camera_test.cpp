#include "transport/camera.hpp"

#include "built_scene.hpp"
#include "statistics.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

Camera straight()
{
    BuiltScene s;
    s.camera({1, 2, 3}, {0, 0, 1}, 10, 1.2, 4);
    s.scene.camera.height = 20;
    s.scene.camera.near_clip = .5, s.scene.camera.far_clip = 8;
    return s.scene.camera;
}

TEST(CameraRay, CentreLooksForwardAndCornersSpanTheFieldOfView)
{
    const Camera camera = straight();
    const CameraSample centre = camera_ray(camera, {5, 10});
    EXPECT_NEAR(glm::length(centre.ray.direction - Vec3(0, 0, 1)), 0, 1e-15);
    EXPECT_EQ(centre.medium, 4);
    const double tangent = std::tan(.6);
    // looking along +z with y up, the image's right is -x; the film's first row is the top
    const Vec3 top_left = glm::normalize(Vec3(tangent, 2 * tangent, 1)), bottom_right = glm::normalize(Vec3(-tangent, -2 * tangent, 1));
    EXPECT_NEAR(glm::length(camera_ray(camera, {0, 0}).ray.direction - top_left), 0, 1e-15);
    EXPECT_NEAR(glm::length(camera_ray(camera, {10, 20}).ray.direction - bottom_right), 0, 1e-15);
}

TEST(CameraRay, RunsFromTheNearPlaneToTheFarPlane)
{
    const CameraSample corner = camera_ray(straight(), {0, 0});
    EXPECT_NEAR(corner.ray.origin.z, 3.5, 1e-14);
    EXPECT_NEAR((corner.ray.origin + corner.ray.t_max * corner.ray.direction).z, 11, 1e-13);
    EXPECT_NEAR(glm::length(corner.ray.origin - Vec3(1, 2, 3)), corner.near, 1e-14);
}

TEST(CameraRay, CropAndPrincipalPointMoveTheFilm)
{
    Camera camera = straight();
    camera.crop_x = 3, camera.crop_y = 7, camera.crop_width = 2, camera.crop_height = 5;
    RandomSequence random = numbers(1);
    for (int i = 0; i < 100; ++i) {
        const CameraSample s = sample_camera(camera, 1, 2, random);
        EXPECT_TRUE(s.film.x >= 4 && s.film.x < 5 && s.film.y >= 9 && s.film.y < 10);
    }
    const Vec3 before = camera_ray(camera, {6, 10}).ray.direction;
    camera.principal_x = .1;
    EXPECT_NEAR(glm::length(camera_ray(camera, {5, 10}).ray.direction - before), 0, 1e-15);
}

TEST(CameraRay, SamplesOfOnePassAreTheSameForEveryTechnique)
{
    const Camera camera = straight();
    EXPECT_EQ(sample_camera(camera, 2, 3, 5, 6).film, sample_camera(camera, 2, 3, 5, 6).film);
    EXPECT_NE(sample_camera(camera, 2, 3, 5, 6).film, sample_camera(camera, 2, 3, 5, 7).film);
    EXPECT_NE(sample_camera(camera, 2, 3, 5, 6).film - Vec2(2, 3), sample_camera(camera, 3, 2, 5, 6).film - Vec2(3, 2));
}

TEST(CameraRay, GaussianFilterIsSampledByItsWeight)
{
    Camera camera = straight();
    camera.filter = {.type = Filter::Type::gaussian, .stddev = .5};
    const auto weight = [](long double x) { return std::exp(-2 * x * x) - std::exp(-8.0L); };
    constexpr int bins = 16;
    std::vector<double> observed(bins, 0.0), expected;
    const long double total = integrate(weight, -2, 2, 1e-12L);
    constexpr int draws = 100000;
    for (int i = 0; i < bins; ++i) expected.push_back(draws * double(integrate(weight, -2 + .25L * i, -1.75L + .25L * i, 1e-12L) / total));
    RandomSequence random = numbers(2);
    Mean product;
    for (int i = 0; i < draws; ++i) {
        const Vec2 offset = sample_camera(camera, 4, 4, random).film - Vec2(4.5, 4.5);
        ASSERT_LE(std::abs(offset.x), 2);
        ++observed[std::min(int((offset.x + 2) * 4), bins - 1)];
        product.add(offset.x * offset.y);
    }
    EXPECT_GT(chi_square_p(observed, expected), false_alarm_rate);
    expect_mean(product, 0, "x and y are independent");
}

}  // namespace
