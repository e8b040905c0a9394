/// Pairs per second of the fused kernel at every lane width, beside the scalar baseline, in turns, on one core: by processor time, so that
/// what else runs on the machine disturbs little. No visibility.
#include <benchmark/benchmark.h>

#include <map>
#include <optional>
#include <string>

#include "bench/measure.hpp"
#include "device/scalar_pairs.hpp"
#include "throughput/measured_kernels.hpp"
#include "throughput/workload.hpp"

namespace tyndall::bench {
namespace {

Device& device()
{
    static Device opened;
    return opened;
}

struct Variant {
    const char* name;
    WorkloadWishes wishes;
};

const Variant variants[] = {
    {"isotropic_grey", {.g = 0}}, {"henyey_greenstein_grey", {}}, {"henyey_greenstein_coloured", {.coloured = true}}};

/// A workload on the device with the baseline that belongs to it.
struct Prepared {
    Workload work;
    ScalarPairs scalar;
    std::vector<double> scalar_sums;

    explicit Prepared(const WorkloadWishes& wishes)
        : work(make_workload(wishes)), scalar(device(), {work.eyes, work.lights, work.light_count, work.tables.media, features_of(wishes)})
    {
        run_scalar();
        const std::vector<float> sums = scalar.sums();
        scalar_sums.assign(sums.begin(), sums.end());
    }
    void run_scalar() { scalar.run(static_cast<std::uint32_t>(work.eyes.size())); }
};

Prepared& prepared(const Variant& variant)
{
    static std::map<std::string, Prepared> all;
    return all.try_emplace(variant.name, variant.wishes).first->second;
}

std::vector<double> gathered(PairStage& stage, const Workload& work)
{
    stage.gather({0, stage.groups(), 0, work.light_count});
    return stage.sums();
}

void begin(PairStage& stage, const Workload& work, EyeKind kind = EyeKind::segments)
{
    stage.begin(work.eye_bytes(kind), static_cast<std::uint32_t>(work.eyes.size()), work.lights, 0xffffffffu);
}

void pairs_per_second(benchmark::State& state, const Variant& variant, int lanes)
{
    Prepared& p = prepared(variant);
    PairStage stage(device(), {.features = features_of(variant.wishes), .lanes = lanes}, p.work.tables);
    begin(stage, p.work);
    const double agreeing = agreeing_sums(gathered(stage, p.work), p.scalar_sums);
    if (!(agreeing >= .99))
        return state.SkipWithError("the fused kernel and the baseline do not compute the same");
    const double pairs = static_cast<double>(p.work.pairs());
    for (auto _ : state) {
        std::vector<double> scalar, fused;
        for (int round = 0; round < 3; ++round) {
            scalar.push_back(processor_seconds_of([&] { p.run_scalar(); }));
            for (int i = 0; i < 5; ++i) fused.push_back(processor_seconds_of([&] { gathered(stage, p.work); }));
        }
        const double ours = median(fused), theirs = median(scalar);
        state.SetIterationTime(ours);
        state.counters["pairs_per_second"] = pairs / ours;
        state.counters["scalar_pairs_per_second"] = pairs / theirs;
        state.counters["speedup_over_scalar"] = theirs / ours;
    }
    state.counters["agreeing_sums"] = agreeing;
}

struct Alone {
    std::string name;
    EyeKind eyes = EyeKind::segments;
    int sampler = SAMPLER_PAPER_ISOTROPIC;
    double g = .55;
    int sequence = SEQUENCE_RANDOM;
    WorkloadWishes wishes{};
    int transmittance = TRANSMITTANCE_MARCH;
};

constexpr std::uint32_t few_eyes = 512;  ///< of programs that take long

/// Eye rays of a camera and lights, cut at the box that a grid of so many voxels fills.
WorkloadWishes box(std::uint32_t voxels) { return {.eyes = few_eyes, .camera = true, .grid = voxels, .in_box = true}; }

/// Programs that the baseline has no counterpart of. Those with a grid are measured in turns with the same without it.
std::vector<Alone> without_baseline()
{
    std::vector<Alone> all{{.name = "product_sampler", .sampler = SAMPLER_PAPER},
                           {.name = "paper_6", .sampler = SAMPLER_PAPER_6, .wishes = {.eyes = few_eyes}},
                           {.name = "table", .sampler = SAMPLER_TABLE, .wishes = {.eyes = few_eyes}},
                           {.name = "table_4x4", .sampler = SAMPLER_TABLE_4X4, .wishes = {.eyes = few_eyes}},
                           {.name = "table_3x2", .sampler = SAMPLER_TABLE_3X2, .wishes = {.eyes = few_eyes}},
                           {.name = "table_3x2_isotropic", .sampler = SAMPLER_TABLE_3X2, .g = 0, .wishes = {.eyes = few_eyes}},
                           {.name = "paper_6_isotropic", .sampler = SAMPLER_PAPER_6, .g = 0, .wishes = {.eyes = few_eyes}},
                           {.name = "isotropic_sampler_sobol", .sequence = SEQUENCE_SOBOL},
                           {.name = "surface_points", .eyes = EyeKind::points}};
    for (const std::uint32_t voxels : {32u, 64u}) {
        const std::string name = "grid_" + std::to_string(voxels);
        all.push_back({.name = name + "_march", .g = 0, .wishes = box(voxels)});
        all.push_back({.name = name + "_march_points", .eyes = EyeKind::points, .g = 0, .wishes = box(voxels)});
    }
    all.push_back({.name = "grid_64_exact", .g = 0, .wishes = box(64), .transmittance = TRANSMITTANCE_EXACT});
    const std::pair<const char*, int> samplers[] = {{"paper-isotropic", SAMPLER_PAPER_ISOTROPIC}, {"paper", SAMPLER_PAPER}, {"paper-6", SAMPLER_PAPER_6},
                                                    {"table", SAMPLER_TABLE}, {"table-4x4", SAMPLER_TABLE_4X4}, {"table-3x2", SAMPLER_TABLE_3X2}};
    for (const auto& [name, sampler] : samplers) all.push_back({.name = std::string("grid_64_sampler_") + name, .sampler = sampler, .wishes = box(64)});
    return all;
}

/// Its pairs on the device, ready to be gathered.
struct Ready {
    Workload work;
    PairStage stage;

