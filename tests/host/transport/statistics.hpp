#pragma once
/// Means with error bars, and directions in cells, for tests of samplers. A z-test at `allowed_sigmas` raises a false alarm once in 1.7
/// million.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/chi_square.hpp"
#include "support/quadrature.hpp"
#include "transport/random_sequence.hpp"
#include "transport/warp.hpp"

namespace tyndall::test {

constexpr double allowed_sigmas = 5;

class Mean {
public:
    void add(double x) { ++n_, sum_ += x, squares_ += x * x; }
    double value() const { return sum_ / n_; }
    double variance_of_mean() const { return std::max(0.0, squares_ / n_ - value() * value()) / (n_ - 1); }
    double error() const { return std::sqrt(variance_of_mean()); }

private:
    double n_ = 0, sum_ = 0, squares_ = 0;
};

inline void expect_mean(const Mean& mean, double expected, const char* what = "")
{
    EXPECT_NEAR(mean.value(), expected, allowed_sigmas * mean.error() + 1e-12 * std::abs(expected))
        << what << ", standard error " << mean.error();
}
inline void expect_same(const Mean& a, const Mean& b, const char* what = "")
{
    EXPECT_NEAR(a.value(), b.value(), allowed_sigmas * std::sqrt(a.variance_of_mean() + b.variance_of_mean())) << what;
}

/// p-value that directions drawn by sample() follow pdf(direction): cells in z and azimuth, those that expect few draws merged into one.
template <class Sample, class Pdf>
double direction_p(int draws, const Sample& sample, const Pdf& pdf)
{
    constexpr int rows = 16, columns = 12;
    std::vector<double> counts(rows * columns, 0.0), observed{0}, expected{0};
    for (int i = 0; i < draws; ++i) {
        const Vec3 d = sample();
        const int row = std::min(int(.5 * (d.z + 1) * rows), rows - 1);
        const int column = std::min(int((std::atan2(d.y, d.x) / (2 * pi) + .5) * columns), columns - 1);
        ++counts[row * columns + column];
    }
    for (int cell = 0; cell < rows * columns; ++cell) {
        const double z0 = -1 + 2.0 * (cell / columns) / rows, phi0 = 2 * pi * (double(cell % columns) / columns - .5);
        const auto over_azimuth = [&](long double z) {
            return integrate([&](long double phi) { return (long double)pdf(spherical(double(z), double(phi) / (2 * pi))); }, phi0,
                             phi0 + 2 * pi / columns, 1e-9L, 12);
        };
        const double mass = draws * double(integrate(over_azimuth, z0, z0 + 2.0 / rows, 1e-9L, 12));
        const bool rare = mass < 8;
        if (!rare) observed.push_back(0), expected.push_back(0);
        (rare ? observed.front() : observed.back()) += counts[cell], (rare ? expected.front() : expected.back()) += mass;
    }
    if (expected.front() <= 5) {
        observed[1] += observed.front(), expected[1] += expected.front();
        observed.erase(observed.begin()), expected.erase(expected.begin());
    }
    return chi_square_p(observed, expected);
}

inline RandomSequence numbers(std::uint64_t which) { return {17, 0, RandomStream::pilot, which}; }

}  // namespace tyndall::test
