#include "bench/naive_pairs.hpp"

#include <fstream>
#include <sstream>

#include "device/device_state.hpp"
#include "kernels/shared/host_features.hpp"

namespace tyndall::bench {
namespace {

std::string kernel_text()
{
    const std::string path = TYNDALL_SOURCE_DIR "/bench/naive_pairs.cl";
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    if (!file) throw BuildError(path + " cannot be read; run the benchmark where it was built");
    return text.str();
}

std::string options(std::uint32_t features)
{
    const auto flag = [&](const char* name, std::uint32_t bit) { return std::string(" -D") + name + (features & bit ? "=1" : "=0"); };
    return "-cl-std=CL1.2" + flag("ANISOTROPIC", feature_bit::anisotropic) + flag("COLOURED", feature_bit::coloured);
}

}  // namespace

struct NaivePairs::State {
    DeviceState& device;
    cl::Kernel kernel;
    GrowingBuffer eyes{CL_MEM_READ_ONLY}, lights{CL_MEM_READ_ONLY}, media{CL_MEM_READ_ONLY}, sums{CL_MEM_READ_WRITE};
    std::size_t eye_count;
};

NaivePairs::NaivePairs(Device& device, const Workload& work, std::uint32_t features)
    : state_(std::make_unique<State>(State{device.state(),
                                           {},
                                           GrowingBuffer{CL_MEM_READ_ONLY},
                                           GrowingBuffer{CL_MEM_READ_ONLY},
                                           GrowingBuffer{CL_MEM_READ_ONLY},
                                           GrowingBuffer{CL_MEM_READ_WRITE},
                                           work.eyes.size()}))
{
    State& s = *state_;
    s.kernel = cl::Kernel(build_program(s.device, kernel_text(), options(features)), "naive_pairs");
    s.kernel.setArg(0, s.eyes.upload(s.device, work.eye_bytes()));
    s.kernel.setArg(1, s.lights.upload(s.device, work.lights));
    s.kernel.setArg(2, work.light_count);
    s.kernel.setArg(3, s.media.upload(s.device, std::as_bytes(std::span(work.tables.media))));
    s.kernel.setArg(4, s.sums.reserve(s.device, 3 * sizeof(float) * s.eye_count));
}

NaivePairs::~NaivePairs() = default;

std::vector<float> NaivePairs::sums()
{
    std::vector<float> sums(3 * state_->eye_count);
    on_device(state_->device, "running the scalar kernel", [&] {
        cl::CommandQueue& queue = state_->device.queue;
        queue.enqueueNDRangeKernel(state_->kernel, cl::NullRange, cl::NDRange(state_->eye_count), cl::NullRange);
        queue.enqueueReadBuffer(state_->sums.get(), CL_TRUE, 0, sums.size() * sizeof(float), sums.data());
    });
    return sums;
}

}  // namespace tyndall::bench
