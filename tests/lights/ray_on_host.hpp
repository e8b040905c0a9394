#pragma once
/// The virtual ray light on the host in both precisions, for the pairs of plain_transport.hpp. For one source file per program.
#include "tests/lights/host_maths.hpp"

namespace tyndall {
namespace maths_float {
#include "kernels/lights/virtual_ray_light.h"
}
#undef VIRTUAL_RAY_LIGHT_H
namespace maths_double {
#include "kernels/lights/virtual_ray_light.h"
}

template <typename Light>
Light light_of(const plain::Pair& p)
{
    const auto f = [](double x) { return static_cast<float>(x); };
    return {f(p.p.x), f(p.p.y), f(p.p.z), f(p.light_length), f(p.b.x), f(p.b.y), f(p.b.z), 0, f(p.flux.x), f(p.flux.y), f(p.flux.z), 0,
            f(p.share.x), f(p.share.y), f(p.share.z), p.is_short ? 1u : 0u};
}

}  // namespace tyndall

#include "tests/lights/both_precisions.hpp"
