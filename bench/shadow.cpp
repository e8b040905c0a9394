/// Shadow segments per second: through Visibility and through the whole sampled pipeline, beside Embree with nothing around it, in turns.
/// --cores=1 or 2.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cstring>
#include <map>
#include <memory>
#include <string>

#include "bench/bare_embree.hpp"
#include "bench/measure.hpp"
#include "bench/shadow_scene.hpp"
#include "kernels/shared/host_features.hpp"
#include "throughput/workload.hpp"
#include "tiling/connect_pairs.hpp"

namespace tyndall::bench {
namespace {

int cores = 1;
constexpr std::size_t tile_packets = 2048;  ///< as many as the pipeline's tiles have

struct AlignedPacket {
    alignas(64) ShadowPacket packet;
};

/// A scene, who answers for it, and what is asked.
struct Room {
    Scene scene;
    Visibility visibility;
    BareEmbree robust, fast;
    Workload work;
    Device device;
    PairStage stage;
    std::vector<AlignedPacket> packets;  ///< of the first tiles

    explicit Room(Solids solids)
        : scene(shadow_scene(solids)),
          visibility(scene, cores),
          robust(scene, true),
          fast(scene, false),
          work(make_workload({.g = 0, .scale = shadow_scale, .camera = true})),
          stage(device, {.features = feature_bit::occluders}, work.tables)
    {
        stage.begin(work.eye_bytes(), eye_count(), work.lights, 0xffffffffu);
        for (std::uint32_t group = 0; group < stage.groups(); group += 8) {
            stage.sample(0, {group, 8, 0, light_block});
            for (const ShadowPacket& packet : stage.sampled(0).packets) packets.push_back({packet});
            stage.accumulate(0);
        }
    }
    std::uint32_t eye_count() const { return static_cast<std::uint32_t>(work.eyes.size()); }
};

Room& room(Solids solids)
{
    static std::map<Solids, std::unique_ptr<Room>> rooms;
    auto& found = rooms[solids];
    if (!found) found = std::make_unique<Room>(solids);
    return *found;
}

/// With one core processor time, which others on the machine disturb little; with more the clock on the wall.
template <typename Work>
double measured(Work&& work)
{
    return cores == 1 ? processor_seconds_of(work) : seconds_of(work);
}

struct Traced {
    double seconds = 0;
    std::uint64_t blocked = 0;
};

/// Every tile's packets, fresh from the device's point of view, answered by `answer`; only that is timed.
template <typename Answer>
Traced trace(const Room& room, Answer&& answer)
{
    static std::vector<AlignedPacket> tile(tile_packets);
    const std::span packets(&tile[0].packet, tile_packets);
    Traced traced;
    for (std::size_t first = 0; first < room.packets.size(); first += tile_packets) {
        std::memcpy(&tile[0].packet, &room.packets[first].packet, tile_packets * sizeof(ShadowPacket));
        traced.seconds += measured([&] { answer(packets); });
        for (const ShadowPacket& p : packets)
            traced.blocked +=
                static_cast<std::uint64_t>(std::count_if(p.tfar, p.tfar + SHADOW_PACKET_SIZE, [](float t) { return t < -1; }));
    }
    return traced;
}

Traced trace_bare(const Room& room, const BareEmbree& embree)
{
    return trace(room, [&](auto packets) { cores == 1 ? embree.occluded(packets) : embree.occluded_in_parallel(packets); });
}

void packets_answered(benchmark::State& state, Solids solids)
{
    Room& r = room(solids);
    const double segments = static_cast<double>(r.packets.size()) * SHADOW_PACKET_SIZE;
    for (auto _ : state) {
        std::vector<double> ours, robust, fast;
        std::uint64_t blocked = 0, blocked_bare = 0;
        for (int i = 0; i < 9; ++i) {
            const Traced mine = trace(r, [&](auto packets) { r.visibility.occluded(packets); }), bare = trace_bare(r, r.robust);
            ours.push_back(mine.seconds), robust.push_back(bare.seconds), fast.push_back(trace_bare(r, r.fast).seconds);
            blocked = mine.blocked, blocked_bare = bare.blocked;
        }
        if (blocked != blocked_bare) state.SkipWithError("Visibility and Embree do not give the same answers");
        state.SetIterationTime(median(ours));
        state.counters["segments_per_second"] = segments / median(ours);
        state.counters["embree_robust_per_second"] = segments / median(robust);
        state.counters["embree_fast_per_second"] = segments / median(fast);
        state.counters["ratio_to_robust"] = median(robust) / median(ours);
        state.counters["ratio_to_fast"] = median(fast) / median(ours);
        state.counters["blocked_share"] = static_cast<double>(blocked) / segments;
    }
}

void pipeline(benchmark::State& state, Solids solids)
{
    Room& r = room(solids);
    const ConnectSettings native{.features = feature_bit::occluders, .lanes = 16};
    ConnectSettings in_turns = native;
    in_turns.native_kernels = false;
    ConnectCounts counts;
    const auto connect = [&](const ConnectSettings& settings) {
        return measured([&] { connect_pairs(r.stage, r.visibility, {r.work.eye_bytes(), r.eye_count(), {}}, {r.work.lights, r.work.light_count}, settings, counts); });
    };
    const double segments = static_cast<double>(r.packets.size()) * SHADOW_PACKET_SIZE, pairs = static_cast<double>(r.work.pairs());
    for (auto _ : state) {
        std::vector<double> ours, by_host, bare;
        for (int i = 0; i < 5; ++i) {
            ours.push_back(connect(native)), by_host.push_back(connect(in_turns));
            bare.push_back(trace_bare(r, r.robust).seconds);
        }
        state.SetIterationTime(median(ours));
        state.counters["pairs_per_second"] = pairs / median(ours);
        state.counters["host_thread_pairs_per_second"] = pairs / median(by_host);
        state.counters["ratio_to_host_thread"] = median(by_host) / median(ours);
        state.counters["embree_robust_per_second"] = segments / median(bare);
        state.counters["ratio_to_robust"] = pairs / median(ours) / (segments / median(bare));
    }
}

/// Takes --cores=N out of the arguments.
int take_cores(int& argc, char** argv)
{
    int chosen = 1, kept = 0;
    for (int i = 0; i < argc; ++i)
        if (std::strncmp(argv[i], "--cores=", 8) == 0)
            chosen = std::max(std::atoi(argv[i] + 8), 1);
        else
            argv[kept++] = argv[i];
    argc = kept;
    return chosen;
}

}  // namespace
}  // namespace tyndall::bench

int main(int argc, char** argv)
{
    using namespace tyndall::bench;
    cores = take_cores(argc, argv);
    stay_on_cores(cores);
    use_workers(cores);
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(cores));
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    for (const Solids solids : {Solids::room_of_tetrahedra, Solids::one_ball, Solids::room_of_balls}) {
        const std::string where = "/triangles:" + std::to_string(triangle_count(shadow_scene(solids))) + "/cores:" + std::to_string(cores);
        for (const auto& [name, function] : {std::pair("packets", &packets_answered), std::pair("pipeline", &pipeline)})
            benchmark::RegisterBenchmark((name + where).c_str(), function, solids)
                ->UseManualTime()
                ->Iterations(1)
                ->Unit(benchmark::kMillisecond);
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
