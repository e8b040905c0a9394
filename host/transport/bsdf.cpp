#include "transport/bsdf.hpp"

#include "scene/plastic.hpp"
#include "transport/rough_lobes.hpp"
#include "transport/surface_side.hpp"
#include "transport/warp.hpp"

namespace tyndall {
namespace {

Vec3 mirrored(const Vec3& in, const Vec3& normal) { return glm::normalize(in - 2 * glm::dot(in, normal) * normal); }

/// `weight` of light that is mirrored.
BsdfSample reflect(const Side& side, const Arrival& arrival, const Rgb& weight)
{
    const Vec3 out = mirrored(arrival.in, side.shading);
    if (!reflects_consistently(side, arrival.in, out)) return {};
    return {.direction = out, .weight = weight * mode_factor(side, arrival, out), .delta = true};
}

BsdfSample refract(const Side& side, const Arrival& arrival, const Rgb& weight)
{
    const double cosine = -glm::dot(arrival.in, side.shading), eta = side.eta();
    const double cosine_behind = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (eta * eta)));
    const Vec3 out = glm::normalize(arrival.in / eta + (cosine / eta - cosine_behind) * side.shading);
    if (!(glm::dot(out, side.geometric) < 0)) return {};
    return {.direction = out, .weight = weight * mode_factor(side, arrival, out), .delta = true, .transmitted = true};
}

BsdfSample sample_diffuse(const Side& side, const Arrival& arrival, const Vec2& xi)
{
    const Vec3 out = Frame(side.shading).to_world(sample_cosine_hemisphere(xi));
    if (!reflects_consistently(side, arrival.in, out)) return {};
    return {.direction = out, .weight = side.reflectance * mode_factor(side, arrival, out), .pdf = pdf_cosine_hemisphere(glm::dot(out, side.shading))};
}

BsdfSample sample_conductor(const Side& side, const Arrival& arrival)
{
    const double cosine = -glm::dot(arrival.in, side.shading);
    Rgb weight = side.reflectance;
    for (int c = 0; c < 3; ++c) weight[c] *= fresnel_conductor(cosine, side.bsdf->conductor_eta[c], side.bsdf->conductor_k[c]);
    return reflect(side, arrival, weight);
}

BsdfSample sample_dielectric(const Side& side, const Arrival& arrival, double xi)
{
    const double cosine = -glm::dot(arrival.in, side.shading);
    if (!(cosine > 0)) return {};
    const bool thin = side.bsdf->type == Bsdf::Type::thin_dielectric;
    double f = fresnel_dielectric(cosine, thin ? side.bsdf->eta : side.eta());
    if (thin) f = 2 * f / (1 + f);  // between the two faces of the sheet, any number of times
    const double reflected = f * largest(side.reflectance), transmitted = (1 - f) * largest(side.transmittance);
    if (!(reflected + transmitted > 0)) return {};
    const double probability = reflected / (reflected + transmitted);
    if (xi < probability) return reflect(side, arrival, side.reflectance * (f / probability));
    const Rgb weight = side.transmittance * ((1 - f) / (1 - probability));
    return thin ? BsdfSample{.direction = arrival.in, .weight = weight, .delta = true, .transmitted = true} : refract(side, arrival, weight);
}

/// What a smooth boundary lets in and, after diffuse reflection below, out again: BSDF x cosine over the density of a cosine-distributed direction.
Rgb below_plastic(const Side& side, double cosine_in, double cosine_out)
{
    const Bsdf& b = *side.bsdf;
    const Rgb again = b.nonlinear ? side.diffuse * b.internal_reflectance : Rgb(b.internal_reflectance);
    return side.diffuse / (1.0 - again) * (plastic_transmittance(b, cosine_in) * plastic_transmittance(b, cosine_out) / (b.eta * b.eta));
}

/// Probability with which a smooth plastic is sampled as a mirror; Mitsuba's.
double mirror_share(const Side& side, double cosine)
{
    const double f = fresnel_dielectric(cosine, side.bsdf->eta), mirrors = f * largest(side.reflectance), below = (1 - f) * largest(side.diffuse);
    return mirrors > 0 ? mirrors / (mirrors + below) : 0;
}

Rgb plastic_mirror(const Side& side, double cosine) { return side.reflectance * fresnel_dielectric(cosine, side.bsdf->eta); }

BsdfSample sample_plastic(const Side& side, const Arrival& arrival, Vec2 xi)
{
    const double cosine = -glm::dot(arrival.in, side.shading);
    if (!(cosine > 0)) return {};
    const double share = mirror_share(side, cosine);
    if (xi.x < share) return reflect(side, arrival, plastic_mirror(side, cosine) / share);
    const Vec3 local = sample_cosine_hemisphere({rescale(xi.x, share, 1), xi.y}), out = Frame(side.shading).to_world(local);
    if (!reflects_consistently(side, arrival.in, out) || !(local.z > 0)) return {};
    return {.direction = out,
            .weight = below_plastic(side, cosine, local.z) * (mode_factor(side, arrival, out) / (1 - share)),
            .pdf = (1 - share) * pdf_cosine_hemisphere(local.z)};
}

