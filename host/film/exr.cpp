#include "film/exr.hpp"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "exr/exr_header.hpp"
#include "film/atomic_file.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

constexpr float largest_half = 65504.f;

/// OpenEXR's output, led into an AtomicFile.
class Stream : public Imf::OStream {
public:
    Stream(AtomicFile& file, const std::string& name) : Imf::OStream(name.c_str()), file_(file) {}
    void write(const char bytes[], int count) override { file_.write(bytes, static_cast<std::size_t>(count)); }
    uint64_t tellp() override { return file_.position(); }
    void seekp(uint64_t position) override { file_.seek(position); }

private:
    AtomicFile& file_;
};

bool stored_as_half(const ExrChannel& channel)
{
    return channel.half && std::all_of(channel.values.begin(), channel.values.end(), [](float v) { return !(std::abs(v) > largest_half); });
}

Imf::Header header_of(const ExrImage& image)
{
    const Imath::Box2i display({0, 0}, {image.display_width - 1, image.display_height - 1});
    const Imath::Box2i data({image.x, image.y}, {image.x + image.width - 1, image.y + image.height - 1});
    Imf::Header header(display, data);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, value] : image.attributes) {
        if (const auto* text = std::get_if<std::string>(&value)) header.insert(name, Imf::StringAttribute(*text));
        if (const auto* integer = std::get_if<int>(&value)) header.insert(name, Imf::IntAttribute(*integer));
        if (const auto* number = std::get_if<double>(&value)) header.insert(name, Imf::DoubleAttribute(*number));
    }
    return header;
}

/// Adds the channels to header and frame buffer; the half values live in `halves`.
Imf::FrameBuffer frame_buffer_of(const ExrImage& image, Imf::Header& header, std::vector<std::vector<half>>& halves)
{
    Imf::FrameBuffer frame;
    halves.reserve(image.channels.size());
    for (const auto& [name, channel] : image.channels) {
        assert(channel.values.size() == static_cast<std::size_t>(image.width) * image.height);
        const void* values = channel.values.data();
        const auto type = stored_as_half(channel) ? Imf::HALF : Imf::FLOAT;
        if (type == Imf::HALF) values = halves.emplace_back(channel.values.begin(), channel.values.end()).data();
        header.channels().insert(name, Imf::Channel(type));
        frame.insert(name, Imf::Slice::Make(type, values, header.dataWindow()));
    }
    return frame;
}

void write_pixels(AtomicFile& file, const std::string& name, const ExrImage& image)
{
    Stream stream(file, name);
    Imf::Header header = header_of(image);
    std::vector<std::vector<half>> halves;
    const Imf::FrameBuffer frame = frame_buffer_of(image, header, halves);
    Imf::OutputFile output(stream, header);
    output.setFrameBuffer(frame);
    output.writePixels(image.height);
}

IoError unreadable(const std::filesystem::path& file, const std::string& why)
{
    return IoError(fmt::format("{}: {}; render or copy it again", file.string(), why));
}

ExrImage empty_image(const Imf::Header& header)
{
    const auto &data = header.dataWindow(), &display = header.displayWindow();
    ExrImage image;
    image.x = data.min.x - display.min.x, image.y = data.min.y - display.min.y;
    image.width = data.max.x - data.min.x + 1, image.height = data.max.y - data.min.y + 1;
    image.display_width = display.max.x - display.min.x + 1, image.display_height = display.max.y - display.min.y + 1;
    for (auto attribute = header.begin(); attribute != header.end(); ++attribute) {
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            image.attributes[attribute.name()] = text->value();
        if (const auto* integer = dynamic_cast<const Imf::IntAttribute*>(&attribute.attribute()))
            image.attributes[attribute.name()] = integer->value();
        if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&attribute.attribute()))
            image.attributes[attribute.name()] = number->value();
    }
    return image;
}

ExrImage read_pixels(const std::filesystem::path& file)
{
    Imf::StdIFStream stream(file.c_str());
    check_exr_header(stream, std::filesystem::file_size(file));
    Imf::InputFile input(stream);
    if (!input.isComplete()) throw ExrFault("is incomplete");
    ExrImage image = empty_image(input.header());
    Imf::FrameBuffer frame;
    const auto window = input.header().dataWindow();
    for (auto channel = input.header().channels().begin(); channel != input.header().channels().end(); ++channel) {
        auto& target = image.channels[channel.name()];
        target.half = channel.channel().type == Imf::HALF;
        target.values.resize(static_cast<std::size_t>(image.width) * image.height);
        frame.insert(channel.name(), Imf::Slice::Make(Imf::FLOAT, target.values.data(), window));
    }
    input.setFrameBuffer(frame);
    input.readPixels(window.min.y, window.max.y);
    return image;
}

}  // namespace

void compress_exr_in_threads(int threads)
{
    const int workers = threads > 1 ? threads : 0;  // none: whoever writes compresses
    if (Imf::globalThreadCount() != workers) Imf::setGlobalThreadCount(workers);
}

void write_exr(const std::filesystem::path& file, const ExrImage& image)
{
    AtomicFile target(file);
    try {
        write_pixels(target, file.string(), image);
    } catch (const std::exception& error) {
        if (target.failed()) throw IoError(target.failure());
        throw IoError(fmt::format("{}: OpenEXR could not write the image: {}", file.string(), error.what()));
    }
    target.commit();
}

ExrImage read_exr(const std::filesystem::path& file)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) throw IoError(fmt::format("{}: there is no such file; check its name", file.string()));
    try {
        return read_pixels(file);
    } catch (const ExrFault& fault) {
        throw unreadable(file, fault.what());
    } catch (const std::exception& error) {
        throw unreadable(file, fmt::format("cannot be read: {}", error.what()));
    }
}

}  // namespace tyndall
