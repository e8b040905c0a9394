#pragma once
/// The caller's lights and eyes as the device's records: checked, in render space.
#include <span>
#include <vector>

#include "kernels/shared/records.hpp"
#include "lights/light_technique.hpp"
#include "tyndall/backend.hpp"

namespace tyndall {

/// The caller's space to render space, where the box's half diagonal lies in (1/2, 1]; lengths are divided by `unit`, powers by its square (scene/render_space.hpp).
struct BackendSpace {
    Vec3 low, high;  ///< the caller's box
    Vec3 centre;
    double unit;

    /// Throws UsageError unless the box is finite and has an extent.
    BackendSpace(const api::Triple& low, const api::Triple& high);
    Vec3 to_render(const Vec3& p) const { return (p - centre) / unit; }
    api::Triple from_render(const Vec3& p) const;
};

/// All throw UsageError, which names the record by its index. `media`: how many there are.
std::vector<std::byte> light_records(std::span<const api::RayLight> lights, const BackendSpace& space, std::size_t media);
std::vector<std::byte> light_records(std::span<const api::PointLight> lights, const BackendSpace& space, std::size_t media);
std::vector<EyeSegment> eye_records(std::span<const api::EyeSegment> eyes, const BackendSpace& space, std::size_t media);
std::vector<EyePoint> eye_records(std::span<const api::EyePoint> eyes, const BackendSpace& space, std::size_t media);

}  // namespace tyndall
