#pragma once
/// A parallel loop of the standard library's threads, all of whose order ThreadSanitizer sees: a pass of the loop is behind its beginning and before its end, and beside every other pass that another thread runs.
#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace tyndall {

/// body(i) for every i in [first, last) on up to four threads, even where there are fewer processors: races need two. The first exception of a body ends the loop and is thrown here.
template <typename Index, typename Body>
void on_plain_threads(Index first, Index last, const Body& body)
{
    if (!(first < last)) return;
    // Relaxed: taking numbers orders no pass behind another, so that no race between two hides behind it.
    std::atomic<Index> next{first};
    std::atomic<bool> stop{false}, thrown{false};
    std::exception_ptr error;
    const auto work = [&] {
        for (Index i; !stop.load(std::memory_order_relaxed) && (i = next.fetch_add(1, std::memory_order_relaxed)) < last;) {
            try {
                body(i);
            } catch (...) {
                if (!thrown.exchange(true, std::memory_order_relaxed)) error = std::current_exception();
                stop.store(true, std::memory_order_relaxed);
            }
        }
    };
    std::vector<std::thread> threads(static_cast<std::size_t>(std::min<Index>(last - first, 4)));
    for (std::thread& thread : threads) thread = std::thread(work);
    for (std::thread& thread : threads) thread.join();
    if (error) std::rethrow_exception(error);
}

}  // namespace tyndall
