#include "throughput/throughput.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <thread>
#include <utility>

#include "device/device.hpp"
#include "throughput/clocks.hpp"
#include "throughput/measured_kernels.hpp"
#include "throughput/turns.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

constexpr double seconds_of_a_turn = .02;     ///< long beside a launch and a clock's tick, short beside what disturbs a machine
constexpr double most_seconds_of_a_turn = 1;  ///< aimed at, where the kernel is slow
constexpr std::uint32_t most_steps = 32;         ///< of a turn, where it takes more work-items than workers to occupy a device: 64 work-groups of 64 each
constexpr std::uint32_t eyes_of_a_worker = 128;  ///< the fused kernel's work-group: 8 groups of 16 lanes

/// Something to measure: a kernel at a lane width, and how many eyes it is given.
struct Entry {
    const MeasuredKernel* kernel;
    int lanes;
    std::optional<PairRun> run{};
    std::uint32_t eyes = 0;
};

std::vector<Entry> entries_of(const ThroughputRequest& request)
{
    std::vector<Entry> entries;
    for (const MeasuredKernel& kernel : measured_kernels()) {
        if (!request.kernels.empty() && std::ranges::find(request.kernels, kernel.name) == request.kernels.end()) continue;
        if (request.baseline && kernel.has_baseline) entries.push_back({&kernel, 0});
        for (const int lanes : request.lanes) entries.push_back({&kernel, lanes});
    }
    return entries;
}

/// Compiles all of them, several at a time.
void build(Device& device, std::vector<Entry>& entries, std::uint32_t eyes)
{
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < entries.size(); i = next++) entries[i].run.emplace(device, *entries[i].kernel, workload_of(*entries[i].kernel, eyes), entries[i].lanes);
    };
    std::vector<std::future<void>> builders;
    for (unsigned i = 0; i < std::max(std::thread::hardware_concurrency(), 1u); ++i) builders.push_back(std::async(std::launch::async, work));
    for (auto& builder : builders) builder.get();
}

/// The first runs, on which some drivers finish the compilation; and on how many eyes a turn takes its time, in steps that occupy all workers. Fewer than a step where that takes more than a second: some kernels are
/// ten thousand times slower than others on one device. Then until the device's bound on the time of launches has learnt how fast this one is.
void warm_up(Entry& entry, std::uint32_t step, const Clock& clock)
{
    PairRun& run = *entry.run;
    const auto timed = [&](std::uint32_t eyes) {
        const double start = clock();
        run.run(eyes);
        return std::max(clock() - start, 1e-9);
    };
    std::uint32_t eyes = std::max(step / 64 / eye_alignment, 1u) * eye_alignment;
    run.run(eyes);
    double seconds = timed(eyes);
    const auto grow = [&](std::uint32_t larger) { eyes = larger, run.run(eyes), seconds = timed(eyes); };
    while (eyes < step && 4 * seconds < most_seconds_of_a_turn) grow(std::min(4 * eyes, step));
    while (eyes >= step && seconds < seconds_of_a_turn && eyes < run.eye_count()) grow(std::min(2 * eyes, run.eye_count()));
    for (int again = 0; again < 16 && seconds < seconds_of_a_turn; ++again)
        if (const double before = std::exchange(seconds, timed(eyes)); before < 1.05 * seconds) break;
    entry.eyes = eyes;
}

/// After the first run of all: the least agreement of a kernel with the scalar one.
std::optional<double> check(const DeviceInfo& device, std::vector<Entry>& entries, std::uint32_t eyes)
{
    std::optional<double> least;
    std::vector<double> scalar;
    for (Entry& entry : entries) {
        if (!entry.kernel->has_baseline) continue;
        if (entry.lanes == 0) scalar.clear();
        entry.run->run(eyes);
        const std::vector<double> sums = entry.run->sums(eyes);
        if (entry.lanes == 0) {
            scalar = sums;
            continue;
        }
        if (scalar.empty()) continue;
        const double agreeing = agreeing_sums(sums, scalar);
        if (!(agreeing >= .99))
            throw DeviceError(device.platform + ": " + device.name + ": the kernel " + std::string(entry.kernel->name) + " at " + std::to_string(entry.lanes) +
                              " lanes and the scalar kernel do not compute the same; run `tyndall selftest --all-lanes` on this device");
        least = std::min(least.value_or(1), agreeing);
    }
    return least;
}

