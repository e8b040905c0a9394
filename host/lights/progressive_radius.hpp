#pragma once
/// How the radius of thick lights falls from pass to pass: a function of the pass alone, so that passes may be rendered anywhere and in any order.
#include <cmath>
#include <cstdint>

namespace tyndall {

inline constexpr double radius_keeps = 2. / 3;  ///< alpha: the share of variance that a pass may add to [Novak et al. 2012b; Knaus and Zwicker 2011]

/// r_(i+1)^d = r_i^d (i + alpha) / (i + 1), r_1 the first pass's (number 0), d the dimensions of the blur: the product in closed form, Gamma(i + alpha) / (Gamma(1 + alpha) i!). r^d falls as
/// i^-1/3.
inline double progressive_radius(double first, std::uint64_t pass, int dimensions = 1)
{
    const double i = static_cast<double>(pass) + 1;
    return first * std::exp((std::lgamma(i + radius_keeps) - std::lgamma(1 + radius_keeps) - std::lgamma(i + 1)) / dimensions);
}

}  // namespace tyndall
