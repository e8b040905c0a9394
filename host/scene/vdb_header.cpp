#include "scene/vdb_header.hpp"

#include <fmt/format.h>

#include "scene/volume_files.hpp"

namespace tyndall {
namespace {

constexpr std::string_view magic{" BDV\0\0\0\0", 8};
constexpr std::uint32_t oldest_format = 222;
constexpr std::size_t library_version = 8, identifier = 36, grid_positions = 3 * 8, shortest_grid = 3 * 4 + grid_positions;

/// Walks over the header without keeping anything of it.
class HeaderWalk {
public:
    explicit HeaderWalk(std::string_view bytes) : left_(bytes) {}

    std::string_view pass(std::uint64_t size)
    {
        if (size > left_.size()) throw VolumeFault("ends within its header, or the header claims more bytes than there are; it is damaged");
        const std::string_view passed = left_.substr(0, static_cast<std::size_t>(size));
        left_.remove_prefix(passed.size());
        return passed;
    }
    std::uint32_t number()
    {
        std::uint32_t value = 0;
        unsigned shift = 0;
        for (const char c : pass(4)) value |= static_cast<std::uint32_t>(static_cast<unsigned char>(c)) << shift, shift += 8;
        return value;
    }
    void text() { pass(number()); }
    /// A count of pieces of at least `shortest` bytes each.
    std::uint32_t count(std::size_t shortest)
    {
        const std::uint32_t count = number();
        if (count > left_.size() / shortest) throw VolumeFault(fmt::format("claims {} pieces in the {} bytes that are left; it is damaged", count, left_.size()));
        return count;
    }
    /// Names, types and values.
    void metadata()
    {
        for (std::uint32_t i = count(3 * 4); i > 0; --i) text(), text(), text();
    }

private:
    std::string_view left_;
};

}  // namespace

void check_vdb_header(std::string_view bytes, std::uint32_t newest_format)
{
    HeaderWalk walk(bytes);
    if (walk.pass(magic.size()) != magic) throw VolumeFault("is no OpenVDB file");
    const std::uint32_t format = walk.number();
    if (format < oldest_format || format > newest_format)
        throw VolumeFault(fmt::format("is of OpenVDB's format {}; formats from {} (2013) to {} are read; save it again with another program", format, oldest_format, newest_format));
    walk.pass(library_version), walk.pass(1), walk.pass(identifier);
    walk.metadata();
    if (walk.count(shortest_grid) == 0) return;
    walk.text(), walk.text(), walk.text(), walk.pass(grid_positions);
    walk.number();  // how the grid is compressed
    walk.metadata();
}

}  // namespace tyndall
