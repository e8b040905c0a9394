#pragma once
/// Packets of tev's protocol: 4 bytes length of the whole packet, 1 byte type, content; little-endian, texts end with a zero byte.
#include <cstddef>
#include <span>
#include <string>

namespace tyndall {

/// Makes the viewer forget an image of that name and show a black one with the channels R, G and B.
std::string create_image_packet(const std::string& name, int width, int height);

/// Replaces rows first ... first + count - 1 of the image; `rgb`: of those rows, interleaved, 3 width count values.
std::string update_rows_packet(const std::string& name, int width, int first, int count, std::span<const float> rgb);

}  // namespace tyndall
