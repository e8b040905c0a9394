#pragma once
/// Tests that build a program for every combination of choices take a covering part of them by default, and all where the environment says EVERY_VARIANT: as slow tests
/// (host/docs/decisions/0041-programs-of-the-tests.md).
#include <cstddef>
#include <cstdlib>
#include <span>
#include <vector>

namespace tyndall::test {

inline bool every_variant() { return std::getenv("EVERY_VARIANT") != nullptr; }

/// Of the combinations of a scene (or another case) with `all`: those whose place follows the case's number, one in `step`, so that cases in a row share them out between them.
template <typename Value>
std::vector<Value> covering_part(std::span<const Value> all, std::size_t number, std::size_t step)
{
    std::vector<Value> part;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (every_variant() || (i + number) % step == 0) part.push_back(all[i]);
    return part;
}

/// The number of a name in a list, for `covering_part`; the list's length if it is not there.
template <typename List, typename Name>
std::size_t place_in(const List& list, const Name& name)
{
    std::size_t place = 0;
    for (const auto& entry : list) {
        if (entry == name) break;
        ++place;
    }
    return place;
}

}  // namespace tyndall::test
