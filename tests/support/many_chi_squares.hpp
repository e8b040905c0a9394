#pragma once
/// Pearson's test at many geometries, judged together: one wrong geometry, a share of them, or an error too small to be seen at any single one.
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "tests/support/quadrature.hpp"

namespace tyndall::test {

/// A density on [low, high] and the draws that should follow it.
struct DrawnDensity {
    double low = 0, high = 1;
    std::vector<double> kinks{};  ///< where the density or its slope jumps
    std::function<double(double)> draw, pdf;
    std::function<long double(long double)> shape{};  ///< the density up to a factor, by a formula of its own; may be empty
};

/// Share of the draws that lie in the cells of one density, against quadrature of it.
struct ChiSquare {
    double statistic = 0, freedom = -1;
    double integral = 0;  ///< of the density
    int stray = 0;        ///< draws outside [low, high], not finite, or in cells whose probability is 0
    double p() const { return boost::math::cdf(boost::math::complement(boost::math::chi_squared(freedom), statistic)); }
};

/// Ends of the cells: where the draw puts every sixteenth and smaller and smaller shares at both ends (so that peaks of any width and long tails are resolved), eighths
/// of the interval, and the kinks. Where they lie does not matter to what is tested: what each cell should hold is integrated.
inline std::vector<double> cells_of(const DrawnDensity& d)
{
    std::vector<double> ends = d.kinks;
    for (int i = 0; i <= 16; ++i) ends.push_back(d.draw(std::min(i / 16., 1 - 0x1p-53)));
    for (int i = 7; i <= 31; i += 3) ends.push_back(d.draw(std::ldexp(1, -i))), ends.push_back(d.draw(1 - std::ldexp(1, -i)));
    for (int i = 0; i <= 8; ++i) ends.push_back(d.low + (d.high - d.low) * i / 8);
    std::erase_if(ends, [&](double x) { return !(x >= d.low && x <= d.high); });
    ends.push_back(d.low), ends.push_back(d.high);
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
}

/// Draws of which each follows the density; cells are joined until each expects 20 of them or more. `warp` is applied to the random numbers.
template <class Warp>
ChiSquare chi_square_of(const DrawnDensity& d, int draws, std::mt19937_64& engine, const Warp& warp)
{
    const std::vector<double> ends = cells_of(d);
    std::vector<double> observed(ends.size() - 1, 0);
    ChiSquare result;
    for (int i = 0; i < draws; ++i) {
        const double x = d.draw(warp(double(engine() >> 11) * 0x1p-53));
        if (!(x >= d.low && x <= d.high)) ++result.stray;
        else observed[std::min(std::size_t(std::ranges::upper_bound(ends, x) - ends.begin()) - 1, observed.size() - 1)] += 1;
    }
    std::vector<double> counts{0}, expected{0};
    for (std::size_t i = 0; i < observed.size(); ++i) {
        const double share = double(integrate([&](long double x) { return static_cast<long double>(d.pdf(double(x))); }, ends[i], ends[i + 1], 1e-6L, 16));
        if (share == 0) result.stray += int(observed[i]);
        result.integral += share;
        if (expected.back() >= 20) counts.push_back(0), expected.push_back(0);
        counts.back() += observed[i], expected.back() += share * draws;
    }
    if (expected.size() > 1 && expected.back() < 20) {
        const double last_count = counts.back(), last = expected.back();
        counts.pop_back(), expected.pop_back(), counts.back() += last_count, expected.back() += last;
    }
    for (std::size_t i = 0; i < counts.size(); ++i) result.statistic += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    result.freedom = double(counts.size()) - 1;
    return result;
}

/// Probabilities that right draws look as bad as these, all tests together; each is uniform in [0, 1] if the draws are right.
struct Verdict {
    double worst = 1;        ///< of the largest chi^2 of all (Sidak)
    double sum = 1;          ///< of the sum of all, too large or too small
    double spread = 1;       ///< of the distribution of all p (Kolmogorov and Smirnov)
    double least() const { return std::min({worst, sum, spread}); }
};

/// Kolmogorov's probability that N uniform numbers are as far from the straight line (with Stephens' correction for finite N).
inline double kolmogorov(std::vector<double> p)
{
    std::ranges::sort(p);
    const double n = double(p.size());
    double furthest = 0, probability = 0;
    for (std::size_t i = 0; i < p.size(); ++i) furthest = std::max({furthest, p[i] - double(i) / n, double(i + 1) / n - p[i]});
    const double lambda = (std::sqrt(n) + .12 + .11 / std::sqrt(n)) * furthest;
    if (lambda < .3) return 1;  // the series needs many terms there, and is 1 to five digits
    for (int k = 1; k <= 100; ++k) probability += (k % 2 ? 2 : -2) * std::exp(-2. * k * k * lambda * lambda);
    return std::clamp(probability, 0., 1.);
}

inline Verdict judged(const std::vector<ChiSquare>& all)
{
    Verdict v;
    double sum = 0, freedom = 0, least = 1;
    std::vector<double> p;
    for (const ChiSquare& c : all) {
        p.push_back(c.p()), sum += c.statistic, freedom += c.freedom;
        least = std::min(least, p.back());
    }
    v.worst = -std::expm1(double(all.size()) * std::log1p(-least));
    const boost::math::chi_squared together(freedom);
    v.sum = std::min(1., 2 * std::min(boost::math::cdf(together, sum), boost::math::cdf(boost::math::complement(together, sum))));
    v.spread = kolmogorov(std::move(p));
    return v;
}

}  // namespace tyndall::test
