/// Virtual point lights on the host: each collision of a light path with a medium becomes one.
#include "lights/light_technique.hpp"
// The kernels' macros come after everything that is not theirs.
#include "kernels/shared/records.hpp"
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall {
namespace maths_float {
#include "kernels/lights/virtual_point_light.h"
}
namespace {

void deposit_virtual_point_light(const LightPathSegment& s, std::vector<std::byte>& records)
{
    if (s.collision < 0 || !(s.scattered.r + s.scattered.g + s.scattered.b > 0)) return;
    const auto f = [](double x) { return static_cast<float>(x); };
    const Vec3 at = s.origin + s.collision * s.direction;
    append_record(maths_float::VirtualPointLight{f(at.x), f(at.y), f(at.z), static_cast<uint>(s.medium), f(s.direction.x), f(s.direction.y), f(s.direction.z),
                                                 static_cast<uint>(s.depth), f(s.scattered.r), f(s.scattered.g), f(s.scattered.b), 0},
                  records);
}

}  // namespace

LightTechnique virtual_point_light_technique()
{
    return {.method = "vpl",
            .clamped_method = "vpl-clamped",
            .name = "virtual_point_light",
            .title = "virtual point lights",
            .record_bytes = sizeof(maths_float::VirtualPointLight),
            .is_line = false,
            .unbiased = true,
            .surface_sampler = "none",
            .surface_sampler_why = "one line joins a point with a point",
            .deposit = deposit_virtual_point_light};
}

}  // namespace tyndall
