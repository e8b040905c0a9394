#include "tiling/connect_pairs.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>

#include "kernels/shared/host_features.hpp"
#include "parallel/parallel_for.hpp"

namespace tyndall {
namespace {

constexpr std::uint32_t fused_pairs = 4u << 20;  ///< per tile; the stage cuts it into launches
constexpr std::uint32_t longest_row = 1024;      ///< lights times samples that one work-item of a fused tile goes through, unless a block has more

/// Tiles in the order in which they are summed: blocks of lights in order, for each block all eyes.
std::vector<PairTile> tiles_of(std::uint32_t groups, std::uint32_t lights, std::uint32_t pairs_per_tile, const ConnectSettings& settings)
{
    const bool fused = (settings.features & feature_bit::occluders) == 0;
    const std::uint32_t lanes = static_cast<std::uint32_t>(settings.lanes), aligned = eye_alignment / lanes;
    const std::uint32_t wanted = pairs_per_tile / settings.samples;
    const std::uint32_t most_eyes = fused ? 1u << 14 : shadowed_tile_eyes(wanted, lights);
    const std::uint32_t tile_groups = std::max(std::min(groups, most_eyes / lanes) / aligned * aligned, aligned);
    const std::uint32_t row = std::min(wanted / (tile_groups * lanes), longest_row / settings.samples);
    const std::uint32_t tile_lights = fused ? std::max(row / light_block, 1u) * light_block : light_block;
    std::vector<PairTile> tiles;
    for (std::uint32_t light = 0; light < lights; light += tile_lights)
        for (std::uint32_t group = 0; group < groups; group += tile_groups)
            tiles.push_back({group, std::min(tile_groups, groups - group), light, std::min(tile_lights, lights - light)});
    return tiles;
}

/// Multiplies the contributions of packet `p` by the transmittance of their connections, through null boundaries.
std::uint64_t walk_packet(const Visibility& visibility, const SampledTile& sampled, const PairTile& tile, const ConnectSettings& settings, std::size_t p, std::span<const int> media)
{
    std::uint64_t asked = 0;
    const ShadowPacket& packet = sampled.packets[p];
    for (std::size_t i = 0; i < SHADOW_PACKET_SIZE; ++i) {
        if (packet.tfar[i] < packet.tnear[i]) continue;
        ++asked;
        const Vec3 from{packet.origin_x[i], packet.origin_y[i], packet.origin_z[i]};
        const Vec3 to = from + Vec3{packet.direction_x[i], packet.direction_y[i], packet.direction_z[i]};
        scale_contribution(sampled, tile, settings, p, i, visibility.transmittance(from, media[i], to));
    }
    return asked;
}

/// Answers a tile's shadow segments, on the calling thread `alone` or on all; returns how many were asked.
std::uint64_t answer(const Visibility& visibility, const SampledTile& sampled, const PairTile& tile, const EyeBatch& eyes, const ConnectSettings& settings, bool alone)
{
    const std::size_t lanes = static_cast<std::size_t>(settings.lanes), pairs = std::size_t(tile.lights) * settings.samples;
    std::atomic<std::uint64_t> asked{0};
    if (settings.features & feature_bit::nonconvex_media) {
        const auto walk = [&](std::size_t p) {
            const std::span<const int> media(eyes.media.data() + std::size_t(tile.first_group) * lanes + p / pairs * SHADOW_PACKET_SIZE, SHADOW_PACKET_SIZE);
            asked += walk_packet(visibility, sampled, tile, settings, p, media);
        };
        if (!alone) parallel_for(std::size_t(0), sampled.packets.size(), walk);
        else for (std::size_t p = 0; p < sampled.packets.size(); ++p) walk(p);
        return asked;
    }
    for (const ShadowPacket& packet : sampled.packets)
        asked += static_cast<std::uint64_t>(std::count_if(std::begin(packet.tfar), std::end(packet.tfar), [](float t) { return t >= 0; }));
    alone ? visibility.occluded_here(sampled.packets) : visibility.occluded(sampled.packets);
    return asked;
}

double seconds_since(std::chrono::steady_clock::time_point start) { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); }

/// The host answers a tile's shadow segments while the device samples the next.
void connect_in_turns(PairStage& stage, const ShadowAnswer& shadows, std::span<const PairTile> tiles, const StopFlag* stop, ConnectCounts& counts)
{
    if (!tiles.empty()) stage.sample(0, tiles[0]);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        throw_if_raised(stop);
        const int slot = static_cast<int>(i % 2);
        if (i + 1 < tiles.size()) stage.sample(1 - slot, tiles[i + 1]);
        const SampledTile sampled = stage.sampled(slot);
        const auto start = std::chrono::steady_clock::now();
        counts.shadow_segments += shadows(sampled, tiles[i]);
        counts.visibility_seconds += seconds_since(start);
        stage.accumulate(slot);
    }
}

