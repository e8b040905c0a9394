#pragma once
/// Pairs of an eye segment and a virtual ray light for measurements of variance: seeded, documented, the same for every sampler.
#include <cstdint>
#include <vector>

#include "kernels/dialect_host.hpp"

namespace tyndall::bench {

struct VariancePair {
    maths_double::real3 q, a, b;  ///< the light's origin seen from the eye's; directions
    double eye_length, light_length;
};

/// In a cube of side 1: both origins uniform in it, both directions uniform over the sphere, both lengths uniform in (0, 1]. From mt19937(seed), in the order
/// eye origin, eye direction, light origin, light direction, eye length, light length; numbers are its 32-bit outputs plus one half, over 2^32; a direction takes two,
/// cosine to the z axis first, then the turn.
std::vector<VariancePair> variance_pairs(std::uint32_t seed, int count);

}  // namespace tyndall::bench
