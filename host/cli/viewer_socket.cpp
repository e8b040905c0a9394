#include "cli/viewer_socket.hpp"

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <system_error>

namespace tyndall {
namespace {

constexpr int poll_milliseconds = 100;

std::string words(int error_number) { return std::generic_category().message(error_number); }

}  // namespace

bool ViewerSocket::is_open() const
{
    if (descriptor_ < 0) return false;
    pollfd asked{.fd = descriptor_, .events = POLLRDHUP, .revents = 0};
    return ::poll(&asked, 1, 0) == 0;
}

void ViewerSocket::close()
{
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
}

std::string ViewerSocket::wait_to_write() const
{
    pollfd waiting{.fd = descriptor_, .events = POLLOUT, .revents = 0};
    while (!stop_) {
        const int ready = ::poll(&waiting, 1, poll_milliseconds);
        if (ready > 0) return {};
        if (ready < 0 && errno != EINTR) return words(errno);
    }
    return "it was still busy at the end";
}

std::string ViewerSocket::connect(const ViewerAddress& address)
{
    close();
    addrinfo hints{}, *found = nullptr;
    hints.ai_socktype = SOCK_STREAM;
    if (const int fault = ::getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found); fault != 0) return ::gai_strerror(fault);
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(found, ::freeaddrinfo);
    std::string why = "it has no address";
    for (const addrinfo* each = found; each; each = each->ai_next) {
        descriptor_ = ::socket(each->ai_family, each->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, each->ai_protocol);
        if (descriptor_ < 0) {
            why = words(errno);
            continue;
        }
        if (::connect(descriptor_, each->ai_addr, each->ai_addrlen) == 0) return {};
        why = errno == EINPROGRESS ? wait_to_write() : words(errno);
        int fault = 0;
        socklen_t size = sizeof fault;
        if (why.empty() && ::getsockopt(descriptor_, SOL_SOCKET, SO_ERROR, &fault, &size) == 0 && fault == 0) return {};
        if (why.empty()) why = words(fault);
        close();
    }
    return why;
}

std::string ViewerSocket::send(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t sent = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent > 0) {
            bytes.remove_prefix(static_cast<std::size_t>(sent));
            continue;
        }
        if (sent < 0 && errno == EINTR) continue;
        std::string why = sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK) ? wait_to_write() : words(errno);
        if (why.empty()) continue;
        close();
        return why;
    }
    return {};
}

}  // namespace tyndall
