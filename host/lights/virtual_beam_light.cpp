/// Virtual beam lights on the host: each straight piece of a light path inside a medium that scatters becomes one, as thick as the pass wants it.
#include "lights/light_technique.hpp"
// The kernels' macros come after everything that is not theirs.
#include "kernels/shared/records.hpp"
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall {
namespace maths_float {
#include "kernels/lights/virtual_beam_light.h"
}
namespace {

void deposit_virtual_beam_light(const LightPathSegment& s, std::vector<std::byte>& records)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    const maths_float::RayLight ray{f(s.origin.x), f(s.origin.y), f(s.origin.z), f(s.length), f(s.direction.x), f(s.direction.y), f(s.direction.z), static_cast<uint>(s.medium),
                                    f(s.flux.r), f(s.flux.g), f(s.flux.b), static_cast<uint>(s.depth), f(s.channel.r), f(s.channel.g), f(s.channel.b), s.is_short ? 1u : 0u};
    append_record(maths_float::VirtualBeamLight{ray, f(s.radius), 0, 0, 0}, records);
}

}  // namespace

LightTechnique virtual_beam_light_technique()
{
    return {.method = "vbl",
            .name = "virtual_beam_light",
            .title = "virtual beam lights",
            .record_bytes = sizeof(maths_float::VirtualBeamLight),
            .is_line = true,
            .is_thick = true,
            .unbiased = false,
            .surface_sampler = "cosine",
            .surface_sampler_why = "along the beam's axis by the angle at the surface and its cosine, in closed form",
            .deposit = deposit_virtual_beam_light};
}

}  // namespace tyndall
