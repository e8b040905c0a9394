#pragma once
/// What every function of the C interface does with exceptions.
#include <string>
#include <utility>

#include "tyndall/error.hpp"
#include "tyndall/tyndall.h"

namespace tyndall {

/// Keeps the sentence for tyndall_last_error() and returns the status of the exception that is being handled. Throws nothing.
tyndall_status note_failure() noexcept;

/// Runs `work`; what it throws becomes a status and a sentence.
template <typename Work>
tyndall_status guarded(Work&& work) noexcept
{
    try {
        work();
        return TYNDALL_OK;
    } catch (...) {
        return note_failure();
    }
}

/// The thing behind a pointer that must not be null.
template <typename Thing>
Thing& needed(Thing* pointer, const char* what)
{
    if (!pointer) throw UsageError(std::string(what) + " is NULL");
    return *pointer;
}

/// Gives out a handle made by `make`; *out is null if that fails.
template <typename Handle, typename Make>
tyndall_status made(Handle** out, Make&& make) noexcept
{
    if (out) *out = nullptr;
    return guarded([&] { needed(out, "the place for the result") = make(); });
}

}  // namespace tyndall
