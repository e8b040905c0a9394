#pragma once
/// Voxels out of the bytes of files. Every count is checked against the bytes that are there before memory is asked for.
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/vector.hpp"

namespace tyndall {

/// What is wrong with a file of voxels: "version 2: only version 3 is read". The loader adds the file and the place in the scene.
struct VolumeFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct VolumeFile {
    int size_x = 0, size_y = 0, size_z = 0;  ///< at least 1
    int channels = 1;                        ///< 1 or 3
    std::vector<float> values;               ///< [channel][z][y][x]; finite, >= 0, never -0
    std::array<float, 6> box{};              ///< .vol: x, y, z of the lowest corner, then of the highest, as the file says; not checked
    Mat4 placement{1};                       ///< .vdb: of the unit cube, by the grid's transform
};

inline constexpr std::uintmax_t largest_volume_file = std::uintmax_t{1} << 31;

/// Mitsuba's .vol, version 3: little-endian; "VOL", the byte 3, int32 encoding (1: float32), int32 numbers of voxels along x, y and z, int32 channels, float32
/// box[6], then float32 values[z][y][x][channel] up to the end of the file. Three channels that are equal everywhere become one.
VolumeFile read_vol(std::string_view bytes);

/// The grid `name` of an OpenVDB file: floats, a linear transform, not a level set. A dense copy of the box of its active voxels, whose centres are at whole numbers of
/// index space; voxels of that box that are not active have the values that the tree gives. At most 2^29 voxels. All grids of the file are read on the way. Faults say
/// so where Tyndall is built without OpenVDB.
VolumeFile read_vdb(std::string bytes, const std::string& name);

/// Checks what all formats share: every value is finite and not negative. -0 becomes 0, three equal channels become one.
void finish_volume(VolumeFile& file);

}  // namespace tyndall
