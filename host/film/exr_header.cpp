#include "film/exr_header.hpp"

#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

namespace tyndall {
namespace {

constexpr std::size_t longest_name = 255;  ///< of attributes and their types
constexpr std::streamoff first_attribute = 8;  ///< behind magic number and version

/// Up to its zero byte; nothing if the file ends or the text goes on for longer than any name.
std::optional<std::string> read_name(std::istream& stream)
{
    std::string name;
    for (char c = 0; stream.get(c) && name.size() <= longest_name; name += c)
        if (c == 0) return name;
    return {};
}

/// Little-endian, 32 bits, signed; negative where the file ends.
std::int64_t read_size(std::istream& stream)
{
    std::array<char, 4> bytes{};
    if (!stream.read(bytes.data(), bytes.size())) return -1;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
    return value > static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max()) ? -1 : static_cast<std::int64_t>(value);
}

}  // namespace

bool exr_header_fits(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    stream.seekg(0, std::ios::end);
    const std::int64_t end = stream.tellg();
    stream.seekg(first_attribute);
    while (stream) {
        const std::optional<std::string> name = read_name(stream);
        if (name && name->empty()) return true;  // the end of the header
        if (!name || !read_name(stream)) return false;
        const std::int64_t size = read_size(stream), at = stream.tellg();
        if (size < 0 || size > end - at) return false;
        stream.seekg(size, std::ios::cur);
    }
    return false;
}

}  // namespace tyndall
