#pragma once
/// Numbers and text as people read them.
#include <cstdint>
#include <string>

namespace tyndall {

/// "950", "12.3 K", "4.56 M", "7.89 G": three significant digits, powers of 1000.
std::string readable_count(double count);

/// "0.42 s", "12.3 s", "3 min 05 s", "2 h 07 min".
std::string readable_seconds(double seconds);

/// "1.24 %"; "unknown" for negative or non-finite fractions.
std::string readable_percent(double fraction);

/// "16 lanes by rule", "8 lanes by calibration", "4 lanes by request".
std::string readable_lanes(int lanes, const std::string& from);

/// Text from a file or a driver, fit for a terminal: control characters (escape codes among them) become \xNN; UTF-8 stays.
std::string terminal_safe(const std::string& text);

}  // namespace tyndall
