#include "cli/live_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "cli/parse_values.hpp"
#include "cli/viewer_packets.hpp"
#include "cli/viewer_socket.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto between_images = std::chrono::milliseconds(500), between_attempts = std::chrono::milliseconds(1000);
constexpr auto wait_for_last = std::chrono::milliseconds(1000), wait_for_end = std::chrono::milliseconds(500);
constexpr int packet_values = 1 << 18;  ///< about so many of a packet's rows: a megabyte

struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgb;
};

Picture picture_of(const Film& film)
{
    Picture picture{film.width(), film.height(), {}};
    picture.rgb.reserve(3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (const Rgb& pixel : film.beauty())
        for (int channel = 0; channel < 3; ++channel) picture.rgb.push_back(static_cast<float>(pixel[channel]));
    return picture;
}

}  // namespace

/// Shared by render and thread.
struct LiveView::State {
    ViewerAddress address;
    std::string name;
    std::mutex guard;                  ///< of all that follows, except `stop`
    std::condition_variable changed;
    std::optional<Picture> next;       ///< to be shown
    bool last = false;                 ///< `next` is: it is worth another attempt at once
    bool busy = false, ended = false, warned = false;
    std::string warning;
    Clock::time_point offered{};
    std::atomic<bool> stop{false};

    void warn(const std::string& why)
    {
        const std::lock_guard lock(guard);
        if (!warned) warning = fmt::format("the viewer at {}:{} does not take the image: {}; the render goes on, and tries again now and then", address.host, address.port, why);
        warned = true;
    }
    void run();
    std::string show(ViewerSocket& socket, const Picture& picture, bool& created);
};

/// Why it could not be shown, or nothing.
std::string LiveView::State::show(ViewerSocket& socket, const Picture& picture, bool& created)
{
    if (!socket.is_open()) {
        created = false;
        if (std::string why = socket.connect(address); !why.empty()) return why;
    }
    if (!created)
        if (std::string why = socket.send(create_image_packet(name, picture.width, picture.height)); !why.empty()) return why;
    created = true;
    const int rows = std::max(packet_values / (3 * picture.width), 1);
    for (int first = 0; first < picture.height; first += rows) {
        const int count = std::min(rows, picture.height - first);
        const auto values = std::span(picture.rgb).subspan(3 * static_cast<std::size_t>(first) * static_cast<std::size_t>(picture.width), 3 * static_cast<std::size_t>(count) * static_cast<std::size_t>(picture.width));
        if (std::string why = socket.send(update_rows_packet(name, picture.width, first, count, values)); !why.empty()) return why;
    }
    return {};
}

void LiveView::State::run()
{
    ViewerSocket socket(stop);
    bool created = false;
    Clock::time_point failed = Clock::now() - between_attempts;
    for (std::unique_lock lock(guard);;) {
        changed.wait(lock, [&] { return stop || next; });
        if (stop) {
            ended = true;
            return changed.notify_all();
        }
        const Picture picture = std::move(*next);
        const bool at_once = last;
        next.reset(), busy = true;
        lock.unlock();
        std::string why;
        if (socket.is_open() || at_once || Clock::now() - failed >= between_attempts) {
            why = show(socket, picture, created);
            if (!why.empty() && at_once && !stop) why = show(socket, picture, created);  // the connection may have died since the image before
            if (!why.empty()) failed = Clock::now(), warn(why);
        }
        lock.lock();
        busy = false;
        changed.notify_all();
    }
}

LiveView::LiveView(ViewerAddress address, std::string name) : state_(std::make_shared<State>())
{
    state_->address = std::move(address), state_->name = std::move(name);
    std::thread([state = state_] { state->run(); }).detach();
}

LiveView::~LiveView()
{
    std::unique_lock lock(state_->guard);
    state_->stop = true;
    state_->changed.notify_all();
    state_->changed.wait_for(lock, wait_for_end, [&] { return state_->ended; });
}

void LiveView::offer(const Film& film)
{
    {
        const std::lock_guard lock(state_->guard);
        if (state_->busy || state_->next || Clock::now() - state_->offered < between_images) return;
    }
    Picture picture = picture_of(film);
    const std::lock_guard lock(state_->guard);
    state_->next = std::move(picture), state_->offered = Clock::now();
    state_->changed.notify_all();
}

void LiveView::finish(const Film& film)
{
    Picture picture = picture_of(film);
    std::unique_lock lock(state_->guard);
    state_->next = std::move(picture), state_->last = true;
    state_->changed.notify_all();
    state_->changed.wait_for(lock, wait_for_last, [&] { return !state_->next && !state_->busy; });
}

std::string LiveView::take_warning()
{
    const std::lock_guard lock(state_->guard);
    return std::exchange(state_->warning, {});
}

ViewerAddress parse_viewer(std::string_view option, const std::string& text)
{
    const auto wrong = [&] { return UsageError(fmt::format("{} \"{}\": must be HOST or HOST:PORT, for example localhost:14158", option, text)); };
    ViewerAddress address;
    const bool bracket = text.starts_with('[');
    const auto end = bracket ? text.find(']') : text.find(':');
    if (bracket && end == std::string::npos) throw wrong();
    const std::string host = bracket ? text.substr(1, end - 1) : text.substr(0, end);
    const std::string rest = end == std::string::npos ? std::string() : text.substr(end + (bracket ? 1 : 0));
    if (!host.empty()) address.host = host;
    if (text.empty() || (bracket && host.empty()) || (!rest.empty() && rest.front() != ':')) throw wrong();
    if (!rest.empty()) address.port = std::to_string(parse_integer(option, rest.substr(1), 1, 65535));
    return address;
}

}  // namespace tyndall
