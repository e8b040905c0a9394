#pragma once
/// The host's door to the records that cross the border: the same files that the device reads, in namespace tyndall.
#include <cstdint>

namespace tyndall {

using uint = std::uint32_t;
#pragma push_macro("LAYOUT")
#undef LAYOUT
#define LAYOUT(Type, bytes) static_assert(sizeof(Type) == (bytes) && alignof(Type) == 4, #Type " differs between host and device");
#include "kernels/shared/container.h"
#include "kernels/shared/eye_block.h"
#include "kernels/shared/eye_point.h"
#include "kernels/shared/eye_segment.h"
#include "kernels/shared/grid.h"
#include "kernels/shared/light_choice.h"
#include "kernels/shared/medium.h"
#include "kernels/shared/phase_lobe.h"
#include "kernels/shared/samplers.h"
#include "kernels/shared/scene_features.h"
#include "kernels/shared/shadow_packet.h"
#include "kernels/shared/transmittance_modes.h"
#pragma pop_macro("LAYOUT")

}  // namespace tyndall
