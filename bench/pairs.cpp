/// Pairs per second of the fused kernel at every lane width, beside the scalar baseline, in turns, on one core: by processor time, so that
/// what else runs on the machine disturbs little. No visibility.
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <string>

#include "bench/measure.hpp"
#include "bench/naive_pairs.hpp"
#include "bench/workload.hpp"

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
    NaivePairs naive;
    std::vector<float> naive_sums;

    explicit Prepared(const WorkloadWishes& wishes)
        : work(make_workload(wishes)), naive(device(), work, features_of(wishes)), naive_sums(naive.sums())
    {
    }
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

struct Agreement {
    double means = 0;  ///< ours / theirs
    double eyes = 0;   ///< share of eyes whose sums agree within 1 %
};

/// Both draw the same numbers, so well-conditioned sums agree to rounding.
Agreement agreement(const std::vector<double>& ours, const std::vector<float>& theirs)
{
    double sum = 0, their_sum = 0, close = 0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        sum += ours[i], their_sum += theirs[i];
        close += std::abs(ours[i] - theirs[i]) <= .01 * ours[i];
    }
    return {sum / their_sum, close / static_cast<double>(ours.size())};
}

void pairs_per_second(benchmark::State& state, const Variant& variant, int lanes)
{
    Prepared& p = prepared(variant);
    PairStage stage(device(), {.features = features_of(variant.wishes), .lanes = lanes}, p.work.tables);
    begin(stage, p.work);
    const Agreement agree = agreement(gathered(stage, p.work), p.naive_sums);
    if (!(std::abs(agree.means - 1) < .01) || agree.eyes < .99)
        return state.SkipWithError("the fused kernel and the baseline do not compute the same");
    const double pairs = static_cast<double>(p.work.pairs());
    for (auto _ : state) {
        std::vector<double> scalar, fused;
        for (int round = 0; round < 3; ++round) {
            scalar.push_back(processor_seconds_of([&] { p.naive.sums(); }));
            for (int i = 0; i < 5; ++i) fused.push_back(processor_seconds_of([&] { gathered(stage, p.work); }));
        }
        const double ours = median(fused), theirs = median(scalar);
        state.SetIterationTime(ours);
        state.counters["pairs_per_second"] = pairs / ours;
        state.counters["scalar_pairs_per_second"] = pairs / theirs;
        state.counters["speedup_over_scalar"] = theirs / ours;
    }
    state.counters["agreeing_sums"] = agree.eyes;
}

struct Alone {
    const char* name;
    EyeKind eyes;
    int sampler;
    double g = .55;
    int sequence = SEQUENCE_RANDOM;
    WorkloadWishes wishes{};
    int transmittance = TRANSMITTANCE_MARCH;
};

constexpr WorkloadWishes box{.g = 0, .camera = true, .in_box = true}, box_grid{.g = 0, .camera = true, .grid = 64, .in_box = true};

/// Programs that the baseline has no counterpart of: Henyey-Greenstein, grey.
const Alone without_baseline[] = {{"product_sampler", EyeKind::segments, SAMPLER_PAPER},
                                  {"paper_6", EyeKind::segments, SAMPLER_PAPER_6},
                                  {"table", EyeKind::segments, SAMPLER_TABLE},
                                  {"table_4x4", EyeKind::segments, SAMPLER_TABLE_4X4},
                                  {"table_3x2", EyeKind::segments, SAMPLER_TABLE_3X2},
                                  {"table_3x2_isotropic", EyeKind::segments, SAMPLER_TABLE_3X2, 0},
                                  {"paper_6_isotropic", EyeKind::segments, SAMPLER_PAPER_6, 0},
                                  {"isotropic_sampler_sobol", EyeKind::segments, SAMPLER_PAPER_ISOTROPIC, .55, SEQUENCE_SOBOL},
                                  {"surface_points", EyeKind::points, SAMPLER_PAPER_ISOTROPIC},
                                  {"box_homogeneous", EyeKind::segments, SAMPLER_PAPER_ISOTROPIC, 0, SEQUENCE_RANDOM, box},
                                  {"box_grid_march", EyeKind::segments, SAMPLER_PAPER_ISOTROPIC, 0, SEQUENCE_RANDOM, box_grid},
                                  {"box_grid_exact", EyeKind::segments, SAMPLER_PAPER_ISOTROPIC, 0, SEQUENCE_RANDOM, box_grid, TRANSMITTANCE_EXACT},
                                  {"box_homogeneous_points", EyeKind::points, SAMPLER_PAPER_ISOTROPIC, 0, SEQUENCE_RANDOM, box},
                                  {"box_grid_march_points", EyeKind::points, SAMPLER_PAPER_ISOTROPIC, 0, SEQUENCE_RANDOM, box_grid}};

void pairs_alone(benchmark::State& state, const Alone& what, int lanes)
{
    WorkloadWishes wishes = what.wishes;
    wishes.g = what.g;
    const Workload work = make_workload(wishes);
    PairStage stage(device(), {.eyes = what.eyes, .features = features_of(wishes), .lanes = lanes, .sampler = what.sampler, .sequence = what.sequence,
                               .transmittance = what.transmittance}, work.tables);
    begin(stage, work, what.eyes);
    gathered(stage, work);
    for (auto _ : state) {
        std::vector<double> seconds;
        for (int i = 0; i < 9; ++i) seconds.push_back(processor_seconds_of([&] { gathered(stage, work); }));
        state.SetIterationTime(median(seconds));
        state.counters["pairs_per_second"] = static_cast<double>(work.pairs()) / median(seconds);
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
    for (const Alone& alone : without_baseline) at_every_width(&pairs_alone, alone);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
