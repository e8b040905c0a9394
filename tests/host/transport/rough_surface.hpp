#pragma once
/// Surfaces with facets, and formulas for them that share nothing with the renderer: Walter et al. 2007 as printed, through slopes and angles, with Smith's shadowing integrated
/// from the distribution of slopes instead of taken from its closed form.
#include <algorithm>
#include <complex>

#include "built_scene.hpp"
#include "scene/plastic.hpp"
#include "statistics.hpp"
#include "transport/bsdf.hpp"

namespace tyndall::test {

/// One square facing +z at the origin, with the given BSDF.
struct Surface {
    BuiltScene built;
    Hit hit{.t = 1, .position = Vec3(0), .geometric_normal = {0, 0, 1}, .shading_normal = {0, 0, 1}, .shape = 0, .primitive = 0};
    explicit Surface(Bsdf b)
    {
        if (b.type == Bsdf::Type::plastic || b.type == Bsdf::Type::rough_plastic) prepare_plastic(b);
        built.square(Vec3(0), {0, 0, 1}, 1, built.bsdf(b));
    }
    const Scene& scene() const { return built.scene; }
    Arrival arriving(const Vec3& in, TransportMode mode = TransportMode::importance) const { return {.hit = hit, .in = in, .mode = mode}; }
};

/// The direction of travel of light that arrives at this cosine (from above if > 0) and azimuth.
inline Vec3 arriving(double cosine, double turn) { return -spherical(cosine, turn); }

/// Density of facets' slopes, per unit of slope squared.
inline long double slope_density(const Roughness& r, long double x, long double y)
{
    const long double p = 3.14159265358979323846L, q = x * x / (r.alpha_u * r.alpha_u) + y * y / (r.alpha_v * r.alpha_v), area = p * r.alpha_u * r.alpha_v;
    return r.type == Roughness::Type::ggx ? 1 / (area * (1 + q) * (1 + q)) : std::exp(-q) / area;
}

/// Smith's masking for isotropic roughness: 1 / (1 + Lambda), Lambda the mean of the slopes steeper than the direction, over the direction's own slope [Smith 1967].
inline long double masking_oracle(const Roughness& r, long double cosine)
{
    cosine = std::fabs(cosine);
    if (cosine >= 1) return 1;
    const long double slope = cosine / std::sqrt(1 - cosine * cosine), a = r.alpha_u;
    // distribution of the slope along one axis
    const auto along = [&](long double x) {
        return r.type == Roughness::Type::ggx ? a * a / (2 * std::pow(a * a + x * x, 1.5L)) : std::exp(-x * x / (a * a)) / (a * 1.77245385090551602730L);
    };
    // x = slope + t / (1 - t) covers the tail
    const auto tail = [&](long double t) { return t / (1 - t) * along(slope + t / (1 - t)) / ((1 - t) * (1 - t)); };
    return 1 / (1 + integrate(tail, 0, 1 - 1e-9L, 1e-13L, 30) / slope);
}

/// Fresnel's equations with complex amplitudes; eta may be complex (eta + i k).
inline long double fresnel_oracle(long double cosine, std::complex<long double> eta)
{
    const std::complex<long double> behind = std::sqrt(1.0L - (1 - cosine * cosine) / (eta * eta));
    const auto s = (cosine - eta * behind) / (cosine + eta * behind), p = (eta * cosine - behind) / (eta * cosine + behind);
    return .5L * (std::norm(s) + std::norm(p));
}

/// Reflection at facets, for i and o above: F D G / (4 |i.n| |o.n|) times |o.n| [eq. 20].
inline long double reflection_oracle(const Roughness& r, std::complex<long double> eta, const Vec3& i, const Vec3& o)
{
    const Vec3 h = glm::normalize(i + o);
    const long double c = h.z, d = slope_density(r, h.x / c, h.y / c) / (c * c * c * c);
    return fresnel_oracle(glm::dot(i, h), eta) * d * masking_oracle(r, i.z) * masking_oracle(r, o.z) / (4 * std::fabs(i.z));
}

/// Refraction at facets for flux, o below: |i.h| |o.h| / (|i.n| |o.n|) eta_o^2 (1 - F) G D / (eta_i i.h + eta_o o.h)^2 times |o.n| [eq. 21].
inline long double refraction_oracle(const Roughness& r, long double eta, const Vec3& i, const Vec3& o)
{
    Vec3 h = glm::normalize(i + double(eta) * o);
    if (h.z < 0) h = -h;
    const long double ih = glm::dot(i, h), oh = glm::dot(o, h), c = h.z, d = slope_density(r, h.x / c, h.y / c) / (c * c * c * c);
    if (ih <= 0 || oh >= 0) return 0;
    const long double sum = ih + eta * oh;
    return ih * std::fabs(oh) / std::fabs(i.z) * eta * eta * (1 - fresnel_oracle(ih, eta)) * masking_oracle(r, i.z) * masking_oracle(r, o.z) * d / (sum * sum);
}

/// Integral over directions with z in [low, high], turn in [from, to] of 2 pi: Gauss rules in pieces, which halve towards the poles and the horizon, where rough surfaces have their peaks.
/// Not adaptive: the kink where a facet is seen edge-on may lie anywhere, and costs some 1e-4 of the whole.
template <class F>
double over_patch(const F& f, double low, double high, double from = 0, double to = 1)
{
    const auto at = [&](long double z) {
        long double sum = 0;
        constexpr int pieces = 6;
        for (int i = 0; i < pieces; ++i)
            sum += gauss([&](long double turn) { return (long double)f(spherical(double(z), double(turn))); }, from + (to - from) * i / pieces, from + (to - from) * (i + 1) / pieces);
        return sum;
    };
    std::vector<double> ends{low, high};
    for (double part = .5; part > 1e-3; part /= 2) {
        for (const double end : {-1., 0., 1.}) ends.push_back(end - part), ends.push_back(end + part);
    }
    std::erase_if(ends, [&](double z) { return z < low || z > high; });
    std::ranges::sort(ends);
    double sum = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (ends[i] < ends[i + 1]) sum += double(gauss(at, ends[i], ends[i + 1]));
    return sum * 2 * pi;
}
/// All directions.
template <class F>
double over_directions(const F& f)
{
    double sum = 0;
    for (const double end : {-1., 0.})
        for (int quarter = 0; quarter < 4; ++quarter) sum += over_patch(f, end, end + 1, .25 * quarter, .25 * (quarter + 1));
    return sum;
}

/// Probability that draws of directions that follow `pdf` look as bad as these; 12 x 8 cells, those that expect few merged.
template <class Sample, class Pdf>
double draws_p(int draws, const Sample& sample, const Pdf& pdf)
{
    constexpr int rows = 12, columns = 8;
    std::vector<double> counts(rows * columns, 0.0), observed{0}, expected{0};
    for (int i = 0; i < draws; ++i) {
        const Vec3 d = sample();
        const double turn = std::atan2(d.y, d.x) / (2 * pi);
        ++counts[std::size_t(std::min(int(.5 * (d.z + 1) * rows), rows - 1) * columns + std::min(int((turn < 0 ? turn + 1 : turn) * columns), columns - 1))];
    }
    for (int cell = 0; cell < rows * columns; ++cell) {
        const double low = -1 + 2.0 * (cell / columns) / rows, from = double(cell % columns) / columns;
        const double mass = draws * over_patch(pdf, low, low + 2.0 / rows, from, from + 1.0 / columns);
        const bool rare = mass < 8;
        if (!rare) observed.push_back(0), expected.push_back(0);
        (rare ? observed.front() : observed.back()) += counts[std::size_t(cell)], (rare ? expected.front() : expected.back()) += mass;
    }
    if (expected.front() <= 5) expected.back() += expected.front(), observed.back() += observed.front(), expected.erase(expected.begin()), observed.erase(observed.begin());
    return chi_square_p(observed, expected);
}

/// The rough surfaces that tests go through, by name.
struct NamedBsdf {
    const char* name;
    Bsdf bsdf;
};
inline void PrintTo(const NamedBsdf& b, std::ostream* out) { *out << b.name; }

inline std::vector<NamedBsdf> rough_bsdfs()
{
    using Type = Bsdf::Type;
    using Facets = Roughness::Type;
    const Rgb gold(.143, .375, 1.44), absorbs(3.98, 2.39, 1.6);
    return {{"conductor_beckmann", {.type = Type::rough_conductor, .reflectance = Rgb(1), .conductor_eta = gold, .conductor_k = absorbs, .roughness = {Facets::beckmann, .3, .3}}},
            {"conductor_ggx", {.type = Type::rough_conductor, .reflectance = Rgb(1), .conductor_eta = Rgb(0), .conductor_k = Rgb(1), .roughness = {Facets::ggx, .2, .2}}},
            {"conductor_anisotropic", {.type = Type::rough_conductor, .reflectance = {1, .8, .5}, .conductor_eta = gold, .conductor_k = absorbs, .roughness = {Facets::ggx, .5, .15}}},
            {"glass_beckmann", {.type = Type::rough_dielectric, .reflectance = Rgb(1), .eta = 1.5, .roughness = {Facets::beckmann, .25, .25}}},
            {"glass_ggx", {.type = Type::rough_dielectric, .reflectance = {.9, 1, 1}, .specular_transmittance = {.8, .9, 1}, .eta = 1.33, .roughness = {Facets::ggx, .4, .4}}},
            {"glass_anisotropic", {.type = Type::rough_dielectric, .reflectance = Rgb(1), .eta = 2, .roughness = {Facets::beckmann, .2, .5}}},
            {"plastic_smooth", {.type = Type::plastic, .reflectance = Rgb(1), .eta = 1.49, .diffuse = {.2, .5, .9}, .nonlinear = true}},
            {"plastic_beckmann", {.type = Type::rough_plastic, .reflectance = Rgb(1), .eta = 1.49, .roughness = {Facets::beckmann, .3, .3}, .diffuse = {.2, .5, .9}}},
            {"plastic_ggx", {.type = Type::rough_plastic, .reflectance = Rgb(.7), .eta = 1.9, .roughness = {Facets::ggx, .2, .2}, .diffuse = Rgb(1), .nonlinear = true}}};
}

}  // namespace tyndall::test
