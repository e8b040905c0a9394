#include "device/prebuild.hpp"

#include "device/device_state.hpp"
#include "kernels/shared/host_features.hpp"

namespace tyndall {
namespace {

/// All subsets of the bits of `mask`, from none to all.
std::vector<std::uint32_t> subsets_of(std::uint32_t mask)
{
    std::vector<std::uint32_t> subsets;
    std::uint32_t subset = 0;
    do {
        subsets.push_back(subset);
        subset = (subset - mask) & mask;  // the next number whose bits are in the mask
    } while (subset != 0);
    return subsets;
}

}  // namespace

std::vector<PairProgram> everyday_programs(int lanes)
{
    std::vector<PairProgram> programs;
    const auto add = [&](EyeKind eyes, std::uint32_t mask) {
        programs.push_back({.eyes = eyes, .features = mask, .lanes = lanes, .sampler = SAMPLER_PAPER_ISOTROPIC, .selection = true});
        if (eyes == EyeKind::segments && (mask & feature_bit::anisotropic)) programs.push_back({.eyes = eyes, .features = mask, .lanes = lanes, .sampler = SAMPLER_PAPER, .selection = true});
    };
    for (const std::uint32_t mask : subsets_of(feature_bit::anisotropic | feature_bit::coloured | feature_bit::occluders)) {
        add(EyeKind::segments, mask);
        for (const std::uint32_t boundary : {0u, feature_bit::boundaries + 0u}) add(EyeKind::points, mask | boundary);
    }
    for (const std::uint32_t mask : subsets_of(feature_bit::anisotropic | feature_bit::occluders)) {
        add(EyeKind::segments, mask | feature_bit::heterogeneous);
        add(EyeKind::points, mask | feature_bit::heterogeneous | feature_bit::boundaries);  // grids lie in containers
    }
    return programs;
}

void prebuild(Device& device, const PairProgram& program)
{
    MediumRecord nothing{};
    nothing.density_grid = nothing.albedo_grid = NO_GRID;
    PairStage stage(device, program, {.media = {nothing}, .containers = {}, .planes = {}});
    const std::vector<std::byte> eyes(eye_alignment * sizeof(EyeSegment)), lights(256);  // larger than any one light's record
    stage.begin(eyes, eye_alignment, lights, 0);
    const EyeBlock block{0, 1, 0, 0, 0, 1, 0, 0};
    if (program.selection) stage.select({.standing = eyes, .standing_count = eye_alignment, .blocks = {&block, 1}, .slots = 1});
    const PairTile tile{0, stage.groups(), 0, 1};
    if (program.features & feature_bit::occluders) {
        stage.sample(0, tile);
        stage.sampled(0);
        stage.accumulate(0);
    } else {
        stage.gather(tile);
    }
    stage.sums();
}

}  // namespace tyndall
