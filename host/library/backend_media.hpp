#pragma once
/// The caller's media and containers as tables of kernels, and which features those call for.
#include "library/backend_records.hpp"
#include "scene/scene_features.hpp"

namespace tyndall {

struct BackendMedia {
    Scene scene;             ///< media and volumes alone, in render space
    SceneFeatures features;  ///< the same masks for both kinds of eyes, and the containers

    /// Throws SceneError, UsageError.
    BackendMedia(const api::BackendDescription& description, const BackendSpace& space);
    /// Of voxels on the device.
    std::uint64_t bytes() const;
};

}  // namespace tyndall
