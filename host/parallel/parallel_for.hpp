#pragma once
/// The parallel loops of all parts: TBB's, apart from builds for ThreadSanitizer, where they run on threads of their own. Debian's libtbb is not built for that sanitizer, which would see neither that a
/// loop begins after what stands before it nor that it ends before what follows, and would report both as races.
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#if defined(__SANITIZE_THREAD__)
#define TYNDALL_PLAIN_THREADS 1
#elif defined(__has_feature)
#define TYNDALL_PLAIN_THREADS __has_feature(thread_sanitizer)
#else
#define TYNDALL_PLAIN_THREADS 0
#endif

#if TYNDALL_PLAIN_THREADS
#include "parallel/plain_threads.hpp"
#endif

namespace tyndall {

/// body(i) for every i in [first, last), in parallel. An exception of the body ends the loop and leaves it.
template <typename Index, typename Body>
void parallel_for(Index first, Index last, const Body& body)
{
#if TYNDALL_PLAIN_THREADS
    on_plain_threads(first, last, body);
#else
    tbb::parallel_for(first, last, body);
#endif
}

/// body(first, count) for pieces of [0, count), of at least half of `grain` each if there are so many, in parallel.
template <typename Body>
void parallel_pieces(std::size_t count, std::size_t grain, const Body& body)
{
#if TYNDALL_PLAIN_THREADS
    on_plain_threads(std::size_t(0), (count + grain - 1) / grain, [&](std::size_t piece) { body(piece * grain, std::min(grain, count - piece * grain)); });
#else
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) { body(range.begin(), range.size()); });
#endif
}

/// work() with the arena's number of threads, perhaps on another thread.
template <typename Work>
void run_in([[maybe_unused]] tbb::task_arena& arena, const Work& work)
{
#if TYNDALL_PLAIN_THREADS
    work();
#else
    arena.execute(work);
#endif
}

}  // namespace tyndall
