#pragma once
/// The kernels whose throughput is measured, ready to run.
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "device/scalar_pairs.hpp"
#include "throughput/workload.hpp"

namespace tyndall {

struct MeasuredKernel {
    std::string_view name;
    WorkloadWishes wishes;
    EyeKind eyes = EyeKind::segments;
    int sampler = SAMPLER_PAPER_ISOTROPIC;
    bool has_baseline = false;  ///< the scalar kernel computes the same
};

/// isotropic, henyey_greenstein, henyey_greenstein_coloured, product, table, surface_points, density_grid; nothing occludes, one sample per pair, independent numbers.
std::span<const MeasuredKernel> measured_kernels();

/// The fused kernel at a lane width, or the scalar kernel, on its own copy of the pairs.
class PairRun {
public:
    /// Compiles. lanes 0: the scalar kernel. Throws BuildError, DeviceError.
    PairRun(Device& device, const MeasuredKernel& kernel, const Workload& work, int lanes);

    /// Connects the first `eyes` eyes (a multiple of eye_alignment; never more than there are) to all lights, and waits.
    void run(std::uint32_t eyes);
    std::uint64_t pairs(std::uint32_t eyes) const;
    std::uint32_t eye_count() const { return eye_count_; }
    int lanes() const { return lanes_; }

    /// r, g, b of the first eyes after a single run.
    std::vector<double> sums(std::uint32_t eyes);

private:
    int lanes_;
    std::uint32_t eye_count_, light_count_;
    std::optional<PairStage> fused_;
    std::optional<ScalarPairs> scalar_;
};

/// The pairs of a kernel, its eyes repeated until there are at least `eyes`.
Workload workload_of(const MeasuredKernel& kernel, std::uint32_t eyes);

/// Share of sums that agree within 1 %, or 0 if the means differ by more than that: both kernels draw the same numbers, so well-conditioned sums agree to rounding.
double agreeing_sums(std::span<const double> ours, std::span<const double> theirs);

}  // namespace tyndall
