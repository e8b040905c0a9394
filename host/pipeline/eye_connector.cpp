#include "pipeline/eye_connector.hpp"

#include <algorithm>

#include "pipeline/memory_estimate.hpp"
#include "tiling/eye_blocks.hpp"
#include "transport/random_sequence.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

template <typename Eye>
Eye without_throughput(Eye eye)
{
    eye.throughput_r = eye.throughput_g = eye.throughput_b = 0;
    return eye;
}

/// Records padded with copies that carry nothing, so that groups of lanes are full.
template <typename Eye>
std::vector<Eye> padded(std::span<const Eye> eyes)
{
    std::vector<Eye> all(eyes.begin(), eyes.end());
    while (all.size() % eye_alignment != 0) all.push_back(without_throughput(all.back()));
    return all;
}

template <typename Eye>
EyeBatch batch_of(const std::vector<Eye>& eyes)
{
    EyeBatch batch{std::as_bytes(std::span(eyes)), static_cast<std::uint32_t>(eyes.size()), {}};
    for (const Eye& eye : eyes) batch.media.push_back(eye.medium == NO_MEDIUM ? vacuum : static_cast<int>(eye.medium));
    return batch;
}

/// Adds what lights send to eye i.
void add(const std::vector<double>& sums, std::size_t i, double share, Rgb& pixel) { pixel += Rgb(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]) * share; }

/// Some of the blocks: their eyes as records, and their places counted from the first of them.
template <typename Eye>
struct BlockBatch {
    std::vector<Eye> eyes, standing;
    std::vector<EyeBlock> blocks;

    BlockBatch(std::span<const Eye> all, const EyeBlocks& from, std::size_t first, std::size_t last)
    {
        const EyeBlock start = from.blocks[first], end = from.blocks[last - 1];
        for (std::size_t b = first; b < last; ++b) {
            blocks.push_back(from.blocks[b]);
            blocks.back().first -= start.first, blocks.back().standing -= start.standing;
        }
        for (std::uint32_t i = start.standing; i <= end.standing; ++i) standing.push_back(all[from.standing[i]]);
        for (std::size_t i = start.first * std::size_t(eye_alignment); i < (end.first + end.groups) * std::size_t(eye_alignment); ++i)
            eyes.push_back(from.order[i] == no_eye ? without_throughput(eyes.back()) : all[from.order[i]]);
        standing = padded(std::span<const Eye>(standing));
    }
};

/// The block after the last that fits a batch.
std::size_t batch_end(const EyeBlocks& all, std::size_t first, std::size_t end, std::size_t most_eyes, std::size_t lights)
{
    const std::size_t most_standing = std::max<std::size_t>(estimates_at_a_time / std::max<std::size_t>(lights, 1), 1);
    std::size_t last = first + 1;
    while (last < end && all.blocks[last].standing - all.blocks[first].standing < most_standing &&
           std::size_t(all.blocks[last].first + all.blocks[last].groups - all.blocks[first].first) * eye_alignment <= most_eyes)
        ++last;
    return last;
}

}  // namespace

std::optional<std::vector<double>> EyeConnector::try_pairs(const EyeBatch& eyes, const LightBatch& lights, const Visibility& visibility, ConnectCounts& counts, const LightSelection* selection)
{
    ConnectCounts here;
    try {
        std::vector<double> sums = connect_pairs(stage_, visibility, eyes, lights, settings_, here, selection);
        counts.pairs += here.pairs, counts.shadow_segments += here.shadow_segments, counts.visibility_seconds += here.visibility_seconds;
        return sums;
    } catch (const ResourceError& error) {
        const std::uint32_t pairs = settings_.tile_pairs ? settings_.tile_pairs : shadowed_pairs;
        if (most_eyes_ <= eye_alignment && pairs <= eye_alignment * light_block) throw;
        most_eyes_ = std::max<std::size_t>(std::min<std::size_t>(most_eyes_, eyes.count) / 2 / eye_alignment, 1) * eye_alignment;
        settings_.tile_pairs = std::max(pairs / 2, eye_alignment * light_block);
        ++shortages_, shortage_ = error.what();
        stage_.recover();
        return std::nullopt;
    }
}

std::string EyeConnector::shortage() const
{
    if (shortages_ == 0) return {};
    return "the device ran short " + std::to_string(shortages_) + " times, and did the same with less at a time, in the end " + std::to_string(most_eyes_) + " eyes and tiles of " +
           std::to_string(settings_.tile_pairs) + " pairs; the image is not affected. The last time: " + shortage_;
}

template <typename Eye>
void EyeConnector::note_worst(std::span<const Eye> eyes, double share)
{
    const WorstPair pair = stage_.worst();
    if (pair.eye < eyes.size() && pair.value * share > worst_.radiance) worst_ = {eyes[pair.eye].pixel, pair.value * share};
}

