#pragma once
/// The lights that the squares of a region choose among, where a pass has too many lights to estimate them all for every square.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "device/pair_stage.hpp"
#include "light_tracing/light_tracing.hpp"
#include "pipeline/light_selection_plan.hpp"
#include "tiling/connect_pairs.hpp"
#include "tiling/eye_blocks.hpp"

namespace tyndall {

/// Candidates are chosen by estimates too, for 16 eyes of the region, whose shares are averaged. Of more than SelectionPlan::offered lights a region looks at one of
/// several equal parts, drawn at random. Weights keep every light's expected count at 1.
class RegionLights {
public:
    /// Offers the lights to the stage if there are more than twice as many as candidates. `key`: random, of the pass. All references must outlive it.
    RegionLights(PairStage& stage, const VirtualLights& lights, const SelectionPlan& plan, std::uint32_t vertex_limit, std::uint64_t key);

    /// False: squares choose among all lights.
    bool wanted() const { return wanted_; }

    /// Candidates for blocks first ... last - 1, which are a region's. Valid until the next call.
    template <typename Eye>
    LightBatch of(std::span<const Eye> eyes, const EyeBlocks& all, std::size_t first, std::size_t last)
    {
        const std::size_t from = all.blocks[first].standing, count = all.blocks[last - 1].standing + 1 - from;
        std::vector<Eye> standing;
        for (std::size_t i = 0; i < eye_alignment; ++i) standing.push_back(eyes[all.standing[from + (2 * i + 1) * count / (2 * eye_alignment)]]);
        return choose(std::as_bytes(std::span(standing)));
    }

private:
    LightBatch choose(std::span<const std::byte> standing);

    PairStage& stage_;
    const VirtualLights& lights_;
    const SelectionPlan& plan_;
    std::uint64_t key_;
    std::uint32_t regions_ = 0;
    bool wanted_;
    std::vector<std::byte> records_;
    std::vector<float> weights_;
};

}  // namespace tyndall
