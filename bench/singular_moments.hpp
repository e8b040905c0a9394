#pragma once
/// Second moments of one sample near contact, for the four connections of point and ray lights with surfaces and eye segments, over lights that lie evenly in space and no nearer
/// than h: the kernels' own weights (kernels/README.md, sections 5, 8 and 17), integrated. Lengths in units of the farthest light counted, 1.
#include <cmath>
#include <functional>
#include <numbers>

#include "kernels/dialect_host.hpp"

namespace tyndall::singular {

using namespace maths_double;

constexpr double pi = std::numbers::pi;

/// Integral of square(D) x measure(D) dD from h to 1, mid-points in log D.
inline double moment(double h, const std::function<double(double)>& square, const std::function<double(double)>& measure)
{
    const int n = 4000;
    const double step = -std::log(h) / n;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double D = h * std::exp((i + .5) * step);
        sum += square(D) * measure(D) * D * step;
    }
    return sum;
}

/// Point lights around a surface point: 1 / w^2, seen from everywhere in the half space; the mean of the square of the cosine is 1/3.
inline double point_to_surface(double h) { return moment(h, [](double w) { return 1 / (w * w * w * w) / 3; }, [](double w) { return 2 * pi * w * w; }); }

/// Point lights around the middle of an eye segment.
inline double point_to_segment(double h)
{
    return moment(h, [](double D) { const double R = sample_equiangular({1, D, 0}, {1, 0, 0}, 2, .3).angle_over_distance; return R * R; }, [](double D) { return 2 * pi * D; });
}

/// Ray lights above a surface point, across its normal.
inline double ray_to_surface(double h)
{
    return moment(h, [](double D) { const double W = sample_surface_rod({-1, 0, D}, {1, 0, 0}, 2, {0, 0, 1}, .3).weight; return W * W; }, [](double D) { return 2 * pi * D; });
}

/// Ray lights that cross an eye segment at the distance h, at a right angle: the lines of a field cross at evenly spread distances.
inline double ray_to_segment(double h)
{
    return moment(h,
                  [](double D) {
                      double squares = 0;
                      for (int i = 0; i < 32; ++i) {
                          const real3 q{1, D, -1}, a{1, 0, 0}, b{0, 0, 1};
                          const RodSample rod = sample_rod(q, a, b, 2, (i + .5) / 32);
                          const double weight = pair_weight(rod, sample_equiangular(along3(q, rod.v, b), a, 2, .3));
                          squares += weight * weight / 32;
                      }
                      return squares;
                  },
                  [](double) { return 1.; });
}

}  // namespace tyndall::singular
