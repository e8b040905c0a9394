#pragma once
/// kernels/baseline/scalar_pairs.cl on a device: what the fused kernel is measured against. Includes no OpenCL header.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "device/device.hpp"
#include "kernels/shared/records.hpp"

namespace tyndall {

/// Records of eye segments and virtual ray lights; all in the first medium.
struct ScalarPairsInput {
    std::span<const EyeSegment> eyes;
    std::span<const std::byte> lights;  ///< VirtualRayLight records
    std::uint32_t light_count = 0;
    std::span<const MediumRecord> media;
    std::uint32_t features = 0;  ///< of kernels/shared/scene_features.h; anisotropic and coloured mean something
};

class ScalarPairs {
public:
    /// Compiles the kernel and copies the records to the device. Throws BuildError, DeviceError.
    ScalarPairs(Device& device, const ScalarPairsInput& input);
    ~ScalarPairs();
    ScalarPairs(ScalarPairs&&) noexcept;

    /// Connects the first `eyes` eyes to all lights, and waits.
    void run(std::uint32_t eyes);
    /// r, g, b per eye, summed over all lights, as the last run left them.
    std::vector<float> sums() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tyndall
