#include "exr/exr_header.hpp"

#include <ImfTestFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>

namespace tyndall {
namespace {

struct Claims {
    std::int64_t width = 0, height = 0;            ///< of the data window; 0: the file does not say
    std::int64_t channels = 0;                     ///< a channel that is named twice counts twice
    std::int64_t tile_width = 0, tile_height = 0;  ///< 0: not said
    std::int64_t lines_per_block = 1;              ///< rows that the compression takes together, in files without tiles
    bool tiled = false, subsampled = false;
};

constexpr std::uint64_t first_attribute = 8;                  ///< behind magic number and version
constexpr std::size_t longest_name = 254;                     ///< of attributes, types and channels: OpenEXR looks for the zero byte among 255
constexpr std::int64_t longest_side = std::int64_t{1} << 20;  ///< of images and tiles, in pixels
constexpr std::int64_t small_buffer = std::int64_t{1} << 26;  ///< values, 256 MiB at most: DWAB takes 256 rows together, so a strip of 65536 x 1 pixels with four channels needs as many
/// Compressors reach about 1000:1 on constant images, PIZ some 10,000:1; a header that claims more values than this per byte of file lies.
constexpr std::uint64_t most_values_per_byte = 1u << 14;

/// Some bytes of a file, read from the front to the end.
class Piece {
public:
    Piece(Imf::IStream& stream, std::uint64_t at, std::uint64_t end) : stream_(stream), at_(at), end_(end) { stream_.seekg(at_); }

