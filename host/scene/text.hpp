#pragma once
/// Words for messages and strict numbers out of text. Nothing here depends on the locale.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"
#include "tyndall/error.hpp"

namespace tyndall {

/// The text with control characters and invalid bytes written as \xNN, so that no message carries an escape code to a terminal; at most 200
/// bytes.
std::string printable(std::string_view text);

/// printable(text) in double quotes.
std::string in_quotes(std::string_view text);

/// Throws SceneError "file:line:column: message".
[[noreturn]] void refuse(const SourceLocation& where, const std::string& message);

/// A finite real number and nothing else (surrounding blanks and one leading + allowed); neither nan nor inf nor what double cannot hold.
std::optional<double> parse_real(std::string_view text);

/// A decimal integer and nothing else.
std::optional<std::int64_t> parse_integer(std::string_view text);

/// Pieces between blanks and commas.
std::vector<std::string_view> split_list(std::string_view text);

/// Number of insertions, deletions, replacements and neighbour swaps from one text to the other.
std::size_t edit_distance(std::string_view from, std::string_view to);

/// " (did you mean "x"?)" for the known name nearest to `wrong`, or "" if none is near.
std::string suggestion(std::string_view wrong, const std::vector<std::string>& known);

/// "a, b, c".
std::string join(const std::vector<std::string>& words);

}  // namespace tyndall
