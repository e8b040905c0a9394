#pragma once
/// The masks that every test means by "every variant": what a scene calls for, that with every single further feature, and all features.
#include <vector>

#include "kernels/shared/host_features.hpp"

namespace tyndall::test {

/// A mask that can be built: where connections are walked on the host, that walk answers for occluders too.
constexpr std::uint32_t buildable(std::uint32_t mask) { return mask & feature_bit::nonconvex_media ? mask | feature_bit::occluders : mask; }

constexpr std::uint32_t every_feature = []() {
    std::uint32_t mask = 0;
    for (const SceneFeature& feature : scene_feature_list) mask |= feature.bit;
    return mask;
}();

/// `own` with every single feature that it lacks, then all features. Without `own` itself.
inline std::vector<std::uint32_t> supersets_of(std::uint32_t own)
{
    std::vector<std::uint32_t> masks;
    for (const SceneFeature& feature : scene_feature_list)
        if (!(own & feature.bit)) masks.push_back(buildable(own | feature.bit));
    masks.push_back(every_feature);
    return masks;
}

/// `own` without every single feature that it has; what is left of it is buildable if `own` is.
inline std::vector<std::uint32_t> subsets_of(std::uint32_t own)
{
    std::vector<std::uint32_t> masks;
    for (const SceneFeature& feature : scene_feature_list)
        if (own & feature.bit) masks.push_back(own & ~feature.bit);
    return masks;
}

}  // namespace tyndall::test
