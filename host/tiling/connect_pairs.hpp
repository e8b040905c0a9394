#pragma once
/// Cuts eyes x lights into tiles and takes each through sampling, visibility and accumulation. Where the device's threads run functions of the host, they answer shadow segments too, two tiles at a time;
/// elsewhere the host answers one tile's while the device samples the next.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "device/pair_stage.hpp"
#include "tyndall/stop.hpp"
#include "visibility/visibility.hpp"

namespace tyndall {

inline constexpr std::uint32_t shadowed_pairs = 1u << 15;  ///< per tile with shadow segments: packets and contributions stay in a core's cache
inline constexpr std::uint32_t chained_pairs = 1u << 14;   ///< the same where a tile costs the host no waking up

/// Eyes of a tile of about that many pairs that have shadow segments, where each eye has `lights` of them; its lights lie in one block.
inline std::uint32_t shadowed_tile_eyes(std::uint32_t pairs, std::uint32_t lights) { return std::max(pairs / std::clamp(lights, 1u, light_block), eye_alignment); }

/// Raw eye records, a multiple of eye_alignment of them, and what the host needs to know of each.
struct EyeBatch {
    std::span<const std::byte> records;
    std::uint32_t count = 0;
    std::vector<int> media;  ///< the medium that each eye is in (vacuum: -1); needed only where connections are walked on the host
};

struct LightBatch {
    std::span<const std::byte> records;
    std::uint32_t count = 0;
    std::span<const float> weights{};  ///< what each counts for; empty: 1
};

struct ConnectSettings {
    std::uint32_t features = 0, samples = 1, vertex_limit = 0xffffffffu;
    std::uint32_t tile_pairs = 0;  ///< 0: default for the pipeline
    int lanes = 1;
    std::uint32_t sums_of_eye = 1;  ///< PairProgram's
    bool native_kernels = true;      ///< the device's threads answer shadow segments where they can; no bit depends on it
    const StopFlag* stop = nullptr;  ///< raised: Stopped is thrown
};

struct ConnectCounts {
    std::uint64_t pairs = 0, shadow_segments = 0;
    double visibility_seconds = 0;  ///< of all threads that answer tiles
};

/// Answers a tile's shadow segments, in its packets (tfar -infinity: blocked) or by multiplying its contributions; returns how many were asked.
using ShadowAnswer = std::function<std::uint64_t(const SampledTile&, const PairTile&)>;

/// Multiplies the contribution of lane `i` of packet `p` by `factor` per channel; all channels of an eye with a clamp.
void scale_contribution(const SampledTile& sampled, const PairTile& tile, const ConnectSettings& settings, std::size_t p, std::size_t i, const Rgb& factor);

/// Sum over all lights, or over those that `selection` has chosen, of what they send to each eye: r, g, b per eye, as PairStage::sums gives them. Byte-equal for every tile size.
std::vector<double> connect_pairs(PairStage& stage, const Visibility& visibility, const EyeBatch& eyes, const LightBatch& lights, const ConnectSettings& settings,
                                  ConnectCounts& counts, const LightSelection* selection = nullptr);

/// The same with shadow segments that somebody else answers.
std::vector<double> connect_pairs(PairStage& stage, const ShadowAnswer& answer, const EyeBatch& eyes, const LightBatch& lights, const ConnectSettings& settings, ConnectCounts& counts,
                                  const LightSelection* selection = nullptr);

}  // namespace tyndall
