/// Photon beams on the host: each straight piece of a light path inside a medium that scatters becomes one, as thick as the pass wants it.
#include <cstring>

#include "lights/light_technique.hpp"
// The kernels' macros come after everything that is not theirs.
#include "kernels/shared/records.hpp"
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall {
namespace maths_float {
#include "kernels/lights/photon_beam.h"
}
namespace {

void deposit_photon_beam(const LightPathSegment& s, std::vector<std::byte>& records)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    const maths_float::RayLight ray{f(s.origin.x), f(s.origin.y), f(s.origin.z), f(s.length), f(s.direction.x), f(s.direction.y), f(s.direction.z), static_cast<uint>(s.medium),
                                    f(s.flux.r), f(s.flux.g), f(s.flux.b), static_cast<uint>(s.depth), f(s.channel.r), f(s.channel.g), f(s.channel.b), s.is_short ? 1u : 0u};
    append_record(maths_float::PhotonBeam{ray, f(s.radius), 0, 0, 0}, records);
}

Capsule capsule_of_photon_beam(std::span<const std::byte> record)
{
    maths_float::PhotonBeam beam;
    std::memcpy(&beam, record.data(), sizeof beam);
    const maths_float::RayLight& r = beam.ray;
    return {{r.origin_x, r.origin_y, r.origin_z}, {r.direction_x, r.direction_y, r.direction_z}, r.length, beam.radius};
}

}  // namespace

LightTechnique photon_beam_technique()
{
    return {.method = "beams",
            .name = "photon_beam",
            .title = "photon beams",
            .record_bytes = sizeof(maths_float::PhotonBeam),
            .is_line = true,
            .is_thick = true,
            .unbiased = false,
            .deposit = deposit_photon_beam,
            .reach = Reach::near_segments,
            .carries = LayerSet().add(Layer::single).add(Layer::surface_to_media).add(Layer::media_to_media).add(Layer::single_specular).add(Layer::surface_to_media_specular).add(Layer::media_to_media_specular),
            .blur_dimensions = 1,
            .usual_radius = .02,
            .usual_lights = 4096,
            .capsule = capsule_of_photon_beam};
}

}  // namespace tyndall
