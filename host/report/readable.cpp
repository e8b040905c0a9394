#include "report/readable.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tyndall {
namespace {

/// Three significant digits without an exponent, for values in [0, 1000).
std::string three_digits(double value)
{
    const int decimals = value < 9.995 ? 2 : value < 99.95 ? 1 : 0;
    return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace

std::string readable_count(double count)
{
    if (!std::isfinite(count)) return "unknown";
    if (count < 1000 && count == std::floor(count)) return fmt::format("{:.0f}", count);
    const char* units[] = {"", " K", " M", " G", " T"};
    std::size_t unit = 0;
    while (count >= 999.5 && unit + 1 < std::size(units)) count /= 1000, ++unit;
    return three_digits(count) + units[unit];
}

std::string readable_seconds(double seconds)
{
    if (!std::isfinite(seconds) || seconds < 0) return "unknown";
    if (seconds < 99.95) return three_digits(seconds) + " s";
    const auto whole = static_cast<long long>(std::llround(seconds));
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string readable_percent(double fraction)
{
    return std::isfinite(fraction) && fraction >= 0 ? three_digits(100 * fraction) + " %" : "unknown";
}

std::string readable_lanes(int lanes, const std::string& from) { return std::to_string(lanes) + (lanes == 1 ? " lane by " : " lanes by ") + from; }

std::string terminal_safe(const std::string& text)
{
    std::string clean;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
        const bool c1_control = byte == 0xc2 && next >= 0x80 && next < 0xa0;  // U+0080..U+009F: some terminals obey them
        if (byte < 0x20 || byte == 0x7f)
            clean += fmt::format("\\x{:02x}", byte);
        else if (c1_control)
            clean += fmt::format("\\x{:02x}", next), ++i;
        else
            clean += text[i];
    }
    return clean;
}

}  // namespace tyndall
