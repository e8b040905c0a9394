/// Photons on the host: each arrival of a light path at a surface that reflects diffusely becomes one, as wide as the pass wants it.
#include <cstring>

#include "lights/light_technique.hpp"
// The kernels' macros come after everything that is not theirs.
#include "kernels/shared/records.hpp"
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall {
namespace maths_float {
#include "kernels/lights/photon.h"
}
namespace {

void arrive_photon(const LightPathArrival& a, std::vector<std::byte>& records)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    append_record(maths_float::Photon{f(a.position.x), f(a.position.y), f(a.position.z), f(a.radius), f(a.direction.x), f(a.direction.y), f(a.direction.z), static_cast<uint>(a.depth), f(a.flux.r),
                                      f(a.flux.g), f(a.flux.b), 0, f(a.facing.x), f(a.facing.y), f(a.facing.z), 0},
                  records);
}

Capsule capsule_of_photon(std::span<const std::byte> record)
{
    maths_float::Photon photon;
    std::memcpy(&photon, record.data(), sizeof photon);
    return {{photon.position_x, photon.position_y, photon.position_z}, Vec3(0), 0, photon.radius};
}

}  // namespace

LightTechnique photon_technique()
{
    return {.method = "photons",
            .name = "photon",
            .title = "photons",
            .record_bytes = sizeof(maths_float::Photon),
            .is_line = false,
            .is_thick = true,
            .unbiased = false,
            .reach = Reach::near_points,
            .carries = LayerSet().add(Layer::surface_indirect).add(Layer::media_to_surface).add(Layer::surface_direct_specular).add(Layer::surface_indirect_specular).add(Layer::media_to_surface_specular),
            .blur_dimensions = 2,
            .usual_radius = .02,
            .usual_lights = 1u << 16,
            .arrive = arrive_photon,
            .capsule = capsule_of_photon};
}

}  // namespace tyndall
