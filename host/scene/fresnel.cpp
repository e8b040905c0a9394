#include "scene/fresnel.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall {

double refracted_cosine(double cosine, double eta)
{
    const double sine2_behind = (1 - cosine * cosine) / (eta * eta);
    return sine2_behind >= 1 ? -1 : std::sqrt(1 - sine2_behind);
}

double fresnel_dielectric(double cosine, double eta)
{
    const double behind = refracted_cosine(cosine, eta);
    if (behind < 0) return 1;
    const double parallel = (eta * cosine - behind) / (eta * cosine + behind),
                 perpendicular = (cosine - eta * behind) / (cosine + eta * behind);
    return .5 * (parallel * parallel + perpendicular * perpendicular);
}

double fresnel_conductor(double cosine, double eta, double k)
{
    const double c2 = cosine * cosine, s2 = 1 - c2, difference = eta * eta - k * k - s2;
    const double a2_plus_b2 = std::sqrt(difference * difference + 4 * eta * eta * k * k);
    const double a = std::sqrt(std::max(0.0, .5 * (a2_plus_b2 + difference)));
    const double perpendicular = (a2_plus_b2 - 2 * a * cosine + c2) / (a2_plus_b2 + 2 * a * cosine + c2);
    const double parallel_ratio = (a2_plus_b2 * c2 - 2 * a * cosine * s2 + s2 * s2) / (a2_plus_b2 * c2 + 2 * a * cosine * s2 + s2 * s2);
    return .5 * (perpendicular + perpendicular * parallel_ratio);
}

double diffuse_fresnel(double eta)
{
    // From the denser side total reflection puts a kink into the integrand. What passes one way passes the other, spread over eta^2 times the solid angle.
    if (eta < 1) return 1 - (1 - diffuse_fresnel(1 / eta)) * eta * eta;
    constexpr int intervals = 512;  // Simpson's rule: 1e-11 for eta = 1.5, 1e-7 for eta = 100, where F falls from 1 within mu < .01
    double sum = 0;
    for (int i = 0; i <= intervals; ++i) {
        const double mu = double(i) / intervals, weight = i == 0 || i == intervals ? 1 : i % 2 ? 4 : 2;
        sum += weight * 2 * mu * fresnel_dielectric(mu, eta);
    }
    return sum / (3 * intervals);
}

}  // namespace tyndall