template <typename Eye>
void EyeConnector::connect_all(std::span<const Eye> eyes, const VirtualLights& lights, const Visibility& visibility, ConnectCounts& counts, std::vector<Rgb>& image)
{
    for (std::size_t first = 0; first < eyes.size();) {
        const auto chunk = eyes.subspan(first, std::min(most_eyes_, eyes.size() - first));
        const auto here = padded(chunk);
        const auto sums = try_pairs(batch_of(here), {lights.records, lights.count}, visibility, counts, nullptr);
        if (!sums) continue;
        const double share = 1. / (settings_.samples * double(selection_.camera_samples));
        for (std::size_t i = 0; i < chunk.size(); ++i) add(*sums, i, share, image[chunk[i].pixel]);
        note_worst(chunk, share);
        first += chunk.size();
    }
}

template <typename Eye>
void EyeConnector::connect_chosen(std::span<const Eye> eyes, std::span<const std::size_t> ends, const VirtualLights& lights, const Visibility& visibility, std::uint64_t key, ConnectCounts& counts,
                                  std::vector<Rgb>& image)
{
    std::vector<EyePlace> places;
    for (std::uint32_t sample = 0; sample < ends.size(); ++sample)
        while (places.size() < ends[sample]) places.push_back({eyes[places.size()].pixel, eyes[places.size()].medium, eyes[places.size()].depth, sample});
    const auto random = [&](std::uint64_t salt) { return static_cast<std::uint32_t>(mix_bits(key + salt) >> 32); };
    const BlockGrid grid{.width = film_width_,
                         .size = selection_.block,
                         .offset_x = static_cast<int>(random(1) % static_cast<std::uint32_t>(selection_.block)),
                         .offset_y = static_cast<int>(random(2) % static_cast<std::uint32_t>(selection_.block)),
                         .key = random(3),
                         .samples = selection_.camera_samples};
    const EyeBlocks all = block_eyes(places, grid);
    RegionLights candidates(stage_, lights, selection_, settings_.vertex_limit, key);
    for (std::size_t r = 0; r < all.regions.size(); ++r) {
        const std::size_t first = all.regions[r], last = r + 1 < all.regions.size() ? all.regions[r + 1] : all.blocks.size();
        if (!candidates.wanted()) return connect_blocks(eyes, all, 0, all.blocks.size(), {lights.records, lights.count}, visibility, counts, image);
        connect_blocks(eyes, all, first, last, candidates.of(eyes, all, first, last), visibility, counts, image);
    }
}

template <typename Eye>
void EyeConnector::connect_blocks(std::span<const Eye> eyes, const EyeBlocks& all, std::size_t first_block, std::size_t last_block, const LightBatch& lights, const Visibility& visibility,
                                  ConnectCounts& counts, std::vector<Rgb>& image)
{
    for (std::size_t first = first_block; first < last_block;) {
        const std::size_t last = batch_end(all, first, last_block, most_eyes_, lights.count);
        const BlockBatch<Eye> batch(eyes, all, first, last);
        const LightSelection selection{.standing = std::as_bytes(std::span(batch.standing)), .standing_count = static_cast<std::uint32_t>(batch.standing.size()),
                                       .blocks = batch.blocks, .slots = selection_.slots_per_sample(), .defence = static_cast<float>(selection_.defence)};
        const auto sums = try_pairs(batch_of(batch.eyes), lights, visibility, counts, &selection);
        if (!sums) continue;
        const std::size_t start = all.blocks[first].first * std::size_t(eye_alignment);
        for (std::size_t i = 0; i < batch.eyes.size(); ++i)
            if (all.order[start + i] != no_eye) add(*sums, i, 1. / settings_.samples, image[batch.eyes[i].pixel]);
        note_worst(std::span<const Eye>(batch.eyes), 1. / settings_.samples);
        first = last;
    }
}

void EyeConnector::connect(const EyeRecords& eyes, EyeKind kind, const VirtualLights& lights, const Visibility& visibility, std::uint64_t key, ConnectCounts& counts,
                           std::vector<Rgb>& image)
{
    worst_ = {};
    const std::span<const EyeSegment> segments = eyes.segments;
    const std::span<const EyePoint> points = eyes.points;
    if (!selection_.chosen) return kind == EyeKind::segments ? connect_all(segments, lights, visibility, counts, image) : connect_all(points, lights, visibility, counts, image);
    if (kind == EyeKind::segments) connect_chosen(segments, eyes.segment_ends, lights, visibility, key, counts, image);
    else connect_chosen(points, eyes.point_ends, lights, visibility, key ^ 0x9e3779b97f4a7c15ull, counts, image);
}

}  // namespace tyndall
