#pragma once
/// Eyes and lights in density grids, and what they exchange, by quadrature in double that shares no code with kernels/.
#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

#include "tests/device/random_pairs.hpp"

namespace tyndall::testing {

struct GridWishes {
    double g = 0;
    double extinction = 2;         ///< where a grid holds 1
    bool coloured = false;         ///< extinction, density and albedo grids with three channels
    bool albedo = false;           ///< an albedo grid
    bool short_lights = false;
    bool holes = false;            ///< half of the voxels hold 0
    bool homogeneous_beside = false;  ///< the half x < 0 is a homogeneous medium, both halves have containers
    std::uint32_t seed = 5;
};

/// 16 eyes and 6 lights in the cube [-1, 1]^3, none of them near another; grids of 7 x 6 x 5 voxels fill the cube (or its half x > 0).
RandomPairs grid_pairs(const GridWishes& wishes);

/// r, g, b per eye: sum over lights of the exact transport.
std::vector<double> grid_oracle(const RandomPairs& pairs, EyeKind kind);

}  // namespace tyndall::testing