void measure(std::vector<Entry>& entries, const ThroughputRequest& request, const Clock& clock, ThroughputResult& result)
{
    std::vector<std::function<void()>> tasks;
    for (Entry& entry : entries) tasks.emplace_back([&entry] { entry.run->run(entry.eyes); });
    const auto seconds = seconds_in_turns(tasks, {.seconds = request.seconds}, clock, wall_seconds);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        KernelRate rate{std::string(entries[i].kernel->name), entries[i].lanes, {}, {}};
        const double pairs = static_cast<double>(entries[i].run->pairs(entries[i].eyes));
        for (const double s : seconds[i]) rate.rates.push_back(pairs / std::max(s, 1e-9));
        rate.pairs_per_second = spread_of(rate.rates);
        result.rounds = static_cast<int>(rate.rates.size());
        result.rates.push_back(std::move(rate));
    }
}

Device opened(const ThroughputRequest& request)
{
    if (request.cores == Cores::all) return Device(request.device);
    const OneCore only_for_the_device;
    return Device(request.device);
}

}  // namespace

std::vector<int> usual_widths(const DeviceInfo& device) { return device.is_cpu ? std::vector{1, 4, 8, 16} : std::vector{1, 4}; }

ThroughputResult measure_throughput(const ThroughputRequest& request)
{
    Device device = opened(request);
    ThroughputResult result{.device = device.info(), .cores = request.cores};
    result.processor_time = result.device.is_cpu && request.cores == Cores::one;
    result.default_lanes = request.default_lanes ? request.default_lanes : result.device.default_lanes;
    const std::uint32_t workers = result.processor_time ? 1 : std::max(result.device.compute_units, 1u), step = eyes_of_a_worker * workers;
    std::vector<Entry> entries = entries_of(request);
    const double start = wall_seconds();
    build(device, entries, std::max(2048u, (result.device.is_cpu ? 4 : most_steps) * step));
    result.agreeing = check(result.device, entries, step);
    const Clock clock = result.processor_time ? processor_seconds : wall_seconds;
    for (Entry& entry : entries) warm_up(entry, step, clock);
    const double built = wall_seconds();
    measure(entries, request, clock, result);
    result.build_seconds = built - start, result.seconds = wall_seconds() - built;
    return result;
}

const KernelRate* rate_of(const ThroughputResult& result, std::string_view kernel, int lanes)
{
    const auto found = std::ranges::find_if(result.rates, [&](const KernelRate& r) { return r.kernel == kernel && r.lanes == lanes; });
    return found == result.rates.end() ? nullptr : &*found;
}

std::optional<Spread> speedup_over_scalar(const ThroughputResult& result)
{
    const KernelRate *ours = rate_of(result, "henyey_greenstein", result.default_lanes), *scalar = rate_of(result, "henyey_greenstein", 0);
    if (!ours || !scalar) return std::nullopt;
    if (!measured_above(ours->pairs_per_second, scalar->pairs_per_second) && !measured_above(scalar->pairs_per_second, ours->pairs_per_second)) return std::nullopt;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < ours->rates.size(); ++i) ratios.push_back(ours->rates[i] / scalar->rates[i]);
    return spread_of(ratios);
}

std::vector<int> fastest_lanes(const ThroughputResult& result, std::string_view kernel)
{
    std::vector<Spread> spreads;
    std::vector<int> widths, fastest;
    for (const KernelRate& rate : result.rates)
        if (rate.kernel == kernel && rate.lanes != 0) spreads.push_back(rate.pairs_per_second), widths.push_back(rate.lanes);
    if (widths.empty()) return fastest;
    for (const std::size_t i : unbeaten(spreads)) fastest.push_back(widths[i]);
    return fastest;
}

}  // namespace tyndall