    Ready(const Alone& what, const WorkloadWishes& wishes, int lanes)
        : work(make_workload(wishes)), stage(device(), {.eyes = what.eyes, .features = features_of(wishes), .lanes = lanes, .sampler = what.sampler,
                                                        .sequence = what.sequence, .transmittance = what.transmittance}, work.tables)
    {
        begin(stage, work, what.eyes);
        gathered(stage, work);
    }
    double seconds() { return processor_seconds_of([&] { gathered(stage, work); }); }
};

void pairs_alone(benchmark::State& state, const Alone& what, int lanes)
{
    WorkloadWishes wishes = what.wishes;
    wishes.g = what.g;
    Ready ours(what, wishes, lanes);
    std::optional<Ready> even;
    wishes.grid = 0;
    if (what.wishes.grid != 0) even.emplace(what, wishes, lanes);
    const double pairs = static_cast<double>(ours.work.pairs());
    for (auto _ : state) {
        std::vector<double> seconds, even_seconds;
        for (int i = 0; i < 5; ++i) {
            seconds.push_back(ours.seconds());
            if (even) even_seconds.push_back(even->seconds());
        }
        state.SetIterationTime(median(seconds));
        state.counters["pairs_per_second"] = pairs / median(seconds);
        if (!even) continue;
        state.counters["homogeneous_pairs_per_second"] = pairs / median(even_seconds);
        state.counters["ratio_to_homogeneous"] = median(seconds) / median(even_seconds);
    }
}

/// One benchmark per lane width.
template <typename Function, typename What>
void at_every_width(Function function, const What& what)
{
    for (const int lanes : {1, 4, 8, 16})
        benchmark::RegisterBenchmark((std::string("pairs/") + what.name + "/lanes:" + std::to_string(lanes)).c_str(), function, what, lanes)
            ->UseManualTime()
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace tyndall::bench

int main(int argc, char** argv)
{
    using namespace tyndall::bench;
    use_workers(1);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::AddCustomContext("device", device().info().platform + ": " + device().info().name + ", driver " + device().info().driver);
    for (const Variant& variant : variants) at_every_width(&pairs_per_second, variant);
    for (const Alone& alone : without_baseline()) at_every_width(&pairs_alone, alone);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
