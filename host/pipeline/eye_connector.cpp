#include "pipeline/eye_connector.hpp"

#include <algorithm>

#include "pipeline/memory_estimate.hpp"
#include "tiling/eye_blocks.hpp"
#include "transport/random_sequence.hpp"

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

}  // namespace

void EyeConnector::add(const std::vector<double>& sums, std::size_t eye, double share, Rgb& pixel)
{
    const std::size_t kinds = settings_.sums_of_eye, first = 3 * kinds * eye;
    const Rgb kept = Rgb(sums[first], sums[first + 1], sums[first + 2]) * share;
    pixel += kept;
    if (kinds < 2) return;
    const Rgb removed = Rgb(sums[first + 3], sums[first + 4], sums[first + 5]) * share;
    kept_ += kept.r + kept.g + kept.b, removed_ += removed.r + removed.g + removed.b;
}

template <typename Eye>
void EyeConnector::note_worst(const PairStage& stage, std::span<const Eye> eyes, double share)
{
    const WorstPair pair = stage.worst();
    if (pair.eye >= eyes.size()) return;
    const Worst here{eyes[pair.eye].pixel, pair.value * share};
    const std::lock_guard lock(worst_guard_);  // devices end in any order
    if (here.radiance > worst_.radiance || (here.radiance == worst_.radiance && here.pixel < worst_.pixel)) worst_ = here;
}

template <typename Eye>
void EyeConnector::connect_all(std::span<const Eye> eyes, const VirtualLights& lights, const Visibility& visibility, ConnectCounts& counts, std::vector<Rgb>& image)
{
    const auto chunk_of = [&](Piece piece) {
        const std::size_t first = piece.first * eye_alignment, last = std::min<std::size_t>(piece.last * eye_alignment, eyes.size());
        return eyes.subspan(first, last - first);
    };
    const double share = 1. / (settings_.samples * double(selection_.camera_samples));
    SharedJob job{.units = (eyes.size() + eye_alignment - 1) / eye_alignment, .eyes = [](Piece piece) { return (piece.last - piece.first) * eye_alignment; }};
    job.sums = [&](PairStage& stage, const ConnectSettings& settings, Piece piece, ConnectCounts& here) {
        const auto chunk = chunk_of(piece);
        const auto records = padded(chunk);
        std::vector<double> sums = connect_pairs(stage, visibility, batch_of(records), {lights.records, lights.count}, settings, here);
        note_worst(stage, chunk, share);
        return sums;
    };
    job.add = [&](Piece piece, const std::vector<double>& sums) {
        const auto chunk = chunk_of(piece);
        for (std::size_t i = 0; i < chunk.size(); ++i) add(sums, i, share, image[chunk[i].pixel]);
    };
    crew_.share(job, counts);
}

static EyePlace place_of(const EyeSegment& eye, std::uint32_t sample) { return {eye.pixel, eye.medium, eye.depth, sample, eye.length}; }
static EyePlace place_of(const EyePoint& eye, std::uint32_t sample) { return {eye.pixel, eye.medium, eye.depth, sample}; }

template <typename Eye>
void EyeConnector::connect_chosen(std::span<const Eye> eyes, std::span<const std::size_t> ends, const VirtualLights& lights, const Visibility& visibility, std::uint64_t key, ConnectCounts& counts,
                                  std::vector<Rgb>& image)
{
    std::vector<EyePlace> places;
    for (std::uint32_t sample = 0; sample < ends.size(); ++sample)
        while (places.size() < ends[sample]) places.push_back(place_of(eyes[places.size()], sample));
    const auto random = [&](std::uint64_t salt) { return static_cast<std::uint32_t>(mix_bits(key + salt) >> 32); };
    const BlockGrid grid{.width = film_width_,
                         .size = selection_.block,
                         .offset_x = static_cast<int>(random(1) % static_cast<std::uint32_t>(selection_.block)),
                         .offset_y = static_cast<int>(random(2) % static_cast<std::uint32_t>(selection_.block)),
                         .key = random(3),
                         .samples = selection_.camera_samples};
    const EyeBlocks all = block_eyes(places, grid);
    RegionLights candidates(crew_.first(), lights, selection_, settings_.vertex_limit, key);
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
    const auto blocks_of = [&](Piece piece) { return std::pair(first_block + piece.first, first_block + piece.last); };
    const auto places_of = [&](Piece piece) {
        const EyeBlock &start = all.blocks[first_block + piece.first], &end = all.blocks[first_block + piece.last - 1];
        return std::pair(start.first * std::size_t(eye_alignment), (end.first + end.groups) * std::size_t(eye_alignment));
    };
    const std::size_t most_standing = std::max<std::size_t>(estimates_at_a_time / std::max<std::size_t>(lights.count, 1), 1);
    SharedJob job{.units = last_block - first_block, .eyes = [&](Piece piece) { return places_of(piece).second - places_of(piece).first; }};
    job.fits = [&](Piece piece) {
        const auto [first, last] = blocks_of(piece);
        return all.blocks[last - 1].standing - all.blocks[first].standing < most_standing;
    };
    job.sums = [&](PairStage& stage, const ConnectSettings& settings, Piece piece, ConnectCounts& here) {
        const auto [first, last] = blocks_of(piece);
        const BlockBatch<Eye> batch(eyes, all, first, last);
        const LightSelection selection{.standing = std::as_bytes(std::span(batch.standing)), .standing_count = static_cast<std::uint32_t>(batch.standing.size()),
                                       .blocks = batch.blocks, .slots = selection_.slots_per_sample(), .defence = static_cast<float>(selection_.defence)};
        std::vector<double> sums = connect_pairs(stage, visibility, batch_of(batch.eyes), lights, settings, here, &selection);
        note_worst(stage, std::span<const Eye>(batch.eyes), 1. / settings_.samples);
        return sums;
    };
    job.add = [&](Piece piece, const std::vector<double>& sums) {
        const auto [start, end] = places_of(piece);
        for (std::size_t i = start; i < end; ++i)
            if (all.order[i] != no_eye) add(sums, i - start, 1. / settings_.samples, image[eyes[all.order[i]].pixel]);
    };
    crew_.share(job, counts);
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
