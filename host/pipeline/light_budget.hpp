#pragma once
/// How many virtual lights a pass has if nobody says.
#include <cstdint>

#include "scene/scene.hpp"

namespace tyndall {

/// A fixed rule of image size and time budget (0: none), never of a clock, so that the bytes do not depend on the machine: about `pairs_per_second` x 2.5 % of
/// the budget divided by the pixels, in whole blocks of 256, between 256 and 4096; 512 without a budget.
std::uint32_t default_lights(const Camera& camera, double seconds);

}  // namespace tyndall
