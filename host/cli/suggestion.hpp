#pragma once
/// "Did you mean ...?"
#include <string>
#include <string_view>
#include <vector>

namespace tyndall {

/// The known name that a misspelt one most likely stands for: the fewest insertions, deletions, replacements and swaps of neighbours, ties
/// to the first; empty if none is within a third of the name's length (at least 2).
std::string nearest_name(std::string_view misspelt, const std::vector<std::string>& known);

/// "; did you mean "x"?" or an empty string.
std::string suggestion(std::string_view misspelt, const std::vector<std::string>& known);

}  // namespace tyndall
