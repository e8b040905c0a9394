/// How light paths begin.
#include "transport/emitter.hpp"
#include "transport/frame.hpp"
#include "transport/warp.hpp"

namespace tyndall {
namespace {

EmissionSample from_point(const Emitter& emitter, const Vec2& xi)
{
    return {.origin = emitter.position, .direction = sample_uniform_sphere(xi), .weight = emitter.value / pdf_uniform_sphere};
}

EmissionSample from_spot(const Emitter& emitter, const Vec2& xi)
{
    const double height = one_minus_cos(emitter.cutoff);
    const Vec3 direction = Frame(emitter.direction).to_world(sample_uniform_cone(height, xi));
    return {.origin = emitter.position,
            .direction = direction,
            .weight = emitter.value * (spot_falloff(emitter, direction) / pdf_uniform_cone(height))};
}

EmissionSample from_area(const EmitterSampler& emitters, int emitter, const Vec2& xi_position, const Vec2& xi_direction)
{
    const EmitterPoint point = emitters.sample_point(emitter, xi_position);
    const Vec3 direction = Frame(point.normal).to_world(sample_cosine_hemisphere(xi_direction));
    return {.origin = point.position + Visibility::surface_offset * point.normal,
            .direction = direction,
            .weight = emitters.scene().emitters[emitter].value * (pi / point.pdf),
            .normal = point.normal};
}

/// From a disk that covers the scene, as seen along `direction`.
EmissionSample from_outside(const EmitterSampler& emitters, const Vec3& direction, const Vec2& xi, const Rgb& weight)
{
    const double r = emitters.scene_radius();
    const Vec3 on_disk = r * (sample_uniform_disk(xi) - Vec3(0, 0, 1));
    return {
        .origin = emitters.scene_centre() + Frame(direction).to_world(on_disk), .direction = direction, .weight = weight * (pi * r * r)};
}

}  // namespace

EmissionSample sample_emission(const EmitterSampler& emitters, int emitter, const Vec2& xi_position, const Vec2& xi_direction)
{
    const Emitter& e = emitters.scene().emitters[emitter];
    const auto begin = [&]() -> EmissionSample {
        switch (e.type) {
            case Emitter::Type::point:
                return from_point(e, xi_direction);
            case Emitter::Type::spot:
                return from_spot(e, xi_direction);
            case Emitter::Type::area:
                return from_area(emitters, emitter, xi_position, xi_direction);
            case Emitter::Type::directional:
                return from_outside(emitters, e.direction, xi_position, e.value);
            case Emitter::Type::constant:
                return from_outside(emitters, sample_uniform_sphere(xi_direction), xi_position, e.value / pdf_uniform_sphere);
            case Emitter::Type::envmap: {
                const DirectSample from = sample_direct(emitters, emitter, emitters.scene_centre(), xi_direction);
                return from_outside(emitters, -from.direction, xi_position, from.weight);
            }
        }
        return {};
    };
    EmissionSample sample = begin();
    sample.medium = e.medium;
    return sample;
}

}  // namespace tyndall
