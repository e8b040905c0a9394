/// peaks [LANES]: what one core can do at most (clock, instructions per cycle, arithmetic, divisions, roots, loads from each cache), and seconds per estimate of a light, as JSON. Processor time, best of seven.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "bench/measure.hpp"
#include "bench/roofline/pair_work.hpp"
#include "device/device_state.hpp"

namespace tyndall::bench {
namespace {

template <typename Work>
double best_seconds(Work&& work)
{
    work();
    double best = 1e9;
    for (int i = 0; i < 7; ++i) best = std::min(best, processor_seconds_of(work));
    return best;
}

constexpr std::uint32_t loops = 2'000'000;

/// A chain of rotations, each of which waits for the one before: one per cycle (additions of a constant are folded by some processors).
double cycles_per_second()
{
    const double seconds = best_seconds([] {
        std::uint64_t x = 0;
        for (std::uint32_t i = 0; i < loops; ++i) asm volatile(".rept 64\n\tror $1, %0\n\t.endr" : "+r"(x));
    });
    return 64. * loops / seconds;
}

double instructions_per_second()
{
    const double seconds = best_seconds([] {
        for (std::uint32_t i = 0; i < loops; ++i) asm volatile(".rept 64\n\tnop\n\t.endr");
    });
    return 64. * loops / seconds;
}

class Peaks {
public:
    Peaks()
    {
        std::ifstream file(TYNDALL_SOURCE_DIR "/bench/roofline/peaks.cl");
        std::stringstream text;
        text << file.rdbuf();
        if (!file) throw BuildError("bench/roofline/peaks.cl cannot be read; run the benchmark where it was built");
        program_ = build_program(state_, text.str(), "-cl-std=CL1.2");
    }

    /// Operations on 16 lanes per second.
    double operations(const char* name)
    {
        constexpr std::uint32_t rounds = 1 << 20;
        cl::Kernel kernel(program_, name);
        kernel.setArg(0, rounds), kernel.setArg(1, 1e-6f), kernel.setArg(2, out_.reserve(state_, 64));
        return 12. * rounds / best_seconds([&] { launch(kernel); });
    }

    /// Bytes per second out of an array of so many.
    double bytes(std::uint32_t size)
    {
        const std::vector<std::byte> zero(size);
        const std::uint32_t rounds = (1u << 30) / size;
        cl::Kernel kernel(program_, "loaded");
        kernel.setArg(0, rounds), kernel.setArg(1, size / 64), kernel.setArg(2, in_.upload(state_, zero)), kernel.setArg(3, out_.reserve(state_, 64));
        return double(rounds) * size / best_seconds([&] { launch(kernel); });
    }

private:
    void launch(cl::Kernel& kernel)
    {
        state_.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(1), cl::NDRange(1));
        state_.queue.finish();
    }

    Device device_;
    DeviceState& state_ = device_.state();
    cl::Program program_;
    GrowingBuffer in_{CL_MEM_READ_ONLY}, out_{CL_MEM_READ_WRITE};
};

}  // namespace
}  // namespace tyndall::bench

int main(int argc, char** argv)
{
    using namespace tyndall::bench;
    use_workers(1);
    std::printf("{\"cycles_per_second\": %.4g, \"instructions_per_second\": %.4g", cycles_per_second(), instructions_per_second());
    Peaks peaks;
    for (const char* name : {"fused", "divided", "rooted"}) std::printf(", \"%s_per_second\": %.4g", name, peaks.operations(name));
    for (const auto& [name, size] : {std::pair("l1", 1u << 14), std::pair("l2", 1u << 20), std::pair("memory", 1u << 28)})
        std::printf(", \"%s_bytes_per_second\": %.4g", name, peaks.bytes(size));
    PairWork estimate("estimate", argc > 1 ? atoi(argv[1]) : 16, 2048, 1024);
    std::printf(", \"seconds_per_estimate\": %.4g}\n", best_seconds([&] { estimate.run(); }) / estimate.pairs());
}
