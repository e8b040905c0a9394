#pragma once
/// Kernels with an error in them.
#include <stdexcept>
#include <string>

#include "device/kernel_source.hpp"

namespace tyndall::test {

/// The selftest's kernel with `right`, which must occur once, replaced by `wrong`.
inline std::string planted_kernel(const std::string& right, const std::string& wrong)
{
    std::string text = flattened_kernel("kernels/selftest/evaluate_cases.cl", {});
    const std::size_t at = text.find(right);
    if (at == std::string::npos || text.find(right, at + 1) != std::string::npos) throw std::logic_error("\"" + right + "\" does not occur once in the kernel");
    return text.replace(at, right.size(), wrong);
}

/// Weights of pairs off by one part in a thousand.
inline std::string wrong_weights() { return planted_kernel("outputs(pair_weight(rod, angle),", "outputs(pair_weight(rod, angle) * R(1.001),"); }

/// Potentials of rods off by one part in a hundred thousand.
inline std::string wrong_potentials() { return planted_kernel("outputs(s.potential, s.v,", "outputs(s.potential * R(1.00001), s.v,"); }

}  // namespace tyndall::test
