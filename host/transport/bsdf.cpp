#include "transport/bsdf.hpp"

#include "transport/frame.hpp"
#include "transport/warp.hpp"

namespace tyndall {
namespace {

/// The surface as the arriving ray sees it: normals turned towards where it comes from, and the BSDF of that side (null: it is black).
struct Side {
    const Bsdf* bsdf;
    Vec3 shading, geometric;
    bool front;
};

Side side_of(const Scene& scene, const Arrival& arrival)
{
    const Bsdf& bsdf = bsdf_of(scene, arrival.hit);
    const bool front = glm::dot(arrival.in, arrival.hit.geometric_normal) <= 0;
    const double sign = front ? 1 : -1;
    const bool one_sided = bsdf.type == Bsdf::Type::diffuse || bsdf.type == Bsdf::Type::conductor;
    const Bsdf* seen = &bsdf;
    if (one_sided && !front) seen = !bsdf.two_sided ? nullptr : bsdf.back == none ? &bsdf : &scene.bsdfs[bsdf.back];
    return {.bsdf = seen, .shading = sign * arrival.hit.shading_normal, .geometric = sign * arrival.hit.geometric_normal, .front = front};
}

/// What the cosine of `out` becomes when flux is carried over a shading normal, relative to |out . shading|.
double adjoint_correction(const Side& side, const Arrival& arrival, const Vec3& out)
{
    if (arrival.mode == TransportMode::radiance) return 1;
    const double numerator = glm::dot(arrival.in, side.shading) * glm::dot(out, side.geometric);
    const double denominator = glm::dot(arrival.in, side.geometric) * glm::dot(out, side.shading);
    return denominator == 0 ? 0 : std::abs(numerator / denominator);
}

/// Both normals agree on which side `in` and `out` are; otherwise light would leak through the surface.
bool reflects_consistently(const Side& side, const Vec3& in, const Vec3& out)
{
    return glm::dot(in, side.shading) < 0 && glm::dot(out, side.shading) > 0 && glm::dot(out, side.geometric) > 0;
}

BsdfSample sample_diffuse(const Side& side, const Arrival& arrival, const Vec2& xi)
{
    const Vec3 out = Frame(side.shading).to_world(sample_cosine_hemisphere(xi));
    if (!reflects_consistently(side, arrival.in, out)) return {};
    return {.direction = out,
            .weight = side.bsdf->reflectance * adjoint_correction(side, arrival, out),
            .pdf = pdf_cosine_hemisphere(glm::dot(out, side.shading))};
}

Vec3 mirrored(const Vec3& in, const Vec3& normal) { return glm::normalize(in - 2 * glm::dot(in, normal) * normal); }

BsdfSample sample_conductor(const Side& side, const Arrival& arrival)
{
    const Vec3 out = mirrored(arrival.in, side.shading);
    if (!reflects_consistently(side, arrival.in, out)) return {};
    const double cosine = -glm::dot(arrival.in, side.shading);
    const Bsdf& b = *side.bsdf;
    Rgb weight = b.reflectance * adjoint_correction(side, arrival, out);
    for (int c = 0; c < 3; ++c) weight[c] *= fresnel_conductor(cosine, b.conductor_eta[c], b.conductor_k[c]);
    return {.direction = out, .weight = weight, .delta = true};
}

/// eta: index behind the surface over index before it.
BsdfSample refracted(const Side& side, const Arrival& arrival, double eta, const Rgb& weight)
{
    const double cosine = -glm::dot(arrival.in, side.shading);
    const double cosine_behind = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (eta * eta)));
    const Vec3 out = glm::normalize(arrival.in / eta + (cosine / eta - cosine_behind) * side.shading);
    if (!(glm::dot(out, side.geometric) < 0)) return {};
    const double scale = arrival.mode == TransportMode::radiance ? 1 / (eta * eta) : adjoint_correction(side, arrival, out);
    return {.direction = out, .weight = weight * scale, .delta = true, .transmitted = true};
}

BsdfSample sample_dielectric(const Side& side, const Arrival& arrival, double xi)
{
    const Bsdf& b = *side.bsdf;
    const double cosine = -glm::dot(arrival.in, side.shading), eta = side.front ? b.eta : 1 / b.eta;
    if (!(cosine > 0)) return {};
    const double f = fresnel_dielectric(cosine, eta);
    const double reflected = f * largest(b.reflectance), transmitted = (1 - f) * largest(b.specular_transmittance);
    if (!(reflected + transmitted > 0)) return {};
    const double probability = reflected / (reflected + transmitted);
    if (xi >= probability) return refracted(side, arrival, eta, b.specular_transmittance * ((1 - f) / (1 - probability)));
    const Vec3 out = mirrored(arrival.in, side.shading);
    if (!reflects_consistently(side, arrival.in, out)) return {};
    return {.direction = out, .weight = b.reflectance * (f / probability * adjoint_correction(side, arrival, out)), .delta = true};
}

}  // namespace

const Bsdf& bsdf_of(const Scene& scene, const Hit& hit) { return scene.bsdfs[scene.shapes[hit.shape].bsdf]; }

bool specular(const Bsdf& bsdf) { return bsdf.type == Bsdf::Type::dielectric || bsdf.type == Bsdf::Type::conductor; }

Rgb evaluate_bsdf(const Scene& scene, const Arrival& arrival, const Vec3& out)
{
    const Side side = side_of(scene, arrival);
    if (!side.bsdf || side.bsdf->type != Bsdf::Type::diffuse || !reflects_consistently(side, arrival.in, out)) return Rgb(0);
    return side.bsdf->reflectance * (glm::dot(out, side.shading) / pi * adjoint_correction(side, arrival, out));
}

double pdf_bsdf(const Scene& scene, const Arrival& arrival, const Vec3& out)
{
    const Side side = side_of(scene, arrival);
    if (!side.bsdf || side.bsdf->type != Bsdf::Type::diffuse || !reflects_consistently(side, arrival.in, out)) return 0;
    return pdf_cosine_hemisphere(glm::dot(out, side.shading));
}

BsdfSample sample_bsdf(const Scene& scene, const Arrival& arrival, const Vec2& xi)
{
    const Side side = side_of(scene, arrival);
    if (!side.bsdf) return {};
    switch (side.bsdf->type) {
        case Bsdf::Type::null:
            return {.direction = arrival.in, .weight = Rgb(1), .delta = true, .transmitted = true};
        case Bsdf::Type::diffuse:
            return sample_diffuse(side, arrival, xi);
        case Bsdf::Type::conductor:
            return sample_conductor(side, arrival);
        case Bsdf::Type::dielectric:
            return sample_dielectric(side, arrival, xi.x);
    }
    return {};
}

Rgb diffuse_reflectance(const Scene& scene, const Hit& hit, const Vec3& in)
{
    const Side side = side_of(scene, {.hit = hit, .in = in});
    return side.bsdf && side.bsdf->type == Bsdf::Type::diffuse ? side.bsdf->reflectance : Rgb(0);
}

double fresnel_dielectric(double cosine, double eta)
{
    const double sine2_behind = (1 - cosine * cosine) / (eta * eta);
    if (sine2_behind >= 1) return 1;
    const double behind = std::sqrt(1 - sine2_behind);
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

}  // namespace tyndall
