#define CL_HPP_TARGET_OPENCL_VERSION 300
#define CL_HPP_MINIMUM_OPENCL_VERSION 200
#define CL_HPP_ENABLE_EXCEPTIONS
#include "tests/volumes/grid_device.hpp"

#include <CL/opencl.hpp>
#include <fstream>
#include <set>
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

struct GridDevice::State {
    unsigned lanes;
    cl::Device device;
    cl::Context context;
    cl::CommandQueue queue;
    cl::Program program;
};

GridDevice::GridDevice(unsigned lanes) : state_(std::make_unique<State>())
{
    State& s = *state_;
    s.lanes = lanes;
    s.device = cl::Device::getDefault();
    s.context = cl::Context(s.device);
    s.queue = cl::CommandQueue(s.context, s.device);
    std::set<std::string> done;
    s.program = cl::Program(s.context, flattened("tests/volumes/evaluate_grid.cl", done));
    try {
        s.program.build(s.device, ("-cl-std=CL1.2 -DLANES=" + std::to_string(lanes)).c_str());
    } catch (const cl::Error&) {
        throw std::runtime_error(s.program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(s.device));
    }
}

GridDevice::~GridDevice() = default;

std::vector<std::array<float, 4>> GridDevice::evaluate(const TestGrid& grid, const std::vector<std::array<float, 6>>& segments) const
{
    const State& s = *state_;
    const std::size_t count = (segments.size() + s.lanes - 1) / s.lanes * s.lanes;
    std::vector<float> in(6 * count), out(4 * count), voxels = grid.voxels;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t f = 0; f < 6; ++f) in[f * count + i] = segments[std::min(i, segments.size() - 1)][f];  // the last one fills the last group
    GridRecord record = grid.record;
    const auto input = [&](std::size_t bytes, void* data) { return cl::Buffer(s.context, CL_MEM_READ_ONLY | CL_MEM_COPY_HOST_PTR, bytes, data); };
    const cl::Buffer device_grid = input(sizeof record, &record), device_voxels = input(sizeof(float) * voxels.size(), voxels.data()),
                     device_in = input(sizeof(float) * in.size(), in.data());
    const cl::Buffer device_out(s.context, CL_MEM_WRITE_ONLY, sizeof(float) * out.size());
    cl::Kernel kernel(s.program, "evaluate_segments");
    kernel.setArg(0, device_grid), kernel.setArg(1, device_voxels), kernel.setArg(2, cl_uint(grid.channels));
    kernel.setArg(3, device_in), kernel.setArg(4, cl_uint(count)), kernel.setArg(5, device_out);
    s.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(count / s.lanes));
    s.queue.enqueueReadBuffer(device_out, CL_TRUE, 0, sizeof(float) * out.size(), out.data());
    std::vector<std::array<float, 4>> result(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) result[i][k] = out[k * count + i];
    return result;
}

}  // namespace tyndall::test
