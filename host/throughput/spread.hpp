#pragma once
/// What repeated measurements say, and when two of them differ.
#include <cstddef>
#include <span>
#include <vector>

namespace tyndall {

struct Spread {
    double median = 0, low = 0, high = 0;  ///< low and high: the smallest and the largest value
};

/// Of at least one value; the median of an even number of values is the mean of the middle two.
Spread spread_of(std::vector<double> values);

/// `a` is measured to be more than `b`: the ranges do not even touch. Where neither is more than the other, no difference was measured.
bool measured_above(const Spread& a, const Spread& b);

/// Indices of the largest median and of everything that is not measured to be below it, in falling order of their medians. At least one.
std::vector<std::size_t> unbeaten(std::span<const Spread> spreads);

}  // namespace tyndall
