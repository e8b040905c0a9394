#pragma once
/// Building the programs of everyday scenes before they are needed, so that the driver's own cache has them.
#include <vector>

#include "device/pair_stage.hpp"

namespace tyndall {

/// Programs of scenes with any mix of anisotropic and coloured media and occluders, and with a grey density grid in place of colour, in one container or without bounds,
/// with long lights and every length of path, for both kinds of eye and the given lane width; samplers as `auto` chooses them.
std::vector<PairProgram> everyday_programs(int lanes);

/// Builds the program and runs it once on nothing: some drivers finish the compilation only there.
void prebuild(Device& device, const PairProgram& program);

}  // namespace tyndall
