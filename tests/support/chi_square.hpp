#pragma once
/// Pearson's test that draws follow a distribution.
#include <boost/math/distributions/chi_squared.hpp>
#include <span>
#include <stdexcept>

namespace tyndall::test {

/// Probability that chi^2 is at least as large as observed if the draws follow `expected` (same total; every expected count > 5).
/// Failing a test below p = 1e-6 raises a false alarm once in a million such tests; seeds are fixed, so it does so always or never.
inline double chi_square_p(std::span<const double> observed, std::span<const double> expected)
{
    double statistic = 0;
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (!(expected[i] > 5)) throw std::invalid_argument("chi_square_p: a cell expects no more than 5 draws; merge cells");
        statistic += (observed[i] - expected[i]) * (observed[i] - expected[i]) / expected[i];
    }
    return boost::math::cdf(boost::math::complement(boost::math::chi_squared(double(observed.size()) - 1), statistic));
}

constexpr double false_alarm_rate = 1e-6;

}  // namespace tyndall::test
