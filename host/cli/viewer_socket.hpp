#pragma once
/// A connection that never blocks for long: whoever waits on it can be told to stop.
#include <atomic>
#include <string>
#include <string_view>

#include "cli/live_view.hpp"

namespace tyndall {

class ViewerSocket {
public:
    /// Raising `stop` ends every wait within a tenth of a second.
    explicit ViewerSocket(const std::atomic<bool>& stop) : stop_(stop) {}
    ~ViewerSocket() { close(); }
    ViewerSocket(const ViewerSocket&) = delete;
    ViewerSocket& operator=(const ViewerSocket&) = delete;

    /// Connected, and the other side has not hung up.
    bool is_open() const;
    /// Why not, as a sentence; empty on success.
    std::string connect(const ViewerAddress& address);
    /// Sends all of it, however long the other side takes. The same.
    std::string send(std::string_view bytes);
    void close();

private:
    std::string wait_to_write() const;

    const std::atomic<bool>& stop_;
    int descriptor_ = -1;
};

}  // namespace tyndall
