// OpenEXR pictures. The one place of host/scene that knows OpenEXR.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <fmt/format.h>

#include <cstring>

#include "exr/exr_header.hpp"
#include "scene/picture_files.hpp"

namespace tyndall {
namespace {

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

Picture read_pixels(std::string_view bytes)
{
    Bytes stream(bytes);
    check_exr_header(stream, bytes.size());
    Imf::InputFile input(stream);
    if (!input.isComplete()) throw PictureFault("is incomplete");
    const auto window = input.header().dataWindow();
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1, height = std::int64_t(window.max.y) - window.min.y + 1;
    check_picture_size(width, height);
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
        return read_pixels(bytes);
    } catch (const PictureFault&) {
        throw;
    } catch (const ExrFault& fault) {
        throw PictureFault(fault.what());
    } catch (const std::exception& error) {
        throw PictureFault(fmt::format("is no OpenEXR file that can be read: {}", error.what()));
    }
}

}  // namespace tyndall
