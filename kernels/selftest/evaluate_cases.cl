// Evaluates one sampler for `count` inputs (a multiple of LANES): field f of case i at in[f * count + i], output k at out[k * count + i].
// values, lobes, grids: kernels/selftest/case_tables.hpp.
#include "kernels/selftest/evaluate.h"

__kernel void evaluate_cases(uint sampler, __global const float* in, uint count, __global float* out,
                             __global const float* values, __global const PhaseLobeRecord* lobes, __global const GridRecord* grids)
{
    uint group = (uint)get_global_id(0);
    if (group >= count / LANES) return;
    Inputs inputs;
    for (uint f = 0; f < 14u; ++f) inputs.in[f] = load_lanes(in + f * count, group);
    CaseTables tables = {{lobes, values}, grids};
    Outputs outputs = evaluate(sampler, inputs, tables);
    for (uint k = 0; k < 4u; ++k) store_lanes(outputs.out[k], group, out + k * count);
}
