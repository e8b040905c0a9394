#include "scene/microfacet.hpp"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

#include "scene/fresnel.hpp"

namespace tyndall {
namespace {

using std::numbers::inv_sqrtpi;
using std::numbers::pi;

/// Length of w's part along the surface, as facets of slope 1 would see it.
double stretched_sine(const Roughness& r, const Vec3& w) { return std::hypot(r.alpha_u * w.x, r.alpha_v * w.y); }

Vec3 sample_cap(const Vec3& w, const Vec2& xi)
{
    const double z = (1 - xi.x) * (1 + w.z) - w.z, r = std::sqrt(std::max(0.0, (1 - z) * (1 + z))), phi = 2 * pi * xi.y;
    return Vec3(r * std::cos(phi), r * std::sin(phi), z) + w;
}

/// Slope along w, by its distribution: up to a factor c sqrt(pi) erfc(-x) + s exp(-x^2) for x up to c/s, c and s being w's cosine and sine. Newton's method inside a bracket
/// that halves where Newton leaves it.
double sample_seen_slope(double cosine, double sine, double xi)
{
    const auto below = [&](double x) { return cosine / inv_sqrtpi * std::erfc(-x) + sine * std::exp(-x * x); };
    constexpr double steepest = 6.5;  // beyond it lie 4e-20 of all facets, less than the last bit of xi
    double low = -steepest, high = sine > 0 ? std::min(cosine / sine, steepest) : steepest;
    const double target = xi * below(high);
    double x = std::clamp(boost::math::erf_inv(std::clamp(2 * xi - 1, -.999999, .999999)), low, high);
    for (int step = 0; step < 60 && high - low > 1e-15 * steepest; ++step) {
        const double error = below(x) - target, slope = 2 * (cosine - sine * x) * std::exp(-x * x);
        if (std::abs(error) <= 0x1p-52 * target) break;
        (error > 0 ? high : low) = x;
        const double next = x - error / slope;
        x = next > low && next < high ? next : .5 * (low + high);
    }
    return x;
}

Vec3 sample_gaussian(const Vec3& w, const Vec2& xi)
{
    const double sine = std::hypot(w.x, w.y);
    const double along = sample_seen_slope(w.z, sine, xi.x);
    const double across = boost::math::erf_inv(std::clamp(2 * xi.y - 1, -1 + 0x1p-52, 1 - 0x1p-52));  // erf_inv(1) is infinite
    const double c = sine > 0 ? w.x / sine : 1, s = sine > 0 ? w.y / sine : 0;
    return {-(c * along - s * across), -(s * along + c * across), 1};
}

}  // namespace

double facet_density(const Roughness& r, const Vec3& h)
{
    if (!(h.z > 0)) return 0;
    const double x = h.x / r.alpha_u, y = h.y / r.alpha_v, z2 = h.z * h.z, area = pi * r.alpha_u * r.alpha_v;
    if (r.type == Roughness::Type::ggx) {
        const double square = x * x + y * y + z2;
        return 1 / (area * square * square);
    }
    const double exponent = (x * x + y * y) / z2;
    return exponent < 700 ? std::exp(-exponent) / (area * z2 * z2) : 0;  // 700: before exp underflows, and z2 with it
}

double seen_over_cosine(const Roughness& r, const Vec3& w)
{
    const double cosine = std::abs(w.z), sine = stretched_sine(r, w);
    if (r.type == Roughness::Type::ggx) return 2 / (cosine + std::hypot(cosine, sine));
    const double a = cosine / sine;  // infinite from straight above, where erf is 1 and the rest 0
    return 2 / (cosine * (1 + std::erf(a)) + sine * inv_sqrtpi * std::exp(-a * a));
}

double seen_share(const Roughness& r, const Vec3& w) { return std::abs(w.z) * seen_over_cosine(r, w); }

double pdf_seen_facet(const Roughness& r, const Vec3& w, const Vec3& h)
{
    return seen_over_cosine(r, w) * std::max(glm::dot(w, h), 0.0) * facet_density(r, h);
}

Vec3 sample_seen_facet(const Roughness& r, const Vec3& w, const Vec2& xi)
{
    const Vec3 stretched = glm::normalize(Vec3(r.alpha_u * w.x, r.alpha_v * w.y, w.z));
    const Vec3 h = r.type == Roughness::Type::ggx ? sample_cap(stretched, xi) : sample_gaussian(stretched, xi);
    return glm::normalize(Vec3(r.alpha_u * h.x, r.alpha_v * h.y, std::max(h.z, 0.0)));
}

double facet_reflectance(const Roughness& r, double cosine, double eta)
{
    // A Fibonacci lattice: total reflection is a step across the square of random numbers, on which a grid of as many points does far worse.
    constexpr int points = 1597, generator = 987;
    const Vec3 w(std::sqrt((1 - cosine) * (1 + cosine)), 0, cosine);
    double sum = 0;
    for (int i = 0; i < points; ++i) {
        const Vec3 h = sample_seen_facet(r, w, {(i + .5) / points, (i * generator % points + .5) / points});
        const double facing = glm::dot(w, h);
        const Vec3 out = 2 * facing * h - w;
        if (facing > 0 && out.z > 0) sum += fresnel_dielectric(std::min(facing, 1.0), eta) * seen_share(r, out);
    }
    return sum / points;
}

}  // namespace tyndall
