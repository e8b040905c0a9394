// OpenEXR pictures. The one place of host/scene that knows OpenEXR.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfTestFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "scene/picture_files.hpp"

namespace tyndall {
namespace {

/// PIZ reaches some 10,000:1 on constant pictures; a header that claims more values than this per byte lies.
constexpr std::int64_t most_values_per_byte = 1 << 14;

/// Bytes in memory as OpenEXR wants to read them.
class Bytes : public Imf::IStream {
public:
    explicit Bytes(std::string_view bytes) : Imf::IStream("the picture"), bytes_(bytes) {}
    bool read(char target[], int count) override
    {
        const std::uint64_t left = at_ < bytes_.size() ? bytes_.size() - at_ : 0;
        if (count < 0 || static_cast<std::uint64_t>(count) > left) throw std::runtime_error("the file is cut off");
        std::memcpy(target, bytes_.data() + at_, static_cast<std::size_t>(count));
        at_ += static_cast<std::uint64_t>(count);
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override { at_ = position; }

private:
    std::string_view bytes_;
    std::uint64_t at_ = 0;
};

/// A whole number of the file, little-endian.
std::uint32_t number_at(std::string_view bytes, std::size_t at)
{
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return number;
}

/// What the header says of sizes, before OpenEXR asks for memory by it.
struct Sizes {
    std::int64_t width = 0, height = 0, tile_width = 0, tile_height = 0;  ///< 0: not said
};

/// Notes an attribute's sizes.
void note(Sizes& sizes, std::string_view name, std::string_view value)
{
    const auto side = [&](std::size_t low, std::size_t high) { return std::int64_t(static_cast<std::int32_t>(number_at(value, high))) - static_cast<std::int32_t>(number_at(value, low)) + 1; };
    if (name == "dataWindow" && value.size() >= 16) sizes.width = side(0, 8), sizes.height = side(4, 12);
    if (name == "tiles" && value.size() >= 8) sizes.tile_width = number_at(value, 0), sizes.tile_height = number_at(value, 4);
}

/// Does the file hold every attribute that its header claims? OpenEXR asks for memory by those claims before it reads. Names and types end with a zero byte, then come four bytes of size,
/// little-endian; an empty name ends the header.
bool header_fits(std::string_view bytes, Sizes& sizes)
{
    std::size_t at = 8;  // behind magic number and version
    while (true) {
        const std::size_t name_end = bytes.find('\0', at);
        if (name_end == bytes.npos) return false;
        if (name_end == at) return true;
        const std::size_t type_end = bytes.find('\0', name_end + 1);
        if (type_end == bytes.npos || bytes.size() - type_end < 5) return false;
        const std::uint32_t size = number_at(bytes, type_end + 1);
        const std::string_view name = bytes.substr(at, name_end - at);
        at = type_end + 5;
        if (size > bytes.size() - at) return false;
        note(sizes, name, bytes.substr(at, size));
        at += size;
    }
}

/// OpenEXR keeps tiles, a row of them, and where each begins in the file. Tiles may stick out of a small picture.
void check_tiles(const Sizes& sizes, std::size_t bytes)
{
    const std::int64_t x = sizes.tile_width, y = sizes.tile_height;
    if (x == 0 && y == 0) return;
    check_picture_size(sizes.width, sizes.height);
    const std::int64_t most = std::max(std::min(sizes.width * sizes.height, most_values_per_byte * static_cast<std::int64_t>(bytes)), std::int64_t{1} << 22);
    if (x > most || y > most || x * y > most || sizes.width * y > most)
        throw PictureFault(fmt::format("says that its tiles have {} x {} pixels, far more than there are in {} x {}", x, y, sizes.width, sizes.height));
    if (x > 0 && y > 0 && (sizes.width / x) * (sizes.height / y) * std::int64_t{8} > static_cast<std::int64_t>(bytes)) throw PictureFault("says that it has more tiles than a file of its size can hold");
}

/// Names of the channels that make the picture.
std::vector<std::string> channels_of(const Imf::ChannelList& channels)
{
    if (channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B")) return {"R", "G", "B"};
    if (channels.findChannel("Y")) return {"Y"};
    std::vector<std::string> names;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) names.emplace_back(channel.name());
    if (names.size() == 1) return names;
    throw PictureFault(fmt::format("has {} channels, but neither R, G and B nor Y", names.size()));
}

Picture read_pixels(Bytes& stream, std::size_t bytes)
{
    Imf::InputFile input(stream);
    const auto window = input.header().dataWindow();
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1, height = std::int64_t(window.max.y) - window.min.y + 1;
    check_picture_size(width, height);
    std::int64_t values = 0;
    for (auto channel = input.header().channels().begin(); channel != input.header().channels().end(); ++channel) {
        if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1) throw PictureFault("has subsampled channels, which are not read");
        values += width * height;
        if (values / most_values_per_byte > static_cast<std::int64_t>(bytes)) throw PictureFault("says that it has more pixels than a file of its size can hold");
    }
    if (!input.isComplete()) throw PictureFault("is incomplete");
    const auto names = channels_of(input.header().channels());
    Picture picture{.width = static_cast<int>(width), .height = static_cast<int>(height), .channels = static_cast<int>(names.size())};
    picture.values.resize(static_cast<std::size_t>(width * height) * names.size());
    const std::size_t step = names.size() * sizeof(float);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < names.size(); ++c)
        frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, picture.values.data() + c, window, step, step * static_cast<std::size_t>(width)));
    input.setFrameBuffer(frame);
    input.readPixels(window.min.y, window.max.y);
    return picture;
}

}  // namespace

Picture read_exr_picture(std::string_view bytes)
{
    try {
        Bytes stream(bytes);
        bool tiled = false, deep = false, multi_part = false;
        if (!Imf::isOpenExrFile(stream, tiled, deep, multi_part)) throw PictureFault("is not an OpenEXR file");
        if (deep || multi_part) throw PictureFault(deep ? "holds deep data, which is not read" : "has several parts, which is not read");
        Sizes sizes;
        if (!header_fits(bytes, sizes)) throw PictureFault("claims more bytes in its header than there are");
        if (tiled) check_tiles(sizes, bytes.size());
        stream.seekg(0);
        return read_pixels(stream, bytes.size());
    } catch (const PictureFault&) {
        throw;
    } catch (const std::exception& error) {
        throw PictureFault(fmt::format("is no OpenEXR file that can be read: {}", error.what()));
    }
}

}  // namespace tyndall
