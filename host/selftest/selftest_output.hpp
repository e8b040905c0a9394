#pragma once
/// A selftest's result for people, for programs and for test runners.
#include "selftest/selftest.hpp"

namespace tyndall {

inline constexpr const char* selftest_schema = "tyndall-selftest/1";

/// A line per case and place, then a sentence for every case outside its bounds.
std::string to_table(const SelftestResult& result);

/// Schema tyndall-selftest/1 (host/docs/selftest.md); no NaN literals. `version`: of the program.
std::string to_json(const SelftestResult& result, const std::string& version);

/// One test suite for each place, one test case for each row.
std::string to_junit(const SelftestResult& result);

/// "host float", "device, 16 lanes".
std::string place_of(const SelftestOutcome& outcome);

}  // namespace tyndall