BsdfSample sample_facets(const Scene& scene, const Side& side, const Arrival& arrival, const Vec2& xi)
{
    const Frame frame = facet_frame(scene, side, arrival.hit);
    const Vec3 from = frame.to_local(-arrival.in);
    if (!(from.z > 0)) return {};
    const Vec3 local = sample_rough(side, from, xi);
    if (local == Vec3(0)) return {};
    const Vec3 out = glm::normalize(frame.to_world(local));
    const bool through = local.z < 0;
    if (!(through ? transmits_consistently(side, arrival.in, out) : reflects_consistently(side, arrival.in, out))) return {};
    const Scattering scattering = scatter_rough(side, from, local);
    if (!(scattering.pdf > 0)) return {};
    return {.direction = out, .weight = scattering.value * (mode_factor(side, arrival, out) / scattering.pdf), .pdf = scattering.pdf, .transmitted = through};
}

/// Value without the mode's factor, and density, of the scattering part.
Scattering scattering_of(const Scene& scene, const Side& side, const Arrival& arrival, const Vec3& out)
{
    if (!side.bsdf) return {};
    const SurfaceParts parts = parts_of(*side.bsdf);
    const bool reflects = reflects_consistently(side, arrival.in, out), through = parts.through && transmits_consistently(side, arrival.in, out);
    if (!parts.scattering || !(reflects || through)) return {};
    const double cosine = glm::dot(out, side.shading);
    if (parts.lambertian) return {.value = side.reflectance * pdf_cosine_hemisphere(cosine), .pdf = pdf_cosine_hemisphere(cosine)};
    const double from = -glm::dot(arrival.in, side.shading);
    if (parts.specular)
        return {.value = below_plastic(side, from, cosine) * pdf_cosine_hemisphere(cosine), .pdf = (1 - mirror_share(side, from)) * pdf_cosine_hemisphere(cosine)};
    const Frame frame = facet_frame(scene, side, arrival.hit);
    return scatter_rough(side, frame.to_local(-arrival.in), frame.to_local(out));
}

}  // namespace

const Bsdf& bsdf_of(const Scene& scene, const Hit& hit) { return scene.bsdfs[static_cast<std::size_t>(scene.shapes[static_cast<std::size_t>(hit.shape)].bsdf)]; }

SurfaceParts parts_of(const Bsdf& bsdf)
{
    switch (bsdf.type) {
        case Bsdf::Type::null: return {};
        case Bsdf::Type::diffuse: return {.scattering = true, .lambertian = true};
        case Bsdf::Type::dielectric:
        case Bsdf::Type::thin_dielectric:
        case Bsdf::Type::conductor: return {.specular = true};
        case Bsdf::Type::rough_dielectric: return {.scattering = true, .through = true};
        case Bsdf::Type::rough_conductor:
        case Bsdf::Type::rough_plastic: return {.scattering = true};
        case Bsdf::Type::plastic: return {.specular = true, .scattering = true};
    }
    return {};
}

SurfaceParts parts_at(const Scene& scene, const Arrival& arrival)
{
    const Side side = side_of(scene, arrival);
    return side.bsdf ? parts_of(*side.bsdf) : SurfaceParts{};
}

bool specular(const Bsdf& bsdf) { return parts_of(bsdf).specular; }

Rgb evaluate_bsdf(const Scene& scene, const Arrival& arrival, const Vec3& out)
{
    const Side side = side_of(scene, arrival);
    const Scattering scattering = scattering_of(scene, side, arrival, out);
    return scattering.value == Rgb(0) ? Rgb(0) : scattering.value * mode_factor(side, arrival, out);
}

double pdf_bsdf(const Scene& scene, const Arrival& arrival, const Vec3& out) { return scattering_of(scene, side_of(scene, arrival), arrival, out).pdf; }

BsdfSample sample_bsdf(const Scene& scene, const Arrival& arrival, const Vec2& xi)
{
    const Side side = side_of(scene, arrival);
    if (!side.bsdf) return {};
    switch (side.bsdf->type) {
        case Bsdf::Type::null: return {.direction = arrival.in, .weight = Rgb(1), .delta = true, .transmitted = true};
        case Bsdf::Type::diffuse: return sample_diffuse(side, arrival, xi);
        case Bsdf::Type::conductor: return sample_conductor(side, arrival);
        case Bsdf::Type::dielectric:
        case Bsdf::Type::thin_dielectric: return sample_dielectric(side, arrival, xi.x);
        case Bsdf::Type::plastic: return sample_plastic(side, arrival, xi);
        case Bsdf::Type::rough_conductor:
        case Bsdf::Type::rough_dielectric:
        case Bsdf::Type::rough_plastic: return sample_facets(scene, side, arrival, xi);
    }
    return {};
}

BsdfSample sample_specular(const Scene& scene, const Arrival& arrival, const Vec2& xi)
{
    const Side side = side_of(scene, arrival);
    if (!side.bsdf || !specular(*side.bsdf)) return {};
    if (side.bsdf->type != Bsdf::Type::plastic) return sample_bsdf(scene, arrival, xi);
    const double cosine = -glm::dot(arrival.in, side.shading);
    return cosine > 0 ? reflect(side, arrival, plastic_mirror(side, cosine)) : BsdfSample{};
}

Rgb diffuse_reflectance(const Scene& scene, const Hit& hit, const Vec3& in)
{
    const Side side = side_of(scene, {.hit = hit, .in = in});
    if (!side.bsdf) return Rgb(0);
    const bool plastic = side.bsdf->type == Bsdf::Type::plastic || side.bsdf->type == Bsdf::Type::rough_plastic;
    return side.bsdf->type == Bsdf::Type::diffuse ? side.reflectance : plastic ? side.diffuse : Rgb(0);
}

}  // namespace tyndall
