#pragma once
/// What the functions that add to a description share.
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "library/c_guard.hpp"
#include "library/c_handles.hpp"

namespace tyndall {

inline api::Triple triple(const double* values, const char* what)
{
    needed(values, what);
    return {values[0], values[1], values[2]};
}

/// Adds an element to a list and gives out its number.
template <typename Element>
void add(std::vector<Element>& list, std::type_identity_t<Element> element, int* index)
{
    list.push_back(std::move(element));
    if (index) *index = static_cast<int>(list.size()) - 1;
}

/// An element that was added before. Throws UsageError.
template <typename Element>
Element& added(std::vector<Element>& list, int index, const char* kind)
{
    if (index < 0 || index >= static_cast<int>(list.size())) throw UsageError(std::string(kind) + " " + std::to_string(index) + " has not been added");
    return list[static_cast<std::size_t>(index)];
}

inline api::SceneDescription& data(tyndall_description* description) { return needed(description, "the description").data; }

inline std::optional<int> side(int medium) { return medium == TYNDALL_NO_BOUNDARY ? std::nullopt : std::optional(medium); }

}  // namespace tyndall
