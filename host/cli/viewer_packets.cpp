#include "cli/viewer_packets.hpp"

#include <cstdint>
#include <cstring>

namespace tyndall {
namespace {

enum class Type : std::uint8_t { create_image = 4, update_image_v3 = 6 };
constexpr const char* channels[] = {"R", "G", "B"};

/// A packet in the making.
class Packet {
public:
    explicit Packet(Type type)
    {
        integer<std::uint32_t>(0);  // the length
        integer(static_cast<std::uint8_t>(type));
        integer<std::uint8_t>(0);  // the viewer's window stays where it is
    }
    template <class Integer>
    void integer(Integer value)
    {
        for (std::size_t byte = 0; byte < sizeof(Integer); ++byte) bytes_ += static_cast<char>((static_cast<std::uint64_t>(value) >> (8 * byte)) & 0xff);
    }
    void text(const std::string& value) { bytes_ += value, bytes_ += '\0'; }
    void channel_names()
    {
        integer<std::int32_t>(3);
        for (const char* name : channels) text(name);
    }
    void numbers(std::span<const float> values)
    {
        for (const float value : values) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &value, sizeof bits);
            integer(bits);
        }
    }
    std::string finished()
    {
        const auto length = static_cast<std::uint32_t>(bytes_.size());
        for (std::size_t byte = 0; byte < sizeof length; ++byte) bytes_[byte] = static_cast<char>((length >> (8 * byte)) & 0xff);
        return std::move(bytes_);
    }

private:
    std::string bytes_;
};

}  // namespace

std::string create_image_packet(const std::string& name, int width, int height)
{
    Packet packet(Type::create_image);
    packet.text(name);
    packet.integer<std::int32_t>(width), packet.integer<std::int32_t>(height);
    packet.channel_names();
    return packet.finished();
}

std::string update_rows_packet(const std::string& name, int width, int first, int count, std::span<const float> rgb)
{
    Packet packet(Type::update_image_v3);
    packet.text(name);
    packet.channel_names();
    for (const int number : {0, first, width, count}) packet.integer<std::int32_t>(number);
    for (const int offset : {0, 1, 2}) packet.integer<std::int64_t>(offset);
    for (int channel = 0; channel < 3; ++channel) packet.integer<std::int64_t>(3);  // strides
    packet.numbers(rgb);
    return packet.finished();
}

}  // namespace tyndall
