#include "scene/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace tyndall {

namespace {

constexpr std::size_t longest_quote = 200;

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

template <class Number>
std::optional<Number> parse_whole(std::string_view text)
{
    text = trimmed(text);
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-') || text.starts_with('+')) return {};
    }
    Number value{};
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

/// Length of the valid UTF-8 sequence that starts `text`, C1 control characters excluded; 0 if there is none.
std::size_t utf8_length(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = byte(0) < 0xc2 ? 0 : byte(0) < 0xe0 ? 2 : byte(0) < 0xf0 ? 3 : byte(0) < 0xf5 ? 4 : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    return length == 2 && byte(0) == 0xc2 && byte(1) < 0xa0 ? 0 : length;
}

}  // namespace

std::string printable(std::string_view text)
{
    const bool cut = text.size() > longest_quote;
    text = text.substr(0, longest_quote);
    std::string result;
    while (!text.empty()) {
        const auto byte = static_cast<unsigned char>(text.front());
        const std::size_t length = byte >= 0x20 && byte < 0x7f ? 1 : utf8_length(text);
        if (length == 0)
            result += fmt::format("\\x{:02x}", byte);
        else
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return cut ? result + "..." : result;
}

std::string in_quotes(std::string_view text) { return '"' + printable(text) + '"'; }

std::string to_string(const SourceLocation& where)
{
    if (where.line == 0) return where.file.empty() ? "scene built in memory" : printable(where.file);
    return fmt::format("{}:{}:{}", printable(where.file), where.line, where.column);
}

void refuse(const SourceLocation& where, const std::string& message) { throw SceneError(to_string(where) + ": " + message); }

std::optional<double> parse_real(std::string_view text)
{
    const auto value = parse_whole<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::int64_t> parse_integer(std::string_view text) { return parse_whole<std::int64_t>(text); }

std::vector<std::string_view> split_list(std::string_view text)
{
    constexpr std::string_view separators = " ,\t\r\n";
    std::vector<std::string_view> pieces;
    for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
        pieces.push_back(text.substr(at, end - at));
        at = text.find_first_not_of(separators, end);
    }
    return pieces;
}

std::size_t edit_distance(std::string_view from, std::string_view to)
{
    std::vector<std::size_t> before, above(to.size() + 1), row(to.size() + 1);
    for (std::size_t j = 0; j <= to.size(); ++j) above[j] = j;
    for (std::size_t i = 1; i <= from.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= to.size(); ++j) {
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = above;
        std::swap(above, row);
    }
    return above[to.size()];
}

std::string suggestion(std::string_view wrong, const std::vector<std::string>& known)
{
    if (wrong.empty() || wrong.size() > longest_quote) return "";
    const std::string* nearest = nullptr;
    // A short word may have one slip, a usual one two, a long one a quarter of its letters.
    std::size_t least = 1 + (wrong.size() < 4 ? 1 : std::max<std::size_t>(2, wrong.size() / 4));
    for (const std::string& name : known) {
        const std::size_t distance = edit_distance(wrong, name);
        if (distance < least) least = distance, nearest = &name;
    }
    return nearest ? " (did you mean " + in_quotes(*nearest) + "?)" : "";
}

std::string join(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

}  // namespace tyndall
