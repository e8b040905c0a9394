#include "transport/camera.hpp"

#include <cmath>

#include <boost/math/special_functions/erf.hpp>

namespace tyndall {
namespace {

/// Offset in pixels with density proportional to exp(-x^2 / 2 sigma^2) - exp(-8) within 4 sigma, the filter of Mitsuba: a truncated normal,
/// thinned.
double sample_gaussian(double sigma, RandomSequence& random)
{
    constexpr double radius = 4;  // in sigma
    const double inside = std::erf(radius / std::sqrt(2.0));
    for (;;) {
        const double x = std::sqrt(2.0) * boost::math::erf_inv((2 * random.next() - 1) * inside);
        if (random.next() >= std::exp(.5 * (x * x - radius * radius))) return sigma * x;
    }
}

Vec2 sample_filter(const Filter& filter, RandomSequence& random)
{
    if (filter.type == Filter::Type::box) return random.next2();
    const double x = sample_gaussian(filter.stddev, random);
    return {.5 + x, .5 + sample_gaussian(filter.stddev, random)};
}

}  // namespace

CameraSample camera_ray(const Camera& camera, const Vec2& film)
{
    const double tangent = std::tan(.5 * camera.fov_x), width = camera.width, height = camera.height;
    const Vec2 at(film.x / width + camera.principal_x, film.y / height + camera.principal_y);
    const Vec3 local((1 - 2 * at.x) * tangent, (1 - 2 * at.y) * tangent * height / width, 1);
    const double per_depth = glm::length(local);  // distance along the ray per distance along the axis
    const Vec3 direction = glm::normalize(glm::dmat3(camera.to_world) * local);
    const double near = camera.near_clip * per_depth;
    return {.ray = {.origin = Vec3(camera.to_world[3]) + near * direction,
                    .direction = direction,
                    .t_max = (camera.far_clip - camera.near_clip) * per_depth},
            .medium = camera.medium,
            .film = film,
            .near = near};
}

CameraSample sample_camera(const Camera& camera, int x, int y, RandomSequence& random)
{
    const Vec2 corner(camera.crop_x + x, camera.crop_y + y);
    return camera_ray(camera, corner + sample_filter(camera.filter, random));
}

CameraSample sample_camera(const Camera& camera, int x, int y, std::uint64_t seed, std::uint64_t pass)
{
    RandomSequence random(seed, pass, RandomStream::camera, static_cast<std::uint64_t>(y) * camera.crop_width + x);
    return sample_camera(camera, x, y, random);
}

}  // namespace tyndall
