#pragma once
/// The kernel mathematics on the host, twice: `tyndall::maths_float`, what a device computes, and `tyndall::maths_double`, the same text as precision oracle.
///
/// Another kernel header (say kernels/lights/x.h, with include guard X_H) joins both namespaces in a header of its own:
///
///     #include "kernels/dialect_host.hpp"
///     namespace tyndall::maths_float {
///     #include "kernels/lights/x.h"
///     }
///     #undef X_H
///     namespace tyndall::maths_double {
///     #include "kernels/lights/x.h"
///     }
///
/// What x.h itself includes from kernels/math is skipped then, because its guards stay defined. Records that cross the border
/// (kernels/shared) belong in namespace tyndall, once: they are included before, outside both namespaces.
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "kernels/shared/records.hpp"

// Lights have the functions of one contract, with its parameters, whether they need them or not (host/docs/adding_a_light.md).
#pragma GCC diagnostic ignored "-Wunused-parameter"

#define REAL float
namespace tyndall::maths_float {
#include "kernels/math/maths.h"
}
#undef REAL

#undef DIALECT_H
#undef MATHS_H
#undef STABLE_H
#undef RANDOM_H
#undef SOBOL_H
#undef ROD_H
#undef EQUIANGULAR_H
#undef PAIR_WEIGHT_H
#undef PHASE_FUNCTION_H
#undef PHASE_PRODUCT_H
#undef PHASE_LOBES_H
#undef ROD_TABLE_H
#undef LIGHT_ESTIMATE_H
#undef ROD_ESTIMATE_H
#undef TRANSMITTANCE_H
#undef SURFACE_ROD_H
#undef BLUR_H
#undef EYE_AND_LIGHT_H
#undef POINT_LIGHT_H
#undef RAY_LIGHT_H
#undef LINEAR_PIECE_H
#undef MIS_H

#define REAL double
namespace tyndall::maths_double {
#include "kernels/math/maths.h"
}
#undef REAL
