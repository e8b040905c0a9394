/// count [LANES]: what the kernels execute per pair, as JSON: for two numbers of lights, how often each instruction of the kernel's code was executed. PoCL runs the kernel in the thread that asks
/// (its device "basic"); bench/roofline/roofline.py takes the difference of the two and reads the code.
#include <stdlib.h>

#include <cstdio>
#include <memory>
#include <string>

#include "bench/roofline/pair_work.hpp"
#include "bench/roofline/steps.hpp"

namespace tyndall::bench {
namespace {

void count(const std::string& kernel, int lanes, std::uint32_t eyes, std::uint32_t lights)
{
    const SteppedKernel stepped = step_through(kernel == "estimate" ? "estimate_lights" : "gather_lights", [&] {
        setenv("POCL_DEVICES", "basic", 1);
        const auto work = std::make_shared<PairWork>(kernel, lanes, eyes, lights);
        work->run();
        return std::function<void()>([work] { work->run(); });
    });
    std::printf("{\"kernel\": \"%s\", \"lanes\": %d, \"eyes\": %u, \"lights\": %u, \"file\": \"%s\", \"counts\": {", kernel.c_str(), lanes, eyes, lights, stepped.file.c_str());
    const char* comma = "";
    for (const auto& [address, times] : stepped.counts)
        std::printf("%s\"%llu\": %llu", comma, static_cast<unsigned long long>(address), static_cast<unsigned long long>(times)), comma = ", ";
    std::printf("}}");
    std::fflush(stdout);
}

}  // namespace
}  // namespace tyndall::bench

int main(int argc, char** argv)
{
    using namespace tyndall::bench;
    const int lanes = argc > 1 ? atoi(argv[1]) : 16;
    const char* comma = "[\n";
    for (const std::string& kernel : pair_work_names())
        for (const std::uint32_t lights : {16u, 48u}) {
            std::fputs(comma, stdout), comma = ",\n";
            std::fflush(stdout);  // or the child prints it too
            const bool walks = kernel == "density_grid";  // one group of pairs in 64 takes an exact walk: a mean over more of them
            count(kernel, lanes, walks ? 64 : 16, walks ? 4 * lights : lights);
        }
    std::puts("\n]");
}
