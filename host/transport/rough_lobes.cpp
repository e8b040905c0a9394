#include "transport/rough_lobes.hpp"

#include <algorithm>
#include <cmath>

#include "scene/fresnel.hpp"
#include "scene/microfacet.hpp"
#include "scene/plastic.hpp"
#include "transport/warp.hpp"

namespace tyndall {
namespace {

/// Share of samples of a facet that are reflected rather than refracted.
double reflected_share(const Side& side, double fresnel)
{
    const double reflected = fresnel * largest(side.reflectance), refracted = (1 - fresnel) * largest(side.transmittance);
    return reflected > 0 ? reflected / (reflected + refracted) : 0;
}

/// Share of samples that go to the facets rather than to what lies below them; Mitsuba's.
double glossy_share(const Side& side, double transmittance)
{
    const double glossy = (1 - transmittance) * largest(side.reflectance), below = transmittance * largest(side.diffuse);
    return glossy > 0 ? glossy / (glossy + below) : 0;
}

/// What a perfectly mirroring surface of these facets would do: D G1(from) G1(out) / (4 from.z), and the density of its samples.
struct Mirrored {
    double facing;  ///< cosine between `from` and the facet's normal
    double value, pdf;
};
Mirrored mirror(const Side& side, const Vec3& from, const Vec3& out)
{
    const Roughness& r = side.bsdf->roughness;
    const Vec3 h = glm::normalize(from + out);
    const double pdf = .25 * seen_over_cosine(r, from) * facet_density(r, h);
    return {.facing = std::min(glm::dot(from, h), 1.0), .value = pdf * seen_share(r, out), .pdf = pdf};
}

Scattering scatter_conductor(const Side& side, const Vec3& from, const Vec3& out)
{
    if (!(out.z > 0)) return {};
    const Mirrored m = mirror(side, from, out);
    Rgb fresnel;
    for (int c = 0; c < 3; ++c) fresnel[c] = fresnel_conductor(m.facing, side.bsdf->conductor_eta[c], side.bsdf->conductor_k[c]);
    return {.value = side.reflectance * fresnel * m.value, .pdf = m.pdf};
}

Scattering reflect_dielectric(const Side& side, const Vec3& from, const Vec3& out)
{
    const Mirrored m = mirror(side, from, out);
    const double fresnel = fresnel_dielectric(m.facing, side.eta());
    return {.value = side.reflectance * (fresnel * m.value), .pdf = m.pdf * reflected_share(side, fresnel)};
}

Scattering refract_dielectric(const Side& side, const Vec3& from, const Vec3& out)
{
    const Roughness& r = side.bsdf->roughness;
    const double eta = side.eta();
    Vec3 h = glm::normalize(from + eta * out);
    if (h.z < 0) h = -h;
    const double before = glm::dot(from, h), behind = glm::dot(out, h);
    if (!(before > 0) || !(behind < 0)) return {};
    const double fresnel = fresnel_dielectric(std::min(before, 1.0), eta), sum = before + eta * behind;
    // per steradian of `out`: facets' normals per steradian of theirs, times dh/dout
    const double density = seen_over_cosine(r, from) * before * facet_density(r, h) * (eta * eta * -behind / (sum * sum));
    return {.value = side.transmittance * ((1 - fresnel) * density * seen_share(r, out)), .pdf = density * (1 - reflected_share(side, fresnel))};
}

Scattering scatter_plastic(const Side& side, const Vec3& from, const Vec3& out)
{
    if (!(out.z > 0)) return {};
    const Bsdf& b = *side.bsdf;
    const Mirrored m = mirror(side, from, out);
    const double in = plastic_transmittance(b, from.z), back = plastic_transmittance(b, out.z), share = glossy_share(side, in);
    const Rgb again = b.nonlinear ? side.diffuse * b.internal_reflectance : Rgb(b.internal_reflectance);
    const Rgb below = side.diffuse / (1.0 - again) * (in * back / (b.eta * b.eta) * pdf_cosine_hemisphere(out.z));
    return {.value = side.reflectance * (fresnel_dielectric(m.facing, b.eta) * m.value) + below, .pdf = share * m.pdf + (1 - share) * pdf_cosine_hemisphere(out.z)};
}

/// 0 if the facet mirrors into the surface: that light is lost, and belongs to no other direction.
Vec3 reflected(const Vec3& from, const Vec3& h)
{
    const Vec3 out = 2 * glm::dot(from, h) * h - from;
    return out.z > 0 ? out : Vec3(0);
}

Vec3 refracted(const Vec3& from, const Vec3& h, double eta)
{
    const double facing = glm::dot(from, h), behind = refracted_cosine(std::min(facing, 1.0), eta);
    const Vec3 out = (facing / eta - behind) * h - from / eta;
    return behind >= 0 && out.z < 0 ? out : Vec3(0);
}

/// The bits of xi make two numbers: 27 for the facet, 26 for what it does.
Vec3 sample_dielectric(const Side& side, const Vec3& from, const Vec2& xi)
{
    const double scaled = xi.x * 0x1p27, high = std::floor(scaled), choice = scaled - high;
    const Vec3 h = sample_seen_facet(side.bsdf->roughness, from, {(high + .5) * 0x1p-27, xi.y});
    const double fresnel = fresnel_dielectric(std::clamp(glm::dot(from, h), 0.0, 1.0), side.eta());
    return choice < reflected_share(side, fresnel) ? reflected(from, h) : refracted(from, h, side.eta());
}

Vec3 sample_plastic(const Side& side, const Vec3& from, Vec2 xi)
{
    const double share = glossy_share(side, plastic_transmittance(*side.bsdf, from.z));
    if (xi.x >= share) return sample_cosine_hemisphere({rescale(xi.x, share, 1), xi.y});
    return reflected(from, sample_seen_facet(side.bsdf->roughness, from, {rescale(xi.x, 0, share), xi.y}));
}

}  // namespace

Scattering scatter_rough(const Side& side, const Vec3& from, const Vec3& out)
{
    switch (side.bsdf->type) {
        case Bsdf::Type::rough_conductor: return scatter_conductor(side, from, out);
        case Bsdf::Type::rough_dielectric: return out.z > 0 ? reflect_dielectric(side, from, out) : refract_dielectric(side, from, out);
        case Bsdf::Type::rough_plastic: return scatter_plastic(side, from, out);
        default: return {};
    }
}

Vec3 sample_rough(const Side& side, const Vec3& from, const Vec2& xi)
{
    switch (side.bsdf->type) {
        case Bsdf::Type::rough_conductor: return reflected(from, sample_seen_facet(side.bsdf->roughness, from, xi));
        case Bsdf::Type::rough_dielectric: return sample_dielectric(side, from, xi);
        case Bsdf::Type::rough_plastic: return sample_plastic(side, from, xi);
        default: return Vec3(0);
    }
}

}  // namespace tyndall
