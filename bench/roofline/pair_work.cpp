#include "bench/roofline/pair_work.hpp"

#include <algorithm>

#include "throughput/measured_kernels.hpp"

namespace tyndall::bench {
namespace {

const MeasuredKernel& measured(const std::string& name)
{
    for (const MeasuredKernel& kernel : measured_kernels())
        if (kernel.name == name) return kernel;
    return measured("henyey_greenstein");  // what is estimated
}

Workload workload(const std::string& name, std::uint32_t eyes, std::uint32_t lights)
{
    WorkloadWishes wishes = measured(name).wishes;
    wishes.eyes = eyes, wishes.lights = lights;
    return make_workload(wishes);
}

}  // namespace

std::vector<std::string> pair_work_names()
{
    std::vector<std::string> names;
    for (const MeasuredKernel& kernel : measured_kernels()) names.emplace_back(kernel.name);
    names.emplace_back("estimate");
    return names;
}

PairWork::PairWork(const std::string& kernel, int lanes, std::uint32_t eyes, std::uint32_t lights) : estimates_(kernel == "estimate"), work_(workload(kernel, eyes, lights))
{
    const MeasuredKernel& like = measured(kernel);
    stage_ = std::make_unique<PairStage>(
        device_, PairProgram{.eyes = like.eyes, .features = features_of(like.wishes), .lanes = lanes, .sampler = like.sampler, .selection = estimates_}, work_.tables);
    stage_->begin(work_.eye_bytes(like.eyes), eyes, work_.lights, 0xffffffffu);
}

void PairWork::run()
{
    const EyeBlock block{0, 1, 0, 0, 0, 1, 0, 0};
    if (estimates_) stage_->select({.standing = work_.eye_bytes(), .standing_count = static_cast<std::uint32_t>(work_.eyes.size()), .blocks = {&block, 1}, .slots = 1});
    else stage_->gather({0, stage_->groups(), 0, work_.light_count});
    stage_->ledger();  // waits
}

}  // namespace tyndall::bench
