/// Virtual point lights on surfaces on the host: each arrival of a light path at a surface that reflects diffusely becomes one. They are the other half of --method vpl.
#include "lights/light_technique.hpp"
// The kernels' macros come after everything that is not theirs.
#include "kernels/shared/records.hpp"
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall {
namespace maths_float {
#include "kernels/lights/surface_point_light.h"
}
namespace {

void arrive_surface_point_light(const LightPathArrival& a, std::vector<std::byte>& records)
{
    if (!(a.reflected.r + a.reflected.g + a.reflected.b > 0)) return;
    const auto f = [](double x) { return static_cast<float>(x); };
    append_record(maths_float::SurfacePointLight{f(a.off_surface.x), f(a.off_surface.y), f(a.off_surface.z), static_cast<uint>(a.medium), f(a.facing.x), f(a.facing.y), f(a.facing.z),
                                                 static_cast<uint>(a.depth), f(a.reflected.r), f(a.reflected.g), f(a.reflected.b), 0, f(a.normal.x), f(a.normal.y), f(a.normal.z), 0},
                  records);
}

}  // namespace

LightTechnique surface_point_light_technique()
{
    return {.method = "vpl",
            .clamped_method = "vpl-clamped",
            .name = "surface_point_light",
            .title = "virtual point lights on surfaces",
            .record_bytes = sizeof(maths_float::SurfacePointLight),
            .is_line = false,
            .unbiased = true,
            .surface_sampler = "none",
            .surface_sampler_why = "one line joins a point with a point",
            .carries = LayerSet().add(Layer::surface_to_media).add(Layer::surface_indirect),
            .arrive = arrive_surface_point_light,
            .on_surfaces = true};
}

}  // namespace tyndall
