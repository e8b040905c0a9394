#include "scene/volume_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace tyndall {

namespace {

constexpr std::size_t header_bytes = 48, value_bytes = sizeof(float);

std::uint32_t word_at(std::string_view bytes, std::size_t at)
{
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return word;
}
int integer_at(std::string_view bytes, std::size_t at) { return std::bit_cast<std::int32_t>(word_at(bytes, at)); }
float float_at(std::string_view bytes, std::size_t at) { return std::bit_cast<float>(word_at(bytes, at)); }

std::string size_words(const VolumeFile& file) { return fmt::format("{} x {} x {} voxels of {} channels", file.size_x, file.size_y, file.size_z, file.channels); }

void check_kind(std::string_view bytes)
{
    if (bytes.size() < header_bytes) throw VolumeFault(fmt::format("has {} bytes; a .vol file starts with a header of {}", bytes.size(), header_bytes));
    if (bytes.substr(0, 3) != "VOL") throw VolumeFault("does not start with the letters VOL; it is no .vol file");
    if (bytes[3] != 3) throw VolumeFault(fmt::format("is of version {}; only version 3 is read", int{static_cast<unsigned char>(bytes[3])}));
    if (const int encoding = integer_at(bytes, 4); encoding != 1) throw VolumeFault(fmt::format("has encoding {}; only 1, 32-bit float, is read", encoding));
}

/// Number of voxels, after checking that as many values follow the header as it says.
std::size_t checked_voxels(const VolumeFile& file, std::size_t bytes)
{
    for (const int size : {file.size_x, file.size_y, file.size_z})
        if (size < 1) throw VolumeFault("says that it holds " + size_words(file) + "; every size must be at least 1");
    if (file.channels != 1 && file.channels != 3) throw VolumeFault(fmt::format("has {} channels; it must have 1 or 3", file.channels));
    // Two sizes multiply without overflow, and a product beyond the bytes of the file is refused before the third comes in.
    const std::uint64_t there = (bytes - header_bytes) / value_bytes, layer = static_cast<std::uint64_t>(file.size_x) * static_cast<std::uint64_t>(file.size_y);
    const std::uint64_t columns = static_cast<std::uint64_t>(file.size_z) * static_cast<std::uint64_t>(file.channels);
    const bool fits = layer <= there && columns <= there / layer;
    if (!fits || layer * columns != there || bytes - header_bytes != there * value_bytes)
        throw VolumeFault(fmt::format("says that it holds {}, but {} bytes follow its header; it is truncated, or its sizes are wrong", size_words(file), bytes - header_bytes));
    return static_cast<std::size_t>(layer) * static_cast<std::size_t>(file.size_z);
}

void check_values(const VolumeFile& file)
{
    const std::size_t row = static_cast<std::size_t>(file.size_x), layer = row * static_cast<std::size_t>(file.size_y), all = layer * static_cast<std::size_t>(file.size_z);
    for (std::size_t i = 0; i < file.values.size(); ++i) {
        const float value = file.values[i];
        if (std::isfinite(value) && value >= 0) continue;
        const std::size_t voxel = i % all;
        throw VolumeFault(fmt::format("voxel ({}, {}, {}) is {}; every value must be finite and not negative", voxel % row, voxel % layer / row, voxel / layer, value));
    }
}

}  // namespace

void finish_volume(VolumeFile& file)
{
    check_values(file);
    for (float& value : file.values) value += 0.0f;  // -0 to 0
    if (file.channels != 3) return;
    const auto voxels = static_cast<std::ptrdiff_t>(file.values.size() / 3);
    const auto red = file.values.begin(), green = red + voxels, blue = green + voxels;
    if (!std::equal(red, green, green) || !std::equal(red, green, blue)) return;
    file.values.resize(static_cast<std::size_t>(voxels)), file.channels = 1;
}

VolumeFile read_vol(std::string_view bytes)
{
    check_kind(bytes);
    VolumeFile file{.size_x = integer_at(bytes, 8), .size_y = integer_at(bytes, 12), .size_z = integer_at(bytes, 16), .channels = integer_at(bytes, 20)};
    const std::size_t voxels = checked_voxels(file, bytes.size()), channels = static_cast<std::size_t>(file.channels);
    for (std::size_t i = 0; i < file.box.size(); ++i) file.box[i] = float_at(bytes, 24 + i * value_bytes);
    file.values.resize(voxels * channels);
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
        for (std::size_t c = 0; c < channels; ++c) file.values[c * voxels + voxel] = float_at(bytes, header_bytes + (voxel * channels + c) * value_bytes);
    finish_volume(file);
    return file;
}

}  // namespace tyndall