    std::uint64_t left() const { return end_ - at_; }
    void skip(std::uint64_t size) { stream_.seekg(pass(size)); }
    /// The next bytes, to be read first; then follows `skip` of as many.
    Piece next(std::uint64_t size) const
    {
        check(size);
        return {stream_, at_, at_ + size};
    }
    unsigned char byte()
    {
        pass(1);
        char c = 0;
        stream_.read(&c, 1);
        return static_cast<unsigned char>(c);
    }
    /// Little-endian, 32 bits, signed.
    std::int32_t number()
    {
        std::uint32_t value = 0;
        for (unsigned shift = 0; shift < 32; shift += 8) value |= static_cast<std::uint32_t>(byte()) << shift;
        return static_cast<std::int32_t>(value);
    }
    /// Up to its zero byte.
    std::string name()
    {
        std::string text;
        while (const unsigned char c = byte()) {
            if (text.size() == longest_name) throw ExrFault(fmt::format("has a name of more than {} bytes in its header", longest_name));
            text += static_cast<char>(c);
        }
        return text;
    }

private:
    void check(std::uint64_t size) const
    {
        if (size > left()) throw ExrFault("claims more bytes in its header than there are");
    }
    /// Returns where the next byte is.
    std::uint64_t pass(std::uint64_t size)
    {
        check(size);
        return at_ += size;
    }
    Imf::IStream& stream_;
    std::uint64_t at_, end_;
};

/// Bytes of the types whose values have always as many: OpenEXR reads them whatever size the header states.
constexpr struct {
    std::string_view type;
    std::uint64_t bytes;
} sizes_of_types[] = {{"box2f", 16}, {"box2i", 16}, {"chromaticities", 32}, {"compression", 1}, {"deepImageState", 1}, {"double", 8}, {"envmap", 1}, {"float", 4},
                      {"int", 4}, {"keycode", 28}, {"lineOrder", 1}, {"m33d", 72}, {"m33f", 36}, {"m44d", 128}, {"m44f", 64}, {"rational", 8},
                      {"tiledesc", 9}, {"timecode", 8}, {"v2d", 16}, {"v2f", 8}, {"v2i", 8}, {"v3d", 24}, {"v3f", 12}, {"v3i", 12}};

ExrFault out_of_step(std::string_view type) { return ExrFault(fmt::format("states a size for a value of type \"{}\" in its header that is not the value's", type)); }

/// Does a value of its type fill the piece, as OpenEXR reads it? Of types that OpenEXR does not know it reads what is stated; so it does of texts.
bool fills(Piece value, std::string_view type)
{
    if (const auto* row = std::find_if(std::begin(sizes_of_types), std::end(sizes_of_types), [&](const auto& known) { return known.type == type; }); row != std::end(sizes_of_types)) return value.left() == row->bytes;
    if (type == "floatvector") return value.left() % 4 == 0;
    if (type == "preview") {
        if (value.left() < 8) return false;
        const std::int64_t width = value.number(), height = value.number();
        return width >= 0 && height >= 0 && static_cast<std::uint64_t>(width * height) * 4 == value.left();  // both below 2^31: the product fits
    }
    if (type == "stringvector")
        while (value.left() > 0) {
            if (value.left() < 4) return false;
            const std::int64_t size = value.number();
            if (size < 0 || static_cast<std::uint64_t>(size) > value.left()) return false;
            value.skip(static_cast<std::uint64_t>(size));
        }
    return true;
}

/// Channels: a name, the kind of number, what it means, a channel's pixels per pixel in x and y; an empty name ends them, whatever size is stated.
void read_channels(Piece value, Claims& claims)
{
    const auto checked = [](std::uint64_t left, std::uint64_t needed) { if (left < needed) throw out_of_step("chlist"); };
    for (checked(value.left(), 1); !value.name().empty(); checked(value.left(), 1)) {
        checked(value.left(), 16);
        value.skip(8);
        const std::int32_t x = value.number(), y = value.number();
        claims.subsampled |= x != 1 || y != 1;
        ++claims.channels;
    }
    if (value.left() > 0) throw out_of_step("chlist");
}

/// The rows of pixels that a compression takes together; of compressions that OpenEXR does not know yet as many as of any.
std::int64_t lines_of_compression(unsigned char compression)
{
    constexpr std::int64_t none = 1, lines[] = {none, 1, 1, 16, 32, 16, 32, 32, 32, 256};  // run lengths, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB
    return compression < std::size(lines) ? lines[compression] : 256;
}

/// Notes what is asked for later. A later attribute of the same name takes the place of an earlier one; OpenEXR itself refuses these names with other types.
void note(Piece value, std::string_view name, std::string_view type, Claims& claims)
{
    if (name == "dataWindow" && type == "box2i") {
        const std::int64_t left = value.number(), top = value.number();
        claims.width = value.number() - left + 1, claims.height = value.number() - top + 1;
    }
    if (name == "tiles" && type == "tiledesc") claims.tile_width = static_cast<std::uint32_t>(value.number()), claims.tile_height = static_cast<std::uint32_t>(value.number());
    if (name == "compression" && type == "compression") claims.lines_per_block = lines_of_compression(value.byte());
}

void read_value(Piece value, std::string_view name, std::string_view type, Claims& claims)
{
    if (type == "idmanifest") throw ExrFault("holds a manifest of objects (idmanifest), which is not read");  // OpenEXR 3.1.5 reads four bytes more than the size says
    if (type == "chlist") return read_channels(value, claims);
    if (!fills(value, type)) throw out_of_step(type);
    note(value, name, type, claims);
}

/// Of the buffers that OpenEXR fills before it gives pixels, and of the table of blocks in front of them. Tiles may stick out of a small picture, and a block of rows may be higher than it.
void check_blocks(const Claims& claims, std::uint64_t bytes)
{
    const std::int64_t x = claims.tile_width, y = claims.tile_height, width = claims.width, height = claims.height, lines = claims.lines_per_block;
    if (claims.tiled && (x < 1 || y < 1)) throw ExrFault("has tiles without pixels");
    const std::int64_t most = std::max(width * height, small_buffer / claims.channels);
    if (claims.tiled && (x > longest_side || y > longest_side || std::max(x, width) * y > most))
        throw ExrFault(fmt::format("says that its tiles have {} x {} pixels, far more than there are in {} x {}", x, y, width, height));
    if (!claims.tiled && width * lines > most) throw ExrFault(fmt::format("takes {} rows together, far more than there are in {} x {} pixels", lines, width, height));
    const std::int64_t blocks = claims.tiled ? ((width + x - 1) / x) * ((height + y - 1) / y) : (height + lines - 1) / lines;
    if (static_cast<std::uint64_t>(blocks) * sizeof(std::uint64_t) > bytes) throw ExrFault(fmt::format("says that it has more {} than a file of its size can hold", claims.tiled ? "tiles" : "rows"));
}

Claims walk(Imf::IStream& stream, std::uint64_t bytes)
{
    bool deep = false, multi_part = false;
    Claims claims;
    if (!Imf::isOpenExrFile(stream, claims.tiled, deep, multi_part)) throw ExrFault("is not an OpenEXR file");
    if (deep || multi_part) throw ExrFault(deep ? "holds deep data, which is not read" : "has several parts, which is not read");
    Piece rest(stream, first_attribute, bytes);
    for (std::string name = rest.name(); !name.empty(); name = rest.name()) {
        const std::string type = rest.name();
        const auto size = static_cast<std::uint32_t>(rest.number());
        read_value(rest.next(size), name, type, claims);
        rest.skip(size);
    }
    return claims;
}

}  // namespace

void check_exr_header(Imf::IStream& stream, std::uint64_t bytes)
{
    const Claims claims = walk(stream, bytes);
    if (claims.channels == 0) throw ExrFault("has no channels");
    if (claims.subsampled) throw ExrFault("has subsampled channels, which are not read");
    if (claims.width < 1 || claims.height < 1 || claims.width > longest_side || claims.height > longest_side) throw ExrFault("has a data window that makes no sense");
    if (static_cast<std::uint64_t>(claims.width * claims.height) > most_values_per_byte * bytes / static_cast<std::uint64_t>(claims.channels))
        throw ExrFault("says that it has more pixels than a file of its size can hold");
    check_blocks(claims, bytes);
    stream.seekg(0);
}

}  // namespace tyndall
