#pragma once
/// The image while it is rendered, in the viewer tev (https://github.com/Tom94/tev), which listens on a port.
#include <memory>
#include <string>
#include <string_view>

#include "film/film.hpp"

namespace tyndall {

struct ViewerAddress {
    std::string host = "localhost", port = "14158";
};

/// "host", "host:port", ":port" or "[::1]:port". Throws UsageError.
ViewerAddress parse_viewer(std::string_view option, const std::string& text);

/// Sends images from a thread of its own, which connects, waits and tries again: a viewer that is slow, stalls, refuses or goes away costs the render nothing but a copy of the beauty now and then.
class LiveView {
public:
    /// `name`: of the image in the viewer.
    LiveView(ViewerAddress address, std::string name);
    /// Gives the thread up to half a second to end; one that hangs in a name server is left behind.
    ~LiveView();
    LiveView(const LiveView&) = delete;
    LiveView& operator=(const LiveView&) = delete;

    /// Shows the film's beauty, unless the last one is still on its way or was shown less than half a second ago.
    void offer(const Film& film);
    /// Shows it in any case, and waits for that, but not longer than a second.
    void finish(const Film& film);
    /// A sentence about what has gone wrong, once; empty if nothing has since the last call.
    std::string take_warning();

private:
    struct State;
    std::shared_ptr<State> state_;
};

}  // namespace tyndall
