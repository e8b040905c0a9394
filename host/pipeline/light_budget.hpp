#pragma once
/// How many virtual lights a pass has if nobody says and every eye is connected to all of them.
#include <cstdint>

#include "scene/scene.hpp"

namespace tyndall {

/// A fixed rule of image size and time budget (0: none), never of a clock, so that the bytes do not depend on the machine: the lights that 3e7 pairs per
/// second connect to every pixel in 2.5 % of the budget, between 16 and 4096, in whole blocks of 256 from there on; 128 without a budget.
std::uint32_t default_lights(const Camera& camera, double seconds);

}  // namespace tyndall
