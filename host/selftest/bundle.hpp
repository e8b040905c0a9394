#pragma once
/// Everything that a driver developer needs to see a failed case without Tyndall: kernel, options, buffers, expected values, and a program that replays it.
#include <filesystem>

#include "selftest/selftest.hpp"

namespace tyndall {

/// Throws IoError unless `folder` can be made or is an empty folder. For asking before the work.
void check_bundle_folder(const std::filesystem::path& folder);

/// Writes every failed launch of `result`, and `report` as selftest.json. Throws IoError.
void write_bundle(const std::filesystem::path& folder, const SelftestResult& result, const std::string& report);

/// replay.c: C99 and OpenCL 1.2, no other library.
const char* replay_program();

}  // namespace tyndall
