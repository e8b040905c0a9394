#include "pipeline/gather_connector.hpp"

#include <algorithm>

#include "parallel/parallel_for.hpp"
#include "pipeline/memory_estimate.hpp"

namespace tyndall {
namespace {

void find_near(const NearSearch& search, const EyeSegment& eye, std::vector<std::uint32_t>& found)
{
    search.find({eye.origin_x, eye.origin_y, eye.origin_z}, {eye.direction_x, eye.direction_y, eye.direction_z}, eye.length, found);
}
void find_near(const NearSearch& search, const EyePoint& eye, std::vector<std::uint32_t>& found)
{
    search.find({eye.position_x, eye.position_y, eye.position_z}, Vec3(0), 0, found);
}

template <typename Eye>
std::vector<Eye> padded(std::span<const Eye> eyes)
{
    std::vector<Eye> all(eyes.begin(), eyes.end());
    while (all.size() % eye_alignment != 0) {
        all.push_back(all.back());
        all.back().throughput_r = all.back().throughput_g = all.back().throughput_b = 0;
    }
    return all;
}

}  // namespace

/// For every 16 eyes the numbers of the lights that come near one of them, ascending, each once.
template <typename Eye>
std::vector<std::vector<std::uint32_t>> GatherConnector::near(std::span<const Eye> eyes, const Visibility& visibility) const
{
    std::vector<std::vector<std::uint32_t>> lists((eyes.size() + eye_alignment - 1) / eye_alignment);
    visibility.in_arena([&] {
        parallel_for(std::size_t(0), lists.size(), [&](std::size_t g) {
            std::vector<std::uint32_t>& list = lists[g];
            for (std::size_t i = g * eye_alignment; i < std::min<std::size_t>((g + 1) * eye_alignment, eyes.size()); ++i) find_near(search_, eyes[i], list);
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
        });
    });
    return lists;
}

template <typename Eye>
void GatherConnector::gather(std::span<const Eye> eyes, const VirtualLights& lights, const Visibility& visibility, ConnectCounts& counts, std::vector<Rgb>& image)
{
    const auto chunk_of = [&](Piece piece) {
        const std::size_t first = piece.first * eye_alignment, last = std::min<std::size_t>(piece.last * eye_alignment, eyes.size());
        return eyes.subspan(first, last - first);
    };
    SharedJob job{.units = (eyes.size() + eye_alignment - 1) / eye_alignment, .eyes = [](Piece piece) { return (piece.last - piece.first) * eye_alignment; }};
    const std::size_t most = settings_.tile_pairs ? settings_.tile_pairs : near_numbers_at_a_time;
    job.fits = [&](Piece piece) { return (piece.last - piece.first) * lights.count <= most; };
    job.sums = [&](PairStage& stage, const ConnectSettings& settings, Piece piece, ConnectCounts& here) {
        throw_if_raised(settings.stop);
        const auto lists = near(chunk_of(piece), visibility);
        std::vector<std::uint32_t> starts{0}, numbers;
        for (const auto& list : lists) {
            numbers.insert(numbers.end(), list.begin(), list.end());
            starts.push_back(static_cast<std::uint32_t>(numbers.size()));
        }
        const std::vector<Eye> records = padded(chunk_of(piece));
        stage.begin(std::as_bytes(std::span(records)), static_cast<std::uint32_t>(records.size()), lights.records, settings.vertex_limit);
        stage.gather_near(starts, numbers);
        here.pairs += std::uint64_t(numbers.size()) * eye_alignment;
        return stage.sums();
    };
    job.add = [&](Piece piece, const std::vector<double>& sums) {
        const auto chunk = chunk_of(piece);
        for (std::size_t i = 0; i < chunk.size(); ++i) image[chunk[i].pixel] += Rgb(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]) * share_;
    };
    crew_.share(job, counts);
}

void GatherConnector::gather(const EyeRecords& eyes, const VirtualLights& lights, const Visibility& visibility, ConnectCounts& counts, std::vector<Rgb>& image)
{
    if (lights.count == 0) return;
    std::vector<Capsule> capsules;
    for (std::size_t i = 0; i < lights.count; ++i) capsules.push_back(technique_.capsule(std::span(lights.records).subspan(i * technique_.record_bytes, technique_.record_bytes)));
    visibility.in_arena([&] { search_.set(capsules); });
    if (technique_.reach == Reach::near_segments) gather(std::span<const EyeSegment>(eyes.segments), lights, visibility, counts, image);
    else gather(std::span<const EyePoint>(eyes.points), lights, visibility, counts, image);
}

}  // namespace tyndall
