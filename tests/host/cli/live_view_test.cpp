/// --display-server with a viewer of our own: one that decodes what comes, and ones that refuse, stall and reset.
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <functional>
#include <map>
#include <thread>

#include "film/exr.hpp"
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// An image as the viewer has it.
struct Shown {
    std::int32_t width = 0, height = 0;
    std::map<std::string, std::vector<float>> channels;
    int updates = 0;
};

/// Reads little-endian content; throws where a packet ends too early.
class Reader {
public:
    explicit Reader(const std::string& bytes) : bytes_(bytes) {}
    template <class Number>
    Number number()
    {
        Number value;
        std::memcpy(&value, take(sizeof value), sizeof value);
        return value;
    }
    std::string text()
    {
        const std::string value(bytes_.c_str() + at_);
        take(value.size() + 1);
        return value;
    }
    std::size_t left() const { return bytes_.size() - at_; }

private:
    const char* take(std::size_t count)
    {
        if (count > left()) throw std::runtime_error("a packet ends too early");
        return bytes_.data() + std::exchange(at_, at_ + count);
    }
    const std::string& bytes_;
    std::size_t at_ = 0;
};

void update(Reader& reader, Shown& image)
{
    std::vector<std::string> names(static_cast<std::size_t>(reader.number<std::int32_t>()));
    for (std::string& name : names) name = reader.text();
    const auto x = reader.number<std::int32_t>(), y = reader.number<std::int32_t>(), width = reader.number<std::int32_t>(), height = reader.number<std::int32_t>();
    std::vector<std::int64_t> offsets(names.size()), strides(names.size());
    for (auto& offset : offsets) offset = reader.number<std::int64_t>();
    for (auto& stride : strides) stride = reader.number<std::int64_t>();
    std::vector<float> data(reader.left() / sizeof(float));
    for (float& value : data) value = reader.number<float>();
    if (x < 0 || y < 0 || x + width > image.width || y + height > image.height) throw std::runtime_error("an update lies outside the image");
    for (std::size_t c = 0; c < names.size(); ++c)
        for (std::int64_t pixel = 0; pixel < std::int64_t{width} * height; ++pixel)
            image.channels.at(names[c]).at(static_cast<std::size_t>((y + pixel / width) * image.width + x + pixel % width)) = data.at(static_cast<std::size_t>(offsets[c] + pixel * strides[c]));
    ++image.updates;
}

/// One packet without its length.
void decode(const std::string& packet, std::map<std::string, Shown>& images)
{
    Reader reader(packet);
    const int type = reader.number<std::uint8_t>();
    reader.number<std::uint8_t>();  // whether to come to the front
    Shown& image = images[reader.text()];
    if (type == 6) return update(reader, image);
    if (type != 4) throw std::runtime_error("an unknown type of packet");
    image = {};
    image.width = reader.number<std::int32_t>(), image.height = reader.number<std::int32_t>();
    for (int left = reader.number<std::int32_t>(); left > 0; --left) image.channels[reader.text()].assign(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 0.f);
    if (reader.left() != 0) throw std::runtime_error("a packet is too long");
}

/// Listens on a free port of this machine; `serve` gets every connection, by its number from 0.
class Viewer {
public:
    explicit Viewer(std::function<void(int, int)> serve) : listener_(::socket(AF_INET, SOCK_STREAM, 0)), serve_(std::move(serve))
    {
        sockaddr_in address{};
        address.sin_family = AF_INET, address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(listener_, 4) != 0) throw std::runtime_error("no port to listen on");
        ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
        port_ = ntohs(address.sin_port);
        thread_ = std::thread([this] { run(); });
    }
    ~Viewer() { close(); }
    void close()
    {
        stop = true;
        if (thread_.joinable()) thread_.join();
        if (listener_ >= 0) ::close(std::exchange(listener_, -1));
    }
    std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
    int connections() const { return connections_; }

    std::atomic<bool> stop{false};

private:
    void run()
    {
        while (!stop) {
            pollfd waiting{.fd = listener_, .events = POLLIN, .revents = 0};
            if (::poll(&waiting, 1, 50) <= 0) continue;
            const int connection = ::accept(listener_, nullptr, nullptr);
            serve_(connection, connections_++);
            ::close(connection);
        }
    }
    int listener_;
    int port_ = 0;
    std::atomic<int> connections_{0};
    std::function<void(int, int)> serve_;
    std::thread thread_;
};

