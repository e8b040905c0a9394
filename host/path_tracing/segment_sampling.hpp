#pragma once
/// Where on a straight stretch of medium to scatter towards a light.
#include "scene/vector.hpp"

namespace tyndall {

/// The stretch as a light at `q` (relative to its start) sees it.
struct SeenStretch {
    double length;
    double foot;      ///< distance along the stretch of the point nearest to the light; may lie outside
    double distance;  ///< of the light to the line; at least 2^-52 (|q| + length), so that a light on the line has finite densities
    double angle;     ///< under which the light sees the stretch, in (0, pi]
};

SeenStretch see_stretch(const Vec3& q, const Vec3& direction, double length);

/// Distance along the stretch, in [0, length], uniform in the angle.
double sample_angle(const SeenStretch& seen, double xi);

/// Density of sample_angle at u times the square of the distance between that point and the light: constant, so nothing is divided by it.
double pdf_angle_times_square(const SeenStretch& seen);

/// Exponential distances of up to three channels, chosen by share (sums to 1); only shares > 0 are looked at.
struct ExponentialMixture {
    Rgb sigma, share;
    double length;
};
int choose_channel(const ExponentialMixture& mixture, double xi);
double sample_mixture(const ExponentialMixture& mixture, const Vec2& xi);
double pdf_mixture(const ExponentialMixture& mixture, double u);

}  // namespace tyndall
