#pragma once
/// Mitsuba's .vol files as tests write them.
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace tyndall::test {

struct VolFile {
    std::array<std::int32_t, 3> size{1, 1, 1};
    std::int32_t channels = 1;
    std::vector<float> values;  ///< [z][y][x][channel]
    std::array<float, 6> box{0, 0, 0, 1, 1, 1};
    unsigned char version = 3;
    std::int32_t encoding = 1;
};

inline std::string word_bytes(std::uint32_t word)
{
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 255);
    return bytes;
}
inline std::string value_bytes(float value) { return word_bytes(std::bit_cast<std::uint32_t>(value)); }

inline std::string vol_bytes(const VolFile& file)
{
    std::string bytes = "VOL" + std::string(1, static_cast<char>(file.version)) + word_bytes(static_cast<std::uint32_t>(file.encoding));
    for (const std::int32_t size : file.size) bytes += word_bytes(static_cast<std::uint32_t>(size));
    bytes += word_bytes(static_cast<std::uint32_t>(file.channels));
    for (const float edge : file.box) bytes += value_bytes(edge);
    for (const float value : file.values) bytes += value_bytes(value);
    return bytes;
}

/// Two voxels along x.
inline VolFile two_voxels(float left, float right) { return {.size = {2, 1, 1}, .values = {left, right}}; }

/// A ball of smoke in n^3 voxels: 1 in the middle, falling with the square of the radius to 0 at the centres of the faces; the corners are empty.
inline VolFile ball_of_smoke(std::int32_t n)
{
    VolFile file{.size = {n, n, n}};
    const auto at = [n](std::int32_t i) { return (static_cast<float>(2 * i + 1) - static_cast<float>(n)) / static_cast<float>(n); };
    for (std::int32_t z = 0; z < n; ++z)
        for (std::int32_t y = 0; y < n; ++y)
            for (std::int32_t x = 0; x < n; ++x) {
                const float square = at(x) * at(x) + at(y) * at(y) + at(z) * at(z);
                file.values.push_back(square < 1 ? 1 - square : 0);
            }
    return file;
}

}  // namespace tyndall::test
