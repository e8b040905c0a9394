#pragma once
/// The feature list as the host's bits and names.
#include <array>
#include <cstdint>
#include <string_view>

#include "kernels/shared/records.hpp"

namespace tyndall {

struct SceneFeature {
    std::string_view name;
    std::uint32_t bit;  ///< mask with one bit
    std::string_view meaning;
};

#define TYNDALL_FEATURE_ROW(name, number, text) SceneFeature{#name, 1u << number, text},
inline constexpr std::array scene_feature_list{SCENE_FEATURES(TYNDALL_FEATURE_ROW)};
#undef TYNDALL_FEATURE_ROW

namespace feature_bit {
#define TYNDALL_FEATURE_BIT(name, number, text) name##_ = 1u << number,
enum : std::uint32_t { SCENE_FEATURES(TYNDALL_FEATURE_BIT) };
#undef TYNDALL_FEATURE_BIT
inline constexpr std::uint32_t anisotropic = ANISOTROPIC_, coloured = COLOURED_, occluders = OCCLUDERS_, many_media = MANY_MEDIA_, boundaries = BOUNDARIES_,
                               nonconvex_media = NONCONVEX_MEDIA_, short_lights = SHORT_LIGHTS_, depth_limit = DEPTH_LIMIT_, phase_lobes = PHASE_LOBES_,
                               heterogeneous = HETEROGENEOUS_, coloured_grids = COLOURED_GRIDS_;
}  // namespace feature_bit

}  // namespace tyndall
