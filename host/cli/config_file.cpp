#include "cli/config_file.hpp"

#include <algorithm>

#include "scene/scene_files.hpp"
#include "scene/text.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

constexpr std::uintmax_t largest_file = 1u << 20;
constexpr std::string_view blanks = " \t\r";

std::string trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string() : std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

bool is_name(std::string_view text)
{
    const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
    return !text.empty() && text.front() != '-' && std::ranges::all_of(text, fits);
}

/// What follows a value may only be a comment.
bool ends_here(std::string_view rest)
{
    const std::string text = trimmed(rest);
    return text.empty() || text.front() == '#';
}

std::string quoted_value(std::string_view text, const SourceLocation& where)
{
    std::string value;
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '"') {
            if (!ends_here(text.substr(i + 1))) refuse(where, "something follows the closing quote");
            return value;
        }
        if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\')) ++i;
        value += text[i];
    }
    refuse(where, "the quote is not closed");
}

/// Without quotes, a # behind a blank starts a comment.
std::string plain_value(std::string_view text)
{
    for (std::size_t i = 1; i < text.size(); ++i)
        if (text[i] == '#' && blanks.find(text[i - 1]) != std::string_view::npos) return trimmed(text.substr(0, i));
    return trimmed(text);
}

/// One line; a section changes `section`, a value is added.
void read_line(std::string_view line, SourceLocation where, std::string& section, std::vector<ConfigValue>& values)
{
    const auto start = line.find_first_not_of(blanks);
    if (start == std::string_view::npos || line[start] == '#') return;
    where.column = static_cast<int>(start) + 1;
    if (line[start] == '[') {
        const auto end = line.find(']', start);
        if (end == std::string_view::npos || !ends_here(line.substr(end + 1))) refuse(where, "a section must be the name of a command in brackets, for example [bench]");
        section = trimmed(line.substr(start + 1, end - start - 1));
        if (!is_name(section)) refuse(where, in_quotes(section) + " is no name of a command");
        return;
    }
    const auto equals = line.find('=', start);
    const std::string name = trimmed(line.substr(start, equals == std::string_view::npos ? equals : equals - start));
    if (equals == std::string_view::npos) refuse(where, in_quotes(name) + " has no value; a line is name = value, and a flag is name = true");
    if (!is_name(name)) refuse(where, in_quotes(name) + " is no name of an option; write it without its dashes");
    const std::string text = trimmed(line.substr(equals + 1));
    if (text.empty() || text.front() == '#') refuse(where, "\"" + name + "\" has an empty value; write \"\" for an empty text, or leave the line out");
    values.push_back({section, name, text.front() == '"' ? quoted_value(text, where) : plain_value(text), where});
}

}  // namespace

std::vector<ConfigValue> read_config(const std::filesystem::path& file)
try {
    const std::string name = file.string(), text = read_regular_file(file, {.file = name}, largest_file);
    std::vector<ConfigValue> values;
    std::string section;
    int line = 1;
    for (std::size_t start = 0; start < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        read_line(std::string_view(text).substr(start, end - start), {name, line, 1}, section, values);
        start = end + 1;
    }
    return values;
} catch (const SceneError& error) {
    throw UsageError(error.what());
}

std::string config_text(const std::string& value)
{
    const bool plain = !value.empty() && value.find_first_of("\"#\\ \t") == std::string::npos;
    if (plain) return value;
    std::string text;
    for (const char c : value) text += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return "\"" + text + "\"";
}

}  // namespace tyndall
