#include "device/scalar_pairs.hpp"

#include <algorithm>

#include "device/device_state.hpp"
#include "device/kernel_source.hpp"
#include "kernels/shared/host_features.hpp"

namespace tyndall {
namespace {

std::string options(std::uint32_t features)
{
    const auto flag = [&](const char* name, std::uint32_t bit) { return std::string(" -D") + name + (features & bit ? "=1" : "=0"); };
    return "-cl-std=CL1.2" + flag("ANISOTROPIC", feature_bit::anisotropic) + flag("COLOURED", feature_bit::coloured);
}

}  // namespace

struct ScalarPairs::State {
    DeviceState& device;
    std::uint32_t eye_count;
    cl::Kernel kernel{};
    GrowingBuffer eyes{CL_MEM_READ_ONLY}, lights{CL_MEM_READ_ONLY}, media{CL_MEM_READ_ONLY}, sums{CL_MEM_READ_WRITE};
};

ScalarPairs::ScalarPairs(Device& device, const ScalarPairsInput& input)
    : state_(new State{device.state(), static_cast<std::uint32_t>(input.eyes.size())})
{
    State& s = *state_;
    const cl::Program program = build_program(s.device, flattened_kernel("kernels/baseline/scalar_pairs.cl", {}), options(input.features));
    on_device(s.device, "preparing the scalar kernel", [&] {
        s.kernel = cl::Kernel(program, "scalar_pairs");
        s.kernel.setArg(0, s.eyes.upload(s.device, std::as_bytes(input.eyes)));
        s.kernel.setArg(1, s.lights.upload(s.device, input.lights));
        s.kernel.setArg(2, input.light_count);
        s.kernel.setArg(3, s.media.upload(s.device, std::as_bytes(input.media)));
        s.kernel.setArg(4, s.sums.reserve(s.device, 3 * sizeof(float) * s.eye_count));
    });
}

ScalarPairs::~ScalarPairs() = default;
ScalarPairs::ScalarPairs(ScalarPairs&&) noexcept = default;

void ScalarPairs::run(std::uint32_t eyes)
{
    on_device(state_->device, "running the scalar kernel", [&] {
        cl::CommandQueue& queue = state_->device.queue;
        queue.enqueueNDRangeKernel(state_->kernel, cl::NullRange, cl::NDRange(std::min(eyes, state_->eye_count)), cl::NullRange);
        queue.finish();
    });
}

std::vector<float> ScalarPairs::sums() const
{
    std::vector<float> sums(3 * std::size_t(state_->eye_count));
    on_device(state_->device, "reading sums", [&] { state_->device.queue.enqueueReadBuffer(state_->sums.get(), CL_TRUE, 0, sums.size() * sizeof(float), sums.data()); });
    return sums;
}

}  // namespace tyndall
