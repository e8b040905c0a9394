#include "pipeline/device_crew.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <thread>

#include "pipeline/memory_estimate.hpp"
#include "tyndall/error.hpp"

namespace tyndall {

/// What the threads of one job share.
struct DeviceCrew::Shared {
    std::mutex guard;                        ///< of everything here
    std::vector<Piece> pieces;
    std::vector<std::size_t> open;           ///< numbers of pieces that nobody does, the next last
    std::vector<std::vector<double>> sums;   ///< of the pieces that are done
    ConnectCounts counts;
    std::exception_ptr stopped, failed;      ///< something that is no device's failure; the last failure of a device
};

DeviceCrew::DeviceCrew(std::vector<PairStage> stages, const ConnectSettings& settings)
{
    for (PairStage& stage : stages) workers_.push_back({.stage = std::move(stage), .settings = settings, .most_eyes = eyes_at_a_time(settings.features)});
}

std::size_t DeviceCrew::able() const
{
    return static_cast<std::size_t>(std::count_if(workers_.begin(), workers_.end(), [](const Worker& w) { return !w.failed(); }));
}

PairStage& DeviceCrew::first()
{
    const auto found = std::find_if(workers_.begin(), workers_.end(), [](const Worker& w) { return !w.failed(); });
    return (found == workers_.end() ? workers_.front() : *found).stage;
}

std::vector<const PairStage*> DeviceCrew::stages() const
{
    std::vector<const PairStage*> all;
    for (const Worker& w : workers_) all.push_back(&w.stage);
    return all;
}

std::vector<std::string> DeviceCrew::warnings() const
{
    std::vector<std::string> all;
    for (const Worker& w : workers_) {
        if (w.shortages > 0)
            all.push_back("the device ran short " + std::to_string(w.shortages) + " times, and did the same with less at a time, in the end " + std::to_string(w.most_eyes) + " eyes and tiles of " +
                          std::to_string(w.settings.tile_pairs) + " pairs; the image is not affected. The last time: " + w.shortage);
        if (w.failed()) all.push_back("a device failed and the others did its work; the image is not affected: " + w.failure);
    }
    return all;
}

/// One device takes as much as it has room for; several take a quarter of their share, so that they end together.
std::vector<Piece> DeviceCrew::cut(const SharedJob& job) const
{
    std::size_t most = workers_.front().most_eyes;
    for (const Worker& w : workers_) most = std::max(most, w.most_eyes);
    if (able() > 1) most = std::min(most, std::max<std::size_t>(job.eyes({0, job.units}) / (4 * able()), eye_alignment));
    std::vector<Piece> pieces;
    for (std::size_t first = 0; first < job.units; first = pieces.back().last) {
        Piece piece{first, first + 1};
        while (piece.last < job.units && job.fits({first, piece.last + 1}) && job.eyes({first, piece.last + 1}) <= most) ++piece.last;
        pieces.push_back(piece);
    }
    return pieces;
}

/// Remembers a shortage; false if there is nothing left to halve.
bool DeviceCrew::take_less(Worker& worker, std::size_t eyes, const std::string& why)
{
    const std::uint32_t pairs = worker.settings.tile_pairs ? worker.settings.tile_pairs : shadowed_pairs;
    if (worker.most_eyes <= eye_alignment && pairs <= eye_alignment * light_block) return false;
    worker.most_eyes = std::max<std::size_t>(std::min(worker.most_eyes, eyes) / 2 / eye_alignment, 1) * eye_alignment;
    worker.settings.tile_pairs = std::max(pairs / 2, eye_alignment * light_block);
    ++worker.shortages, worker.shortage = why;
    worker.stage.recover();
    return true;
}

std::vector<double> DeviceCrew::sums_of(Worker& worker, const SharedJob& job, Piece piece, ConnectCounts& counts)
{
    const std::size_t eyes = job.eyes(piece);
    if (eyes > worker.most_eyes && piece.last - piece.first > 1) {
        const std::size_t middle = piece.first + (piece.last - piece.first) / 2;
        std::vector<double> sums = sums_of(worker, job, {piece.first, middle}, counts);
        const std::vector<double> rest = sums_of(worker, job, {middle, piece.last}, counts);
        sums.insert(sums.end(), rest.begin(), rest.end());
        return sums;
    }
    try {
        ConnectCounts here;
        std::vector<double> sums = job.sums(worker.stage, worker.settings, piece, here);
        counts.pairs += here.pairs, counts.shadow_segments += here.shadow_segments, counts.visibility_seconds += here.visibility_seconds;
        return sums;
    } catch (const ResourceError& error) {
        if (!take_less(worker, eyes, error.what())) throw;
    }
    return sums_of(worker, job, piece, counts);
}

/// Takes pieces until none is open, or the device fails.
void DeviceCrew::work(Worker& worker, const SharedJob& job, Shared& shared)
{
    for (;;) {
        std::size_t number;
        {
            const std::lock_guard lock(shared.guard);
            if (shared.open.empty() || shared.stopped) return;
            number = shared.open.back(), shared.open.pop_back();
        }
        ConnectCounts counts;
        try {
            std::vector<double> sums = sums_of(worker, job, shared.pieces[number], counts);
            const std::lock_guard lock(shared.guard);
            shared.sums[number] = std::move(sums);
            shared.counts.pairs += counts.pairs, shared.counts.shadow_segments += counts.shadow_segments, shared.counts.visibility_seconds += counts.visibility_seconds;
        } catch (const DeviceError& error) {
            const std::lock_guard lock(shared.guard);
            worker.failure = error.what(), shared.failed = std::current_exception();
            shared.open.push_back(number);
            return;
        } catch (...) {
            const std::lock_guard lock(shared.guard);
            shared.stopped = std::current_exception();
            return;
        }
    }
}

void DeviceCrew::share(const SharedJob& job, ConnectCounts& counts)
{
    if (job.units == 0) return;
    Shared shared;
    shared.pieces = cut(job), shared.sums.resize(shared.pieces.size());
    for (std::size_t i = shared.pieces.size(); i > 0; --i) shared.open.push_back(i - 1);
    while (!shared.open.empty() && !shared.stopped) {
        if (able() == 0) shared.failed ? std::rethrow_exception(shared.failed) : throw DeviceError(workers_.front().failure);
        std::vector<std::thread> others;
        Worker* own = nullptr;
        for (Worker& w : workers_) {
            if (w.failed()) continue;
            if (own) others.emplace_back([this, &w, &job, &shared] { work(w, job, shared); });
            else own = &w;
        }
        work(*own, job, shared);
        for (std::thread& t : others) t.join();
    }
    if (shared.stopped) std::rethrow_exception(shared.stopped);
    for (std::size_t i = 0; i < shared.pieces.size(); ++i) job.add(shared.pieces[i], shared.sums[i]);
    counts.pairs += shared.counts.pairs, counts.shadow_segments += shared.counts.shadow_segments, counts.visibility_seconds += shared.counts.visibility_seconds;
}

}  // namespace tyndall
