#include "device/case_evaluator.hpp"

#include <algorithm>

#include "device/device_state.hpp"
#include "device/kernel_source.hpp"
#include "device/pair_stage.hpp"
#include "kernels/selftest/case_tables.hpp"
#include "kernels/shared/host_features.hpp"

namespace tyndall {

/// Work-items per group, and global sizes are multiples of it: some drivers compile a kernel again for every local size.
constexpr std::uint32_t items_per_group = 8;

struct CaseEvaluator::State {
    DeviceState& device;
    int lanes;
    std::string source, options;
    cl::Kernel kernel;
    GrowingBuffer in{CL_MEM_READ_ONLY}, out{CL_MEM_WRITE_ONLY}, values{CL_MEM_READ_ONLY}, lobes{CL_MEM_READ_ONLY}, grids{CL_MEM_READ_ONLY};
};

std::string case_options(int lanes, std::uint32_t families)
{
    return build_options({.features = feature_bit::phase_lobes, .lanes = lanes}) + " -DCASE_FAMILIES=" + std::to_string(families) + "u";
}

CaseEvaluator::CaseEvaluator(Device& device, int lanes, std::optional<std::string> source, std::uint32_t families)
    : state_(std::make_unique<State>(State{device.state(), lanes, source ? std::move(*source) : flattened_kernel("kernels/selftest/evaluate_cases.cl", {}),
                                           case_options(lanes, families)}))
{
    const cl::Program program = build_program(state_->device, state_->source, state_->options);
    state_->options += state_->device.info.build_options;  // what the compiler was given
    state_->kernel = on_device(state_->device, "creating a kernel", [&] { return cl::Kernel(program, "evaluate_cases"); });
    State& s = *state_;
    on_device(s.device, "uploading what golden cases refer to", [&] {
        s.kernel.setArg(4, s.values.upload(s.device, std::as_bytes(std::span(case_tables::values))));
        s.kernel.setArg(5, s.lobes.upload(s.device, std::as_bytes(std::span(case_tables::lobes))));
        s.kernel.setArg(6, s.grids.upload(s.device, std::as_bytes(std::span(case_tables::grids))));
    });
}

CaseEvaluator::~CaseEvaluator() = default;
CaseEvaluator::CaseEvaluator(CaseEvaluator&&) noexcept = default;

int CaseEvaluator::lanes() const { return state_->lanes; }
const std::string& CaseEvaluator::source() const { return state_->source; }
const std::string& CaseEvaluator::options() const { return state_->options; }

std::vector<float> packed_inputs(std::span<const std::array<float, case_inputs>> in, int lanes)
{
    const std::size_t width = static_cast<std::size_t>(lanes), count = (in.size() + width - 1) / width * width;
    std::vector<float> fields(case_inputs * count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t f = 0; f < case_inputs; ++f) fields[f * count + i] = in[std::min(i, in.size() - 1)][f];
    return fields;
}

std::vector<std::array<float, case_outputs>> CaseEvaluator::evaluate(std::uint32_t sampler, std::span<const std::array<float, case_inputs>> in)
{
    std::vector<std::array<float, case_outputs>> result(in.size());
    if (in.empty()) return result;
    const std::vector<float> fields = packed_inputs(in, state_->lanes);
    const std::size_t count = fields.size() / case_inputs, groups = count / static_cast<std::size_t>(state_->lanes);
    std::vector<float> outputs(case_outputs * count);
    const cl::Buffer& device_in = state_->in.upload(state_->device, std::as_bytes(std::span(fields)));
    const cl::Buffer& device_out = state_->out.reserve(state_->device, sizeof(float) * outputs.size());
    on_device(state_->device, "evaluating golden cases", [&] {
        cl::Kernel& kernel = state_->kernel;
        kernel.setArg(0, sampler), kernel.setArg(1, device_in), kernel.setArg(2, static_cast<cl_uint>(count)), kernel.setArg(3, device_out);
        const std::size_t local = local_size(state_->device, kernel, items_per_group);
        state_->device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange((groups + local - 1) / local * local), cl::NDRange(local));
        state_->device.queue.enqueueReadBuffer(device_out, CL_TRUE, 0, sizeof(float) * outputs.size(), outputs.data());
    });
    for (std::size_t i = 0; i < in.size(); ++i)
        for (std::size_t k = 0; k < case_outputs; ++k) result[i][k] = outputs[k * count + i];
    return result;
}

}  // namespace tyndall
