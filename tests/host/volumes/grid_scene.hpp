#pragma once
/// Media in grids for scenes built in memory, and what the grids hold, by sums of hat functions that share no code with kernels/.
#include <functional>

#include "../transport/built_scene.hpp"

namespace tyndall::test {

/// Adds a volume; `fill` gives the value of voxel (x, y, z) of a channel.
inline int add_volume(BuiltScene& s, const glm::ivec3& size, const Mat4& to_world, const std::function<double(int channel, const glm::ivec3&)>& fill, int channels = 1)
{
    Volume volume{.name = "grid", .size_x = size.x, .size_y = size.y, .size_z = size.z, .channels = channels, .to_world = to_world};
    for (int c = 0; c < channels; ++c)
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) volume.values.push_back(float(fill(c, {x, y, z})));
    s.scene.volumes.push_back(volume);
    return int(s.scene.volumes.size()) - 1;
}

inline int add_grid_medium(BuiltScene& s, int density, const Rgb& sigma_t, const Rgb& albedo, double g = 0)
{
    const int medium = s.medium(sigma_t, albedo, g);
    s.scene.media[std::size_t(medium)].density = density;
    return medium;
}

/// Half of the voxels empty, the others anything: the same for the same numbers.
inline double blotches(int channel, const glm::ivec3& voxel)
{
    const unsigned hash = unsigned(voxel.x * 73856093) ^ unsigned(voxel.y * 19349663) ^ unsigned(voxel.z * 83492791) ^ unsigned(channel * 2654435761u);
    const double u = double((hash * 2246822519u) >> 8 & 0xffff) / 65536;
    return u < .5 ? 0 : 4 * u - 1;
}

/// Around the origin, as wide as `extent`, turned about two axes.
inline Mat4 turned_box(const Vec3& extent)
{
    const Mat4 turned = glm::rotate(glm::rotate(Mat4(1), .4, Vec3(0, 1, 0)), -.3, Vec3(1, 0, 0));
    return glm::translate(glm::scale(turned, extent), Vec3(-.5));
}

/// The value of a volume at a point of render space: 0 outside of its box.
inline double plain_value(const Volume& volume, int channel, const Vec3& point)
{
    const Vec3 unit(glm::inverse(volume.to_world) * glm::dvec4(point, 1));
    const glm::ivec3 size(volume.size_x, volume.size_y, volume.size_z);
    for (int k = 0; k < 3; ++k)
        if (unit[k] < 0 || unit[k] > 1) return 0;
    double sum = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                double share = 1;
                for (int k = 0; k < 3; ++k) {
                    const double at = std::clamp(unit[k] * size[k], .5, size[k] - .5);
                    share *= std::max(0.0, 1 - std::abs(at - glm::ivec3(x, y, z)[k] - .5));
                }
                if (share > 0) sum += share * volume.values[std::size_t(((channel * size.z + z) * size.y + y) * size.x + x)];
            }
    return sum;
}

/// Integral of the value over origin + t direction from t0 to t1, by the midpoint rule: error below (t1 - t0) / steps^2 x curvature.
inline double plain_integral(const Volume& volume, int channel, const Vec3& origin, const Vec3& direction, double t0, double t1, int steps = 20000)
{
    double sum = 0;
    for (int i = 0; i < steps; ++i) sum += plain_value(volume, channel, origin + (t0 + (i + .5) / steps * (t1 - t0)) * direction);
    return sum * (t1 - t0) / steps;
}

}  // namespace tyndall::test
