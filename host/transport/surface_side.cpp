#include "transport/surface_side.hpp"

#include <cmath>

#include "scene/texture_lookup.hpp"
#include "transport/surface_place.hpp"

namespace tyndall {
namespace {

/// Lets light through: it has one behaviour, whichever side light arrives at.
bool transparent(Bsdf::Type type)
{
    switch (type) {
        case Bsdf::Type::null:
        case Bsdf::Type::dielectric:
        case Bsdf::Type::thin_dielectric:
        case Bsdf::Type::rough_dielectric: return true;
        default: return false;
    }
}

/// Does light change the medium that sets its radiance's scale?
bool bends(Bsdf::Type type) { return type == Bsdf::Type::dielectric || type == Bsdf::Type::rough_dielectric; }

/// The colours of `side` that are textures, at the hit.
void look_up_colours(const Scene& scene, const Bsdf& bsdf, const Hit& hit, Side& side)
{
    if (bsdf.reflectance_texture == none && bsdf.transmittance_texture == none && bsdf.diffuse_texture == none) return;
    const Vec2 uv = place_on_surface(scene, hit).uv;
    const auto look_up = [&](int texture, Rgb& colour) {
        if (texture != none) colour = texture_at(scene.textures[static_cast<std::size_t>(texture)], uv);
    };
    look_up(bsdf.reflectance_texture, side.reflectance);
    look_up(bsdf.transmittance_texture, side.transmittance);
    look_up(bsdf.diffuse_texture, side.diffuse);
}

}  // namespace

Side side_of(const Scene& scene, const Arrival& arrival)
{
    const Bsdf& bsdf = bsdf_of(scene, arrival.hit);
    const bool front = glm::dot(arrival.in, arrival.hit.geometric_normal) <= 0;
    const double sign = front ? 1 : -1;
    const Bsdf* seen = &bsdf;
    if (!transparent(bsdf.type) && !front) seen = !bsdf.two_sided ? nullptr : bsdf.back == none ? &bsdf : &scene.bsdfs[static_cast<std::size_t>(bsdf.back)];
    const Bsdf& colours = seen ? *seen : bsdf;
    Side side{.bsdf = seen, .shading = sign * arrival.hit.shading_normal, .geometric = sign * arrival.hit.geometric_normal, .front = front,
            .reflectance = colours.reflectance, .transmittance = colours.specular_transmittance, .diffuse = colours.diffuse};
    look_up_colours(scene, colours, arrival.hit, side);
    return side;
}

Frame facet_frame(const Scene& scene, const Side& side, const Hit& hit)
{
    const Roughness& r = side.bsdf->roughness;
    if (r.alpha_u == r.alpha_v) return Frame(side.shading);
    return {side.shading, place_on_surface(scene, hit).along_u};
}

double mode_factor(const Side& side, const Arrival& arrival, const Vec3& out)
{
    if (arrival.mode == TransportMode::radiance) {
        const bool refracted = bends(side.bsdf->type) && glm::dot(out, side.geometric) < 0;
        return refracted ? 1 / (side.eta() * side.eta()) : 1;
    }
    const double numerator = glm::dot(arrival.in, side.shading) * glm::dot(out, side.geometric);
    const double denominator = glm::dot(arrival.in, side.geometric) * glm::dot(out, side.shading);
    return denominator == 0 ? 0 : std::abs(numerator / denominator);
}

}  // namespace tyndall
