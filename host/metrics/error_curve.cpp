#include "metrics/error_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "metrics/mean_estimate.hpp"

namespace tyndall {

std::optional<double> relative_mse_at(const ErrorCurve& curve, double seconds)
{
    const auto after = std::ranges::lower_bound(curve, seconds, {}, &CurvePoint::seconds);
    if (after == curve.end()) return std::nullopt;
    if (after->seconds == seconds) return after->relative_mse;
    if (after == curve.begin()) return std::nullopt;
    const CurvePoint &a = *(after - 1), &b = *after;
    const double share = std::log(seconds / a.seconds) / std::log(b.seconds / a.seconds);
    if (!(a.relative_mse > 0 && b.relative_mse > 0)) return share < .5 ? a.relative_mse : b.relative_mse;
    return a.relative_mse * std::pow(b.relative_mse / a.relative_mse, share);
}

std::optional<double> convergence_slope(const ErrorCurve& curve, double floor)
{
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    for (const CurvePoint& point : curve) {
        if (point.passes * 16 < curve.back().passes) continue;
        if (!(point.relative_mse > 2 * floor)) return std::nullopt;
        const double x = std::log(double(point.passes)), y = .5 * std::log(point.relative_mse - floor);
        n += 1, sum_x += x, sum_y += y, sum_xx += x * x, sum_xy += x * y;
    }
    if (n < 3) return std::nullopt;
    return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

Spread spread_of(std::span<const double> values)
{
    assert(!values.empty());
    const auto [low, high] = std::ranges::minmax(values);
    return {median(values), low, high};
}

}  // namespace tyndall
