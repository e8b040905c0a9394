/// Transmittance through a density grid alone: segments per second, bias and variance of every way to estimate it, at 16 lanes and at one. One core, by
/// processor time. The exact walk is the truth that the others are measured against (tests/volumes holds it against 50 digits).
#include <benchmark/benchmark.h>

#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "bench/measure.hpp"
#include "device/device_state.hpp"
#include "device/kernel_source.hpp"
#include "throughput/workload.hpp"

namespace tyndall::bench {
namespace {

constexpr std::uint32_t segment_count = 1u << 14;
constexpr double mean_depth = 3.6;

Device& device()
{
    static Device opened;
    return opened;
}

/// The smooth grid of throughput/workload.hpp, and segments between points that are drawn in proportion to its density.
struct GridSegments {
    MediaTables tables;
    std::vector<float> coordinates;  ///< six rows of segment_count

    explicit GridSegments(std::uint32_t voxels) : tables(make_workload({.eyes = 64, .lights = 1, .camera = true, .grid = voxels, .in_box = true}).tables), coordinates(6 * segment_count)
    {
        std::mt19937 engine(7);
        std::uniform_real_distribution<float> uniform(0, 1);
        const float most = *std::max_element(tables.voxels.begin(), tables.voxels.end());
        for (std::uint32_t i = 0; i < segment_count; ++i)
            for (std::uint32_t end = 0; end < 2; ++end)
                for (;;) {
                    const float p[3] = {uniform(engine), uniform(engine), uniform(engine)};
                    const auto cell = [&](int k) { return std::size_t(p[k] * float(voxels)); };
                    if (uniform(engine) * most > tables.voxels[(cell(2) * voxels + cell(1)) * voxels + cell(0)]) continue;
                    for (std::uint32_t k = 0; k < 3; ++k) coordinates[(3 * end + k) * segment_count + i] = 3 * p[k] - 1.5f;
                    break;
                }
    }
};

class Estimator {
public:
    Estimator(const GridSegments& segments, int method, int steps, int lanes) : lanes_(static_cast<std::uint32_t>(lanes))
    {
        std::ifstream file(TYNDALL_SOURCE_DIR "/bench/transmittance.cl");
        std::stringstream text;
        text << flattened_kernel("kernels/math/maths.h", {}) << flattened_kernel("kernels/volumes/grid_march.h", {}) << file.rdbuf();
        if (!file) throw BuildError("bench/transmittance.cl cannot be read; run the benchmark where it was built");
        const std::string options = "-cl-std=CL1.2 -DLANES=" + std::to_string(lanes) + " -DMETHOD=" + std::to_string(method) + " -DSTEPS=" + std::to_string(steps);
        kernel_ = cl::Kernel(build_program(state_, text.str(), options), "transmittances");
        kernel_.setArg(0, grids_.upload(state_, std::as_bytes(std::span(segments.tables.grids))));
        kernel_.setArg(1, voxels_.upload(state_, std::as_bytes(std::span(segments.tables.voxels))));
        kernel_.setArg(2, segments_.upload(state_, std::as_bytes(std::span(segments.coordinates))));
        kernel_.setArg(3, segment_count);
        kernel_.setArg(6, out_.reserve(state_, segment_count * sizeof(float)));
    }

    void run(float sigma_t, std::uint32_t seed)
    {
        kernel_.setArg(4, sigma_t), kernel_.setArg(5, seed);
        on_device(state_, "measuring transmittance", [&] {
            state_.queue.enqueueNDRangeKernel(kernel_, cl::NullRange, cl::NDRange(segment_count / lanes_), cl::NDRange(8));
            state_.queue.finish();
        });
    }
    std::vector<float> values(float sigma_t, std::uint32_t seed)
    {
        run(sigma_t, seed);
        std::vector<float> values(segment_count);
        state_.queue.enqueueReadBuffer(out_.get(), CL_TRUE, 0, values.size() * sizeof(float), values.data());
        return values;
    }

private:
    DeviceState& state_ = device().state();
    std::uint32_t lanes_;
    cl::Kernel kernel_;
    GrowingBuffer grids_{CL_MEM_READ_ONLY}, voxels_{CL_MEM_READ_ONLY}, segments_{CL_MEM_READ_ONLY}, out_{CL_MEM_READ_WRITE};
};

/// Extinction for which the segments' mean optical depth is mean_depth: depths are taken from the exact transmittances of a thin medium.
float extinction_of(const GridSegments& segments)
{
    constexpr float thin = .01f;
    double sum = 0;
    for (const float t : Estimator(segments, 0, 0, 16).values(thin, 0)) sum -= std::log(double(t)) / double(thin) / segment_count;
    return float(mean_depth / sum);
}

struct Method {
    const char* name;
    int method, steps;
};
constexpr Method methods[] = {{"exact", 0, 0},     {"voxels_8", 1, 8},  {"voxels_16", 1, 16}, {"voxels_32", 1, 32}, {"values_8", 2, 8},
                              {"values_16", 2, 16}, {"values_32", 2, 32}, {"march", 1, 0},      {"march_corrected", 3, 0}};

/// bias: sum of the means over the sum of the truths, - 1. relative_variance: sum of the variances over the sum of the squared truths.
void estimate(benchmark::State& state, const Method& method, std::uint32_t voxels, int lanes)
{
    const GridSegments segments(voxels);
    const float sigma_t = extinction_of(segments);
    const std::vector<float> truth = Estimator(segments, 0, 0, 16).values(sigma_t, 0);
    Estimator estimator(segments, method.method, method.steps, lanes);
    constexpr std::uint32_t seeds = 64;
    double bias = 0, variance = 0, sum = 0, squares = 0;
    std::vector<double> seconds;
    for (auto _ : state) {
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            const std::vector<float> values = estimator.values(sigma_t, 2 * seed);
            for (std::size_t i = 0; i < segment_count; ++i) {
                const double t = double(truth[i]), off = double(values[i]) - t;
                bias += off, variance += off * off, sum += t, squares += t * t;
            }
        }
        for (int i = 0; i < 9; ++i) seconds.push_back(processor_seconds_of([&] { estimator.run(sigma_t, 1); }));
        state.SetIterationTime(median(seconds));
    }
    state.counters["segments_per_second"] = segment_count / median(seconds);
    state.counters["bias"] = bias / sum;
    state.counters["relative_variance"] = variance / squares;
}

}  // namespace
}  // namespace tyndall::bench

int main(int argc, char** argv)
{
    using namespace tyndall::bench;
    use_workers(1);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::AddCustomContext("device", device().info().platform + ": " + device().info().name + ", driver " + device().info().driver);
    for (const std::uint32_t voxels : {64u, 256u})
        for (const Method& method : methods)
            for (const int lanes : {1, 16})
                if (lanes == 16 || voxels == 64)
                    benchmark::RegisterBenchmark(("transmittance/voxels:" + std::to_string(voxels) + "/" + method.name + "/lanes:" + std::to_string(lanes)).c_str(), &estimate, method, voxels, lanes)
                        ->UseManualTime()
                        ->Iterations(1)
                        ->Unit(benchmark::kMillisecond);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
