#pragma once
/// What was measured, for programs and for people.
#include <string>

#include "throughput/lane_choice.hpp"
#include "throughput/throughput.hpp"

namespace tyndall {

inline constexpr const char* throughput_schema = "tyndall-bench/1";

/// Pretty-printed JSON with a final line break. Keys are added, never renamed, within one schema. `speedup_over_scalar` is null where no difference was measured.
std::string to_json(const ThroughputResult& result, const std::string& version);

/// A row per kernel with a column per lane width, what is fastest, and the speed-up over the scalar kernel.
std::string to_table(const ThroughputResult& result);

/// "processor time of one core" and its kin.
std::string clock_words(const ThroughputResult& result);

/// What was chosen and why, with the measured scores of every width.
std::string to_table(const LaneChoice& choice, const ThroughputResult& result);

}  // namespace tyndall
