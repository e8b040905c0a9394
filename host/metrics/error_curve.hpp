#pragma once
/// Error against time: one curve per run, and what can be read off several of them.
#include <optional>
#include <span>
#include <vector>

namespace tyndall {

/// A moment of a run, after a whole pass.
struct CurvePoint {
    int passes = 0;
    double seconds = 0;               ///< since the start of the render, positive
    double relative_mse = 0;          ///< against the reference, with the reference's own noise in it
    double trimmed_relative_mse = 0;  ///< metrics/image_error.hpp
};

/// Times ascend. Between two points the logarithm of relMSE is taken as linear in the logarithm of time.
using ErrorCurve = std::vector<CurvePoint>;

/// relMSE at `seconds`; nothing before the first point and after the last: curves are not extended. Where relMSE is 0 at one end it is that of the nearer end.
std::optional<double> relative_mse_at(const ErrorCurve& curve, double seconds);

/// Slope of log(error) over log(passes), error being the root of relMSE less `floor` (the reference's share of it): -.5 for independent passes. Least squares over the points
/// with at least a sixteenth of the passes; nothing with fewer than three of them, or where the floor is more than half of relMSE.
std::optional<double> convergence_slope(const ErrorCurve& curve, double floor);

/// Several runs of one thing at one moment.
struct Spread {
    double median = 0, low = 0, high = 0;
};

/// Median, lowest and highest; the values are not empty.
Spread spread_of(std::span<const double> values);

}  // namespace tyndall
