#pragma once
/// The pairs that `tyndall bench` and every kernel benchmark work on: seeded, documented, the same for all.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "device/pair_stage.hpp"

namespace tyndall {

struct WorkloadWishes {
    std::uint32_t eyes = 2048, lights = 1024;
    bool coloured = false;
    double g = .55;
    float scale = 1;  ///< of all lengths (extinctions follow)
    bool camera =
        false;  ///< eye rays through a grid of 64 pixels a row, 60 degrees wide, as a camera makes them: neighbours run close to each other
    std::uint32_t seed = 5;
    std::uint32_t grid = 0;  ///< voxels along each side of a density grid; 0: none
    bool in_box = false;     ///< eye rays and lights are cut at the box that a grid fills, with or without one
};

/// Eye rays and virtual ray lights in one homogeneous medium.
struct Workload {
    std::vector<EyeSegment> eyes;
    std::vector<EyePoint> points;   ///< where the eye rays end, facing back
    std::vector<std::byte> lights;  ///< VirtualRayLight records
    std::uint32_t light_count = 0;
    MediaTables tables;

    std::span<const std::byte> eye_bytes(EyeKind kind = EyeKind::segments) const
    {
        return kind == EyeKind::segments ? std::as_bytes(std::span(eyes)) : std::as_bytes(std::span(points));
    }
    std::uint64_t pairs() const { return std::uint64_t(eyes.size()) * light_count; }
};

/// Eye rays of length 6 leave (0, 0, -3) towards a cube full of lights: in uniform directions bent towards the axis (|z| + 1 in the place
/// of z), neighbours having nothing in common. Lights start uniformly in the cube [-1, 1]^3, have uniform directions and lengths uniform in
/// [.5, 1.5]. Extinction .5 (coloured: .4, .5, .7), albedo .8, phase function HG.
Workload make_workload(const WorkloadWishes& wishes);

/// The box of grids: [-1.5, 1.5]^3; with eye rays of a camera every one crosses it, and all of the medium is inside. A grid holds max(0, 1 + sum of eight waves
/// with a period of 1 to 4), mean near 1.2.

/// Mask of kernels/shared/scene_features.h that the workload calls for.
std::uint32_t features_of(const WorkloadWishes& wishes);

}  // namespace tyndall
