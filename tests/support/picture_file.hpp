#pragma once
/// Pictures as tests write them: PNG without a library, EXR by the film's writer.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "film/exr.hpp"

namespace tyndall::test {

struct PngFile {
    int width = 1, height = 1;
    int bits = 8;
    enum class Colour : char { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgba = 6 } colour = Colour::rgb;
    std::vector<int> samples;      ///< [y][x][channel]; of a palette: its indices
    std::vector<int> palette{};    ///< r, g, b of every colour
};

inline std::string big_endian(std::uint32_t word)
{
    return {static_cast<char>(word >> 24), static_cast<char>(word >> 16 & 255), static_cast<char>(word >> 8 & 255), static_cast<char>(word & 255)};
}

inline std::uint32_t cyclic_redundancy(const std::string& bytes)
{
    std::uint32_t crc = 0xffffffffu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

inline std::string png_chunk(const std::string& type, const std::string& data)
{
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(cyclic_redundancy(type + data));
}

/// One stored block of zlib's format; at most 65535 bytes.
inline std::string stored(const std::string& bytes)
{
    std::uint32_t a = 1, b = 0;
    for (const char c : bytes) a = (a + static_cast<unsigned char>(c)) % 65521, b = (b + a) % 65521;
    const auto size = static_cast<std::uint32_t>(bytes.size());
    const std::string length{static_cast<char>(size & 255), static_cast<char>(size >> 8)}, inverse{static_cast<char>(~size & 255), static_cast<char>(~size >> 8 & 255)};
    return "\x78\x01\x01" + length + inverse + bytes + big_endian(b << 16 | a);
}

inline std::string png_bytes(const PngFile& file)
{
    const std::string header = big_endian(static_cast<std::uint32_t>(file.width)) + big_endian(static_cast<std::uint32_t>(file.height)) +
                               std::string{static_cast<char>(file.bits), static_cast<char>(file.colour), 0, 0, 0};
    std::string pixels, palette;
    for (std::size_t i = 0; i < file.samples.size(); ++i) {
        if (i % (file.samples.size() / static_cast<std::size_t>(file.height)) == 0) pixels += '\0';  // the row's filter: none
        if (file.bits == 16) pixels += static_cast<char>(file.samples[i] >> 8);
        pixels += static_cast<char>(file.samples[i] & 255);
    }
    for (const int value : file.palette) palette += static_cast<char>(value);
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + (palette.empty() ? "" : png_chunk("PLTE", palette)) + png_chunk("IDAT", stored(pixels)) + png_chunk("IEND", "");
}

/// values: [y][x][channel], channels named by `names`.
inline std::string exr_bytes(int width, int height, const std::vector<std::string>& names, const std::vector<float>& values, const std::filesystem::path& scratch)
{
    ExrImage image{.width = width, .height = height, .display_width = width, .display_height = height};
    for (std::size_t i = 0; i < values.size(); ++i) image.channels[names[i % names.size()]].values.push_back(values[i]);
    write_exr(scratch, image);
    std::ifstream file(scratch, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace tyndall::test
