#include "throughput/measured_kernels.hpp"

#include <algorithm>
#include <cmath>

namespace tyndall {

std::span<const MeasuredKernel> measured_kernels()
{
    static const MeasuredKernel all[] = {
        {.name = "isotropic", .wishes = {.g = 0}, .has_baseline = true},
        {.name = "henyey_greenstein", .wishes = {}, .has_baseline = true},
        {.name = "henyey_greenstein_coloured", .wishes = {.coloured = true}, .has_baseline = true},
        {.name = "product", .wishes = {}, .sampler = SAMPLER_PAPER},
        {.name = "table", .wishes = {}, .sampler = SAMPLER_TABLE},
        {.name = "surface_points", .wishes = {}, .eyes = EyeKind::points},
        {.name = "density_grid", .wishes = {.g = 0, .camera = true, .grid = 64, .in_box = true}},
    };
    return all;
}

Workload workload_of(const MeasuredKernel& kernel, std::uint32_t eyes)
{
    Workload work = make_workload(kernel.wishes);
    const std::size_t own = work.eyes.size();
    for (std::size_t i = own; i < eyes || i % eye_alignment != 0; ++i) work.eyes.push_back(work.eyes[i - own]), work.points.push_back(work.points[i - own]);
    return work;
}

PairRun::PairRun(Device& device, const MeasuredKernel& kernel, const Workload& work, int lanes)
    : lanes_(lanes), eye_count_(static_cast<std::uint32_t>(work.eyes.size())), light_count_(work.light_count)
{
    const std::uint32_t features = features_of(kernel.wishes);
    if (lanes == 0) {
        scalar_.emplace(device, ScalarPairsInput{work.eyes, work.lights, work.light_count, work.tables.media, features});
        return;
    }
    fused_.emplace(device, PairProgram{.eyes = kernel.eyes, .features = features, .lanes = lanes, .sampler = kernel.sampler}, work.tables);
    fused_->begin(work.eye_bytes(kernel.eyes), eye_count_, work.lights, 0xffffffffu);
}

void PairRun::run(std::uint32_t eyes)
{
    if (scalar_) return scalar_->run(eyes);
    fused_->gather({0, std::min(eyes, eye_count_) / static_cast<std::uint32_t>(lanes_), 0, light_count_});
    fused_->wait();
}

std::uint64_t PairRun::pairs(std::uint32_t eyes) const { return std::uint64_t(std::min(eyes, eye_count_)) * light_count_; }

std::vector<double> PairRun::sums(std::uint32_t eyes)
{
    std::vector<double> sums;
    if (fused_) {
        sums = fused_->sums();
    } else {
        const std::vector<float> raw = scalar_->sums();
        sums.assign(raw.begin(), raw.end());
    }
    sums.resize(3 * std::size_t(std::min(eyes, eye_count_)));
    return sums;
}

double agreeing_sums(std::span<const double> ours, std::span<const double> theirs)
{
    double sum = 0, their_sum = 0, close = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        sum += ours[i], their_sum += theirs[i];
        close += std::abs(ours[i] - theirs[i]) <= .01 * ours[i];
    }
    return std::abs(sum / their_sum - 1) < .01 ? close / static_cast<double>(ours.size()) : 0;
}

}  // namespace tyndall
