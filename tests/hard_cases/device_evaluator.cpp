#define CL_HPP_TARGET_OPENCL_VERSION 300
#define CL_HPP_MINIMUM_OPENCL_VERSION 200
#define CL_HPP_ENABLE_EXCEPTIONS
#include "tests/hard_cases/device_evaluator.hpp"

#include <CL/opencl.hpp>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tyndall::test {
namespace {

/// Text of a file below the source directory with its includes in place, each file once.
std::string flattened(const std::string& path, std::set<std::string>& done)
{
    if (!done.insert(path).second) return {};
    std::ifstream file(std::string(TYNDALL_SOURCE_DIR) + "/" + path);
    if (!file) throw std::runtime_error("cannot read " + path + " below " TYNDALL_SOURCE_DIR);
    const std::string start = "#include \"";
    std::string text = "#line 1 \"" + path + "\"\n", line;
    for (int number = 1; std::getline(file, line); ++number) {
        if (line.rfind(start, 0) != 0) text += line + "\n";
        else text += flattened(line.substr(start.size(), line.find('"', start.size()) - start.size()), done) + "#line " + std::to_string(number + 1) + " \"" + path + "\"\n";
    }
    return text;
}

}  // namespace

struct DeviceEvaluator::State {
    unsigned lanes;
    cl::Device device;
    cl::Context context;
    cl::CommandQueue queue;
    cl::Program program;
};

DeviceEvaluator::DeviceEvaluator(unsigned lanes) : state_(std::make_unique<State>())
{
    State& s = *state_;
    s.lanes = lanes;
    s.device = cl::Device::getDefault();
    s.context = cl::Context(s.device);
    s.queue = cl::CommandQueue(s.context, s.device);
    std::set<std::string> done;
    s.program = cl::Program(s.context, flattened("tests/hard_cases/hard_cases.cl", done));
    try {
        s.program.build(s.device, ("-cl-std=CL1.2 -DLANES=" + std::to_string(lanes)).c_str());
    } catch (const cl::Error&) {
        throw std::runtime_error(s.program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(s.device));
    }
}

DeviceEvaluator::~DeviceEvaluator() = default;

std::string DeviceEvaluator::device_name() const { return state_->device.getInfo<CL_DEVICE_NAME>(); }

std::vector<std::array<float, 4>> DeviceEvaluator::evaluate(unsigned sampler, std::span<const std::array<float, 14>> in) const
{
    const State& s = *state_;
    const std::size_t count = (in.size() + s.lanes - 1) / s.lanes * s.lanes;
    std::vector<float> fields(14 * count), outputs(4 * count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t f = 0; f < 14; ++f) fields[f * count + i] = in[std::min(i, in.size() - 1)][f];  // the last case fills the last group
    const cl::Buffer device_in(s.context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, sizeof(float) * fields.size(), fields.data());
    const cl::Buffer device_out(s.context, CL_MEM_WRITE_ONLY, sizeof(float) * outputs.size());
    cl::Kernel kernel(s.program, "evaluate_cases");
    kernel.setArg(0, cl_uint(sampler)), kernel.setArg(1, device_in), kernel.setArg(2, cl_uint(count)), kernel.setArg(3, device_out);
    s.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count / s.lanes));
    s.queue.enqueueReadBuffer(device_out, CL_TRUE, 0, sizeof(float) * outputs.size(), outputs.data());
    std::vector<std::array<float, 4>> result(in.size());
    for (std::size_t i = 0; i < in.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) result[i][k] = outputs[k * count + i];
    return result;
}

}  // namespace tyndall::test
