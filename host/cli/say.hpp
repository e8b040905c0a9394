#pragma once
/// What the program says. A terminal that went away or a log on a full disk ends no render: what people cannot be told is lost, and data that did not reach standard output is a failure at the end
/// (command_line.cpp).
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace tyndall {

/// Formats into a stream. If that fails, the stream's error flag is set, and nothing else happens (fmt::print would throw).
template <typename... Arguments>
void say(std::FILE* stream, fmt::format_string<Arguments...> format, Arguments&&... arguments)
{
    const std::string text = fmt::format(format, std::forward<Arguments>(arguments)...);
    std::fwrite(text.data(), 1, text.size(), stream);
}

/// On standard output: data.
template <typename... Arguments>
void say(fmt::format_string<Arguments...> format, Arguments&&... arguments)
{
    say(stdout, format, std::forward<Arguments>(arguments)...);
}

}  // namespace tyndall
