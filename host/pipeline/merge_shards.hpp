#pragma once
/// One render from its shards.
#include <filesystem>
#include <vector>

#include "pipeline/render_state.hpp"

namespace tyndall {

/// Adds the blocks of passes of all shards in order: the film is byte-equal to one run's. Reads every file twice and holds the films of one at a time. Settings must be equal, but
/// for device, driver and kernels with `mixed_devices`. Throws SceneError that says which files are damaged, unfinished, of another render or hold the same passes, or which passes are missing.
RenderState merge_shards(const std::vector<std::filesystem::path>& files, bool mixed_devices);

}  // namespace tyndall