/// The device's own threads do everything, two tiles at a time.
void connect_chained(PairStage& stage, const ShadowAnswer& shadows, std::span<const PairTile> tiles, const StopFlag* stop, ConnectCounts& counts)
{
    struct Guard {
        PairStage& stage;
        ~Guard() { stage.drop_chain(); }
    };
    std::atomic<std::uint64_t> asked{0};
    std::atomic<double> seconds{0};
    const Guard guard{stage};  // before what the tiles' work uses goes away
    for (const PairTile& tile : tiles) {
        throw_if_raised(stop);
        stage.chain(tile, [&shadows, &asked, &seconds, stop, tile](const SampledTile& sampled) {
            throw_if_raised(stop);
            const auto start = std::chrono::steady_clock::now();
            asked += shadows(sampled, tile);
            seconds += seconds_since(start);
        });
    }
    stage.end_chain();
    counts.shadow_segments += asked, counts.visibility_seconds += seconds;
}

/// chained: `shadows` may be called by several threads, at once.
std::vector<double> connect(PairStage& stage, const ShadowAnswer& shadows, bool chained, const EyeBatch& eyes, const LightBatch& lights, const ConnectSettings& settings, ConnectCounts& counts,
                            const LightSelection* selection)
{
    stage.begin(eyes.records, eyes.count, lights.records, settings.vertex_limit, lights.weights);
    if (selection) stage.select(*selection);
    const std::uint32_t slots = selection && lights.count > 0 ? selection->slots : lights.count;
    const bool fused = (settings.features & feature_bit::occluders) == 0;
    const std::uint32_t wanted = std::max(settings.tile_pairs ? settings.tile_pairs : fused ? fused_pairs : chained ? chained_pairs : shadowed_pairs, 1u);
    const std::vector<PairTile> tiles = tiles_of(stage.groups(), slots, fused ? wanted : stage.most_sampled(wanted), settings);
    counts.pairs += std::uint64_t(eyes.count) * slots * settings.samples;
    if (fused)
        for (const PairTile& tile : tiles) throw_if_raised(settings.stop), stage.gather(tile);
    else (chained ? connect_chained : connect_in_turns)(stage, shadows, tiles, settings.stop, counts);
    return stage.sums();
}

}  // namespace

void scale_contribution(const SampledTile& sampled, const PairTile& tile, const ConnectSettings& settings, std::size_t p, std::size_t i, const Rgb& factor)
{
    const std::size_t lanes = static_cast<std::size_t>(settings.lanes), pairs = std::size_t(tile.lights) * settings.samples, channels = 3 * settings.sums_of_eye;
    const std::size_t group = p / pairs * SHADOW_PACKET_SIZE / lanes + i / lanes, first = (group * pairs + p % pairs) * channels * lanes + i % lanes;
    for (std::size_t c = 0; c < channels; ++c) sampled.contributions[first + c * lanes] *= static_cast<float>(factor[static_cast<int>(c % 3)]);
}

std::vector<double> connect_pairs(PairStage& stage, const Visibility& visibility, const EyeBatch& eyes, const LightBatch& lights, const ConnectSettings& settings,
                                  ConnectCounts& counts, const LightSelection* selection)
{
    const bool chained = settings.native_kernels && stage.runs_native_kernels();
    const ShadowAnswer by_embree = [&](const SampledTile& sampled, const PairTile& tile) { return answer(visibility, sampled, tile, eyes, settings, chained); };
    return connect(stage, by_embree, chained, eyes, lights, settings, counts, selection);
}

std::vector<double> connect_pairs(PairStage& stage, const ShadowAnswer& shadows, const EyeBatch& eyes, const LightBatch& lights, const ConnectSettings& settings, ConnectCounts& counts,
                                  const LightSelection* selection)
{
    return connect(stage, shadows, false, eyes, lights, settings, counts, selection);
}

}  // namespace tyndall
