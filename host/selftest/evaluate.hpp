#pragma once
/// kernels/selftest/evaluate.h on the host, chosen by type. Include it after headers that are not the project's: the kernels' macros have short names.
#include <array>

#include "kernels/selftest/case_tables.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall::maths_float {
#include "kernels/selftest/evaluate.h"
}
#undef EVALUATE_H
#undef EVALUATE_GUIDED_H
#undef GRID_WALK_H
#undef CLIP_H
namespace tyndall::maths_double {
#include "kernels/selftest/evaluate.h"
}

namespace tyndall {

/// One set of inputs through one sampler, in float or in double.
template <class Real>
std::array<Real, 4> evaluate_on_host(unsigned sampler, const std::array<Real, 14>& in)
{
    std::array<Real, 4> result;
    const auto run = [&](auto inputs, auto tables, auto&& function) {
        for (std::size_t i = 0; i < in.size(); ++i) inputs.in[i] = in[i];
        const auto out = function(sampler, inputs, tables);
        for (std::size_t i = 0; i < 4; ++i) result[i] = out.out[i];
    };
    if constexpr (sizeof(Real) == 4) run(maths_float::Inputs{}, maths_float::CaseTables{{case_tables::lobes, case_tables::values.data()}, case_tables::grids}, maths_float::evaluate);
    else run(maths_double::Inputs{}, maths_double::CaseTables{{case_tables::lobes, case_tables::values.data()}, case_tables::grids}, maths_double::evaluate);
    return result;
}

}  // namespace tyndall
