#pragma once
/// Density estimation of a pass: eyes take from the lights of light paths that come near them.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "eye_tracing/eye_tracing.hpp"
#include "light_tracing/light_tracing.hpp"
#include "lights/light_technique.hpp"
#include "pipeline/device_crew.hpp"
#include "visibility/near_search.hpp"

namespace tyndall {

class GatherConnector {
public:
    /// A stage for each device of the render, all of the same program. camera_samples: per pixel and pass.
    GatherConnector(std::vector<PairStage> stages, const ConnectSettings& settings, const LightTechnique& technique, int camera_samples)
        : crew_(std::move(stages), settings), settings_(settings), technique_(technique), share_(1. / camera_samples)
    {
    }

    /// Adds to `image`, one entry per pixel, what eyes take from `lights`. The result depends neither on threads nor on how eyes are cut into pieces.
    void gather(const EyeRecords& eyes, const VirtualLights& lights, const Visibility& visibility, ConnectCounts& counts, std::vector<Rgb>& image);

    const LightTechnique& technique() const { return technique_; }
    std::vector<const PairStage*> stages() const { return crew_.stages(); }
    const ConnectSettings& settings() const { return settings_; }
    std::vector<std::string> warnings() const { return crew_.warnings(); }

private:
    template <typename Eye>
    void gather(std::span<const Eye> eyes, const VirtualLights& lights, const Visibility& visibility, ConnectCounts& counts, std::vector<Rgb>& image);
    template <typename Eye>
    std::vector<std::vector<std::uint32_t>> near(std::span<const Eye> eyes, const Visibility& visibility) const;

    DeviceCrew crew_;
    ConnectSettings settings_;
    const LightTechnique& technique_;
    double share_;
    NearSearch search_;
};

}  // namespace tyndall
