#pragma once
/// Connects the eyes of a pass with its virtual lights: with all of them, or with those that are chosen for each block of pixels.
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "eye_tracing/eye_tracing.hpp"
#include "light_tracing/light_tracing.hpp"
#include "lights/light_technique.hpp"
#include "pipeline/device_crew.hpp"
#include "pipeline/light_selection_plan.hpp"
#include "pipeline/region_lights.hpp"
#include "tiling/connect_pairs.hpp"
#include "tiling/eye_blocks.hpp"

namespace tyndall {

class EyeConnector {
public:
    /// A stage for each device of the render, all of the same program.
    EyeConnector(std::vector<PairStage> stages, const ConnectSettings& settings, const SelectionPlan& selection, int film_width)
        : crew_(std::move(stages), settings), settings_(settings), selection_(selection), film_width_(film_width)
    {
    }

    /// Adds to `image`, one entry per pixel, what `lights` send to the eyes of that kind. `key`: random, of the pass.
    void connect(const EyeRecords& eyes, EyeKind kind, const VirtualLights& lights, const Visibility& visibility, std::uint64_t key, ConnectCounts& counts,
                 std::vector<Rgb>& image);

    /// The pair that added most to a pixel in the last `connect`, in units of that pixel's radiance in the pass (sum of channels).
    struct Worst {
        std::uint32_t pixel = 0;
        double radiance = 0;
    };
    const Worst& worst() const { return worst_; }
    /// With a clamp: what it let through and what it took away, summed over channels, eyes and passes.
    double kept_light() const { return kept_; }
    double removed_light() const { return removed_; }
    /// Share of the light of all passes that the clamp took away; negative: no clamp.
    double removed_share() const { return settings_.sums_of_eye < 2 ? -1 : removed_ > 0 ? removed_ / (removed_ + kept_) : 0; }

    std::vector<const PairStage*> stages() const { return crew_.stages(); }
    const ConnectSettings& settings() const { return settings_; }
    std::vector<std::string> warnings() const { return crew_.warnings(); }

private:
    /// Adds an eye's sums to its pixel.
    void add(const std::vector<double>& sums, std::size_t eye, double share, Rgb& pixel);
    template <typename Eye>
    void note_worst(const PairStage& stage, std::span<const Eye> eyes, double share);
    template <typename Eye>
    void connect_all(std::span<const Eye> eyes, const VirtualLights& lights, const Visibility& visibility, ConnectCounts& counts, std::vector<Rgb>& image);
    /// Eyes first ... last - 1 of the blocks' order, in batches.
    template <typename Eye>
    void connect_blocks(std::span<const Eye> eyes, const EyeBlocks& all, std::size_t first_block, std::size_t last_block, const LightBatch& lights, const Visibility& visibility,
                        ConnectCounts& counts, std::vector<Rgb>& image);
    template <typename Eye>
    void connect_chosen(std::span<const Eye> eyes, std::span<const std::size_t> ends, const VirtualLights& lights, const Visibility& visibility, std::uint64_t key, ConnectCounts& counts,
                        std::vector<Rgb>& image);

    DeviceCrew crew_;
    ConnectSettings settings_;
    SelectionPlan selection_;
    int film_width_;
    std::mutex worst_guard_;
    Worst worst_;
    double removed_ = 0, kept_ = 0;  ///< sums over channels, eyes and passes
};

}  // namespace tyndall
