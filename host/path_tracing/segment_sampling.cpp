#include "path_tracing/segment_sampling.hpp"

#include <algorithm>
#include <cmath>

#include "transport/medium.hpp"

namespace tyndall {
namespace {

/// Below this angle sine and tangent equal the angle to the last bit of a double, and the sine form below would divide small by small.
constexpr double small_angle = 1e-9;

}  // namespace

SeenStretch see_stretch(const Vec3& q, const Vec3& direction, double length)
{
    const double foot = glm::dot(q, direction),
                 distance = std::max(glm::length(glm::cross(q, direction)), 0x1p-52 * (glm::length(q) + length));
    return {.length = length,
            .foot = foot,
            .distance = distance,
            .angle = std::atan2(distance * length, distance * distance - foot * (length - foot))};
}

double sample_angle(const SeenStretch& seen, double xi)
{
    // The offset from the start itself: going over the foot (foot + d tan) would cancel when the foot lies far outside.
    const double d = seen.distance, t0 = -seen.foot, psi = xi * seen.angle;
    if (seen.angle < small_angle) {
        const double t1 = seen.length - seen.foot;
        return std::clamp(t0 * xi * seen.length / (t1 - xi * seen.length), 0.0, seen.length);
    }
    return std::clamp((d * d + t0 * t0) * std::sin(psi) / (d * std::cos(psi) - t0 * std::sin(psi)), 0.0, seen.length);
}

double pdf_angle_times_square(const SeenStretch& seen) { return seen.distance / seen.angle; }

int choose_channel(const ExponentialMixture& mixture, double xi)
{
    int channel = 0;
    double left = xi - mixture.share[0];
    while (channel < 2 && left >= 0) left -= mixture.share[++channel];
    while (mixture.share[channel] <= 0) --channel;  // xi beyond the rounded sum of the shares
    return channel;
}

double sample_mixture(const ExponentialMixture& mixture, const Vec2& xi)
{
    const int channel = choose_channel(mixture, xi.x);
    return sample_exponential(mixture.sigma[channel], mixture.length, xi.y);
}

double pdf_mixture(const ExponentialMixture& mixture, double u)
{
    double pdf = 0;
    for (int c = 0; c < 3; ++c)
        if (mixture.share[c] > 0) pdf += mixture.share[c] * pdf_exponential(mixture.sigma[c], mixture.length, u);
    return pdf;
}

}  // namespace tyndall
