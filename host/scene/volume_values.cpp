#include "scene/volume_values.hpp"

#include <algorithm>
#include <cmath>

#include "scene/transforms.hpp"

namespace tyndall {

namespace {

constexpr double rounding = 1e-9;  ///< of a box's size: what two matrices in double leave of two boxes that are meant to be equal, with a thousandfold reserve

Vec3 size_of(const Volume& volume) { return {volume.size_x, volume.size_y, volume.size_z}; }

/// Voxels with `before` more in front along each axis; those that are new repeat the nearest old one.
std::vector<float> stretched(const Volume& old, const Volume& wide, const glm::ivec3& before)
{
    std::vector<float> values;
    values.reserve(voxel_count(wide) * static_cast<std::size_t>(wide.channels));
    const auto source = [](int at, int shift, int size) { return static_cast<std::size_t>(std::clamp(at - shift, 0, size - 1)); };
    const std::size_t row = static_cast<std::size_t>(old.size_x), layer = row * static_cast<std::size_t>(old.size_y);
    for (std::size_t channel = 0; channel < static_cast<std::size_t>(old.channels); ++channel)
        for (int z = 0; z < wide.size_z; ++z)
            for (int y = 0; y < wide.size_y; ++y)
                for (int x = 0; x < wide.size_x; ++x)
                    values.push_back(old.values[channel * voxel_count(old) + source(z, before.z, old.size_z) * layer + source(y, before.y, old.size_y) * row +
                                                source(x, before.x, old.size_x)]);
    return values;
}

}  // namespace

VolumeStatistics statistics_of(const Volume& volume)
{
    VolumeStatistics statistics{.bytes = volume.values.size() * sizeof(float)};
    const std::size_t voxels = voxel_count(volume);
    for (int c = 0; c < 3; ++c) {
        const auto first = volume.values.begin() + static_cast<std::ptrdiff_t>(volume.channels == 3 ? static_cast<std::size_t>(c) * voxels : 0);
        const auto last = first + static_cast<std::ptrdiff_t>(voxels);
        double sum = 0;
        for (auto value = first; value != last; ++value) sum += *value;
        const auto [least, largest] = std::minmax_element(first, last);
        statistics.least[c] = *least, statistics.largest[c] = *largest, statistics.mean[c] = sum / static_cast<double>(voxels);
    }
    return statistics;
}

Rgb largest_extinction(const Scene& scene, const Medium& medium)
{
    if (medium.density == none) return medium.sigma_t;
    return medium.sigma_t * statistics_of(scene.volumes[static_cast<std::size_t>(medium.density)]).largest;
}

std::optional<Volume> reaching_over(const Volume& volume, const Volume& inner, double most)
{
    const Vec3 size = size_of(volume);
    const Bounds needed = bounds_of(Volume{.to_world = glm::inverse(volume.to_world) * inner.to_world});  // in boxes of `volume`
    const Vec3 before = glm::ceil(glm::max(-needed.low - rounding, 0.) * size), after = glm::ceil(glm::max(needed.high - 1. - rounding, 0.) * size);
    const Vec3 wide = before + size + after;
    if (before + after == Vec3(0)) return volume;
    if (!(wide.x * wide.y * wide.z * volume.channels <= most)) return std::nullopt;
    Volume result{.name = volume.name, .size_x = static_cast<int>(wide.x), .size_y = static_cast<int>(wide.y), .size_z = static_cast<int>(wide.z), .channels = volume.channels};
    result.to_world = volume.to_world * translation(-before / size) * scaling(wide / size);
    result.where = volume.where;
    result.values = stretched(volume, result, glm::ivec3(before));
    return result;
}

}  // namespace tyndall
