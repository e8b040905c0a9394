#pragma once
/// What a PLY file says about itself before its data.
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall::ply {

/// How one number is stored.
enum class Number { i8, u8, i16, u16, i32, u32, f32, f64 };

inline std::size_t bytes_of(Number number)
{
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(number)];
}

struct Property {
    std::string name;
    Number type;                  ///< of the value or the list's items
    std::optional<Number> count;  ///< of a list's length
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding { ascii, little_endian, big_endian };

struct Header {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements;
    std::size_t size = 0;  ///< bytes up to the data
};

/// Throws MeshFault for a header that is not understood.
Header read_header(std::string_view bytes);

}  // namespace tyndall::ply
