#pragma once
/// `tyndall merge`: one image from the shards of a render.
#include <filesystem>
#include <vector>

#include "cli/outputs.hpp"

namespace tyndall {

struct MergeCommand {
    std::vector<std::filesystem::path> shards;
    std::filesystem::path output, report;
    ImageWishes image;
    bool mixed_devices = false;
};

/// Merges and writes; prints the files to standard output. Returns the exit code; throws SceneError for shards that do not make up one render, IoError, UsageError.
int run_merge(const MergeCommand& command);

}  // namespace tyndall
