#pragma once
/// The scene's media and their containers as the device reads them.
#include "device/pair_stage.hpp"
#include "scene/scene_features.hpp"

namespace tyndall {

MediaTables media_tables(const Scene& scene, const SceneFeatures& features);

}  // namespace tyndall
