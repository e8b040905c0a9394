#pragma once
/// The hash of a scene that has no file.
#include <cstdint>

#include "tyndall/scene_description.hpp"

namespace tyndall {

/// Of every number and name in it, so that a checkpoint or a shard of another scene is told.
std::uint64_t hash_of(const api::SceneDescription& description);

}  // namespace tyndall
