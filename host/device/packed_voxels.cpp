#include "device/packed_voxels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tyndall {
namespace {

/// The upper half of a float, rounded to nearest, ties to even; infinity and what is not a number stay what they are.
std::uint32_t upper_half(float value)
{
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    if (!std::isfinite(value)) return bits >> 16;
    return (bits + 0x7fffu + (bits >> 16 & 1u)) >> 16;
}

}  // namespace

std::vector<std::uint32_t> packed_voxels(const MediaTables& tables)
{
    std::vector<std::uint32_t> packed(tables.voxels.size(), 0);
    for (const GridRecord& grid : tables.grids) {
        std::size_t end = packed.size();  // one channel or three: up to the next grid
        for (const GridRecord& other : tables.grids)
            if (other.first > grid.first) end = std::min<std::size_t>(end, other.first);
        for (std::size_t i = grid.first; i < end; ++i) {
            const bool last = (i - grid.first) % grid.size_x + 1 == grid.size_x;
            packed[i] = upper_half(tables.voxels[i]) | upper_half(tables.voxels[last ? i : i + 1]) << 16;
        }
    }
    return packed;
}

}  // namespace tyndall
