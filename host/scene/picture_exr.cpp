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

/// Does the file hold every attribute that its header claims? OpenEXR asks for memory by those claims before it reads. Names and types end with a zero byte, then come four bytes of size,
/// little-endian; an empty name ends the header.
bool header_fits(std::string_view bytes)
{
    std::size_t at = 8;  // behind magic number and version
    while (true) {
        const std::size_t name_end = bytes.find('\0', at);
        if (name_end == bytes.npos) return false;
        if (name_end == at) return true;
        const std::size_t type_end = bytes.find('\0', name_end + 1);
        if (type_end == bytes.npos || bytes.size() - type_end < 5) return false;
        std::uint32_t size = 0;
        for (std::size_t i = 0; i < 4; ++i) size |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[type_end + 1 + i])) << (8 * i);
        at = type_end + 5;
        if (size > bytes.size() - at) return false;
        at += size;
    }
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

/// OpenEXR keeps a row of tiles, as large as the file says they are. Tiles may stick out of a small picture.
void check_tile_size(const Imf::Header& header, std::int64_t width, std::int64_t height)
{
    if (!header.hasTileDescription()) return;
    const std::int64_t x = header.tileDescription().xSize, y = header.tileDescription().ySize, most = std::max(width * height, std::int64_t{1} << 24);
    if (x > most || y > most || x * y > most || width * y > most) throw PictureFault(fmt::format("says that its tiles have {} x {} pixels, far more than there are in {} x {}", x, y, width, height));
}

Picture read_pixels(Bytes& stream, std::size_t bytes)
{
    Imf::InputFile input(stream);
    const auto window = input.header().dataWindow();
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1, height = std::int64_t(window.max.y) - window.min.y + 1;
    check_picture_size(width, height);
    check_tile_size(input.header(), width, height);
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
        if (!header_fits(bytes)) throw PictureFault("claims more bytes in its header than there are");
        stream.seekg(0);
        return read_pixels(stream, bytes.size());
    } catch (const PictureFault&) {
        throw;
    } catch (const std::exception& error) {
        throw PictureFault(fmt::format("is no OpenEXR file that can be read: {}", error.what()));
    }
}

}  // namespace tyndall
