/// Seconds until a device program can run, with PoCL's cache empty (cold) and filled (warm): compiling and the first launch, where PoCL
/// finishes the job.
#include <benchmark/benchmark.h>
#include <stdlib.h>

#include <filesystem>
#include <string>

#include "bench/measure.hpp"
#include "kernels/shared/host_features.hpp"
#include "throughput/workload.hpp"

namespace tyndall::bench {
namespace {

namespace fs = std::filesystem;

struct Wanted {
    const char* name;
    EyeKind eyes;
    std::uint32_t features;
};

const Wanted programs[] = {
    {"gather_segments", EyeKind::segments, feature_bit::anisotropic | feature_bit::coloured},
    {"gather_segments_boundaries", EyeKind::segments, feature_bit::anisotropic | feature_bit::coloured | feature_bit::boundaries},
    {"sample_segments", EyeKind::segments, feature_bit::anisotropic | feature_bit::coloured | feature_bit::occluders},
};

/// A fresh device each time: PoCL keeps programs in memory as long as their context lives.
double seconds_to_first_result(const Wanted& wanted, int lanes, const Workload& work)
{
    return seconds_of([&] {
        Device device;
        PairStage stage(device, {.eyes = wanted.eyes, .features = wanted.features, .lanes = lanes}, work.tables);
        stage.begin(work.eye_bytes(), static_cast<std::uint32_t>(work.eyes.size()), work.lights, 0xffffffffu);
        const PairTile tile{0, stage.groups(), 0, work.light_count};
        if (wanted.features & feature_bit::occluders) {
            stage.sample(0, tile), stage.sampled(0);
            stage.accumulate(0);
        } else {
            stage.gather(tile);
        }
        stage.sums();
    });
}

void build(benchmark::State& state, const Wanted& wanted, int lanes, const fs::path& cache)
{
    const Workload work = make_workload({.eyes = 16, .lights = 16});
    for (auto _ : state) {
        for (const auto& entry : fs::directory_iterator(cache)) fs::remove_all(entry);
        const double cold = seconds_to_first_result(wanted, lanes, work), warm = seconds_to_first_result(wanted, lanes, work);
        state.SetIterationTime(cold);
        state.counters["cold_seconds"] = cold;
        state.counters["warm_seconds"] = warm;
    }
}

/// An empty folder that PoCL is told to cache in; removed at the end.
class OwnCache {
public:
    OwnCache()
    {
        std::string name = (fs::temp_directory_path() / "tyndall-bench-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder could be made");
        path = name;
        setenv("POCL_CACHE_DIR", name.c_str(), 1);
    }
    ~OwnCache()
    {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    OwnCache(const OwnCache&) = delete;
    OwnCache& operator=(const OwnCache&) = delete;
    fs::path path;
};

}  // namespace
}  // namespace tyndall::bench

int main(int argc, char** argv)
{
    using namespace tyndall::bench;
    const OwnCache cache;
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    for (const Wanted& wanted : programs)
        for (const int lanes : {1, 16})
            benchmark::RegisterBenchmark((std::string("build/") + wanted.name + "/lanes:" + std::to_string(lanes)).c_str(), build, wanted,
                                         lanes, cache.path)
                ->UseManualTime()
                ->Iterations(1)
                ->Unit(benchmark::kMillisecond);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