/// Exactly `count` bytes; fewer at the end of the stream.
std::string received(int connection, std::size_t count)
{
    std::string bytes(count, '\0');
    std::size_t have = 0;
    for (ssize_t got; have < count && (got = ::recv(connection, bytes.data() + have, count - have, 0)) > 0;) have += static_cast<std::size_t>(got);
    bytes.resize(have);
    return bytes;
}

void read_packets(int connection, std::map<std::string, Shown>& images)
{
    for (;;) {
        const std::string head = received(connection, 4);
        if (head.size() < 4) return;
        const auto length = Reader(head).number<std::uint32_t>();
        const std::string packet = received(connection, length - 4);
        ASSERT_EQ(packet.size() + 4, length) << "the stream ends inside a packet";
        ASSERT_NO_THROW(decode(packet, images));
    }
}

class LiveViewer : public Program {
protected:
    ProcessResult render(const std::string& address, std::vector<std::string> more = {})
    {
        std::vector<std::string> arguments{"render", "scene.xml", "--method", "path", "--progress", "none", "--display-server", address};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    void expect_the_film(const std::map<std::string, Shown>& images)
    {
        ASSERT_EQ(images.size(), 1u);
        const auto& [name, shown] = *images.begin();
        EXPECT_EQ(name, "scene.exr");
        const ExrImage image = read_exr(folder / "scene.exr");
        EXPECT_EQ(shown.width, image.width);
        EXPECT_EQ(shown.height, image.height);
        ASSERT_EQ(shown.channels.size(), 3u);
        for (const char* channel : {"R", "G", "B"}) EXPECT_EQ(shown.channels.at(channel), image.channels.at(channel).values) << channel;
    }
};

TEST_F(LiveViewer, HasTheFilmAtTheEnd)
{
    std::map<std::string, Shown> images;
    Viewer viewer([&](int connection, int) { read_packets(connection, images); });
    const ProcessResult ran = render(viewer.address(), {"--resolution", "400x300", "--passes", "3"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    viewer.close();
    EXPECT_EQ(viewer.connections(), 1);
    expect_the_film(images);
    EXPECT_GE(images.begin()->second.updates, 2) << "more than one packet of rows";
    EXPECT_THAT(ran.err, Not(HasSubstr("viewer")));
}

TEST_F(LiveViewer, ThatRefusesIsAWarning)
{
    Viewer viewer([](int, int) {});
    viewer.close();
    const ProcessResult ran = render(viewer.address(), {"--passes", "2"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("warning: the viewer at 127.0.0.1:"));
    EXPECT_THAT(ran.err, HasSubstr("Connection refused"));
    EXPECT_EQ(ran.err.find("viewer"), ran.err.rfind("viewer")) << "once";
    EXPECT_TRUE(std::filesystem::exists(folder / "scene.exr"));
}

TEST_F(LiveViewer, ThatNeverReadsDoesNotHoldTheRenderUp)
{
    Viewer viewer([&](int, int) {
        while (!viewer.stop) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    });
    const ProcessResult ran = render(viewer.address(), {"--resolution", "1024x1024", "--passes", "2", "--layer", "single"});  // more than any buffer between the two
    EXPECT_EQ(ran.exit_code, 0) << ran.err << ran.signal;
    EXPECT_EQ(std::get<int>(read_exr(folder / "scene.exr").attributes.at("tyndall.passes")), 2);
}

TEST_F(LiveViewer, ThatResetsIsFoundAgain)
{
    std::map<std::string, Shown> images;
    Viewer viewer([&](int connection, int number) {
        if (number > 0) return read_packets(connection, images);
        received(connection, 1);
        const linger at_once{.l_onoff = 1, .l_linger = 0};  // close with RST
        ::setsockopt(connection, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    });
    const ProcessResult ran = render(viewer.address(), {"--resolution", "400x300", "--passes", "4"});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    viewer.close();
    EXPECT_GE(viewer.connections(), 2);
    expect_the_film(images);
}

TEST_F(LiveViewer, AddressesThatMakeNoSenseAreRefused)
{
    for (const char* address : {"", "localhost:", "localhost:0", "localhost:65536", "[::1", "[]", "[::1]14158", "localhost:x", "::1"}) {
        const ProcessResult ran = render(address);
        EXPECT_EQ(ran.exit_code, 2) << address << ran.err;
        EXPECT_THAT(ran.err, HasSubstr("--display-server"));
    }
}

}  // namespace
}  // namespace tyndall::test
