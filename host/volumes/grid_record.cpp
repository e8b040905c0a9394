#include "volumes/grid_record.hpp"

#include "scene/transforms.hpp"

namespace tyndall {

GridRecord grid_record(const Volume& volume, std::size_t first)
{
    const Mat4 to_voxels = scaling({volume.size_x, volume.size_y, volume.size_z}) * glm::inverse(volume.to_world);
    const auto at = [&](int row, int column) { return static_cast<float>(to_voxels[column][row]); };
    return {at(0, 0), at(0, 1), at(0, 2), at(0, 3), at(1, 0), at(1, 1), at(1, 2), at(1, 3), at(2, 0), at(2, 1), at(2, 2), at(2, 3),
            static_cast<uint>(volume.size_x), static_cast<uint>(volume.size_y), static_cast<uint>(volume.size_z), static_cast<uint>(first)};
}

}  // namespace tyndall
