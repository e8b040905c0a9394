#pragma once
/// The report as JSON for programs and as a table for people.
#include <string>

#include "report/report.hpp"

namespace tyndall {

/// The value of "schema" in the JSON. It changes when a key is renamed, removed or changes its meaning; new keys may come at any time.
inline constexpr const char* report_schema = "tyndall-report/1";

/// Pretty-printed JSON with a final line break. Unknown and non-finite numbers are null. 64-bit identifiers (seed, scene hash) are strings,
/// because many JSON readers round numbers above 2^53. Control characters in names are escaped; invalid UTF-8 is replaced.
std::string to_json(const Report& report);

/// A summary of some twenty lines: what was rendered, where the time went, counts and rates, layers, warnings.
std::string to_table(const Report& report);

}  // namespace tyndall
