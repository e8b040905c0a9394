#pragma once
/// What PairStage holds; the files of host/device that implement it include this.
#include <algorithm>
#include <array>
#include <chrono>
#include <deque>
#include <utility>

#include "device/device_state.hpp"
#include "device/kernel_source.hpp"
#include "device/launch_budget.hpp"
#include "device/native_chain.hpp"
#include "device/pair_stage.hpp"
#include "kernels/shared/host_features.hpp"

namespace tyndall {

template <typename T>
std::span<const std::byte> bytes_of(const std::vector<T>& values)
{
    return std::as_bytes(std::span(values));
}

/// One of two tiles on their way.
struct TileSlot {
    GrowingBuffer packets{CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR}, contributions{CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR};
    PairTile tile;
    void *mapped_packets = nullptr, *mapped_contributions = nullptr;
    cl::Event ready;
};

/// Lights, what each counts for, and what lies along them.
struct LightBuffers {
    GrowingBuffer records{CL_MEM_READ_ONLY}, weights{CL_MEM_READ_ONLY}, tables{CL_MEM_READ_WRITE};
};

enum class Timed { gather, sample, accumulate, tabulate, select };

/// A launch on its way, and what it holds: pairs, or items where nothing is known of them.
struct Launched {
    Timed what;
    double work;
    cl::Event event;
    std::chrono::steady_clock::time_point start;
};

inline constexpr std::size_t table_nodes = 65;  ///< kernels/volumes/optical_table.h

inline std::uint32_t work_items(std::uint32_t groups, std::uint32_t local) { return (groups + local - 1) / local * local; }

struct PairStage::State {
    DeviceState& device;
    PairProgram program;
    cl::Kernel gather, sample, accumulate, tabulate_lights, tabulate_eyes, estimate, weigh, pool, select;
    LightBuffers lights, offered;
    GrowingBuffer eyes{CL_MEM_READ_ONLY}, media{CL_MEM_READ_ONLY}, containers{CL_MEM_READ_ONLY}, planes{CL_MEM_READ_ONLY};
    GrowingBuffer lobes{CL_MEM_READ_ONLY}, phase_values{CL_MEM_READ_ONLY}, grids{CL_MEM_READ_ONLY}, voxels{CL_MEM_READ_ONLY};
    GrowingBuffer eye_tables{CL_MEM_READ_WRITE};
    GrowingBuffer standing{CL_MEM_READ_ONLY}, blocks{CL_MEM_READ_ONLY}, estimates{CL_MEM_READ_WRITE}, powers{CL_MEM_READ_WRITE}, ticks{CL_MEM_READ_WRITE}, totals{CL_MEM_READ_WRITE}, choices{CL_MEM_READ_WRITE};
    GrowingBuffer near_starts{CL_MEM_READ_ONLY}, near_lights{CL_MEM_READ_ONLY};
    GrowingBuffer pooled{CL_MEM_READ_WRITE}, pooled_total{CL_MEM_READ_WRITE}, drawn{CL_MEM_READ_WRITE};
    GrowingBuffer sums{CL_MEM_READ_WRITE}, ledger{CL_MEM_READ_WRITE}, worst{CL_MEM_READ_WRITE}, worst_counters{CL_MEM_READ_WRITE};
    std::array<TileSlot, 2> slots;
    std::uint32_t eye_count = 0, light_count = 0, slot_count = 0, vertex_limit = 0, container_count = 0;
    std::deque<Launched> launched;
    std::unique_ptr<NativeChain> chain;  ///< from the first tile that is chained
    WorstPair worst_pair;      ///< of the set whose sums were taken last
    PairLedger ledger_so_far;  ///< of the sets of eyes and lights whose sums were taken
    LaunchBudget budget{device.launch_seconds};
    PairTimings timings;

    bool has_grids() const { return (program.features & feature_bit::heterogeneous) != 0; }
    std::size_t table_bytes() const { return (table_nodes * (program.features & feature_bit::coloured_grids ? 3 : 1) + 1) * sizeof(float); }
    std::uint32_t lanes() const { return static_cast<std::uint32_t>(program.lanes); }
    std::uint32_t pairs_in(const PairTile& tile) const { return tile.lights * program.samples; }
    std::size_t packet_count(const PairTile& tile) const { return std::size_t(tile.groups) * lanes() / SHADOW_PACKET_SIZE * pairs_in(tile); }
    std::size_t contribution_count(const PairTile& tile) const { return std::size_t(tile.groups) * lanes() * pairs_in(tile) * 3 * program.sums_of_eye(); }
    std::size_t sum_count() const { return std::size_t(eye_count) * 6 * program.sums_of_eye(); }

    void build(const KernelBuild& wanted)
    {
        const cl::Program built = build_program(device, kernel_text(program, wanted), wanted.options);
        cl::Kernel& kernel = kernel_of(wanted.name);
        kernel = on_device(device, "creating a kernel", [&] { return cl::Kernel(built, wanted.name.c_str()); });
    }

    cl::Kernel& kernel_of(const std::string& name)
    {
        if (name == "tabulate_lights") return tabulate_lights;
        if (name == "tabulate_eyes") return tabulate_eyes;
        if (name == "estimate_lights") return estimate;
        if (name == "weigh_lights") return weigh;
        if (name == "pool_shares") return pool;
        if (name == "select_lights") return select;
        return name == "gather_lights" || name == "gather_near" ? gather : name == "accumulate_pairs" ? accumulate : sample;
    }

    /// What all kernels take of media; returns the next index.
    cl_uint set_surroundings(cl::Kernel& kernel, cl_uint i)
    {
        kernel.setArg(i++, media.get()), kernel.setArg(i++, containers.get()), kernel.setArg(i++, planes.get()), kernel.setArg(i++, container_count);
        kernel.setArg(i++, lobes.get()), kernel.setArg(i++, phase_values.get()), kernel.setArg(i++, grids.get()), kernel.setArg(i++, voxels.get());
        return i;
    }

    void run_table(cl::Kernel& kernel, GrowingBuffer& records, GrowingBuffer& tables, std::uint32_t items)
    {
        if (items == 0) return;
        kernel.setArg(0, records.get()), kernel.setArg(1, items);
        kernel.setArg(set_surroundings(kernel, 2), tables.get());
        launch(Timed::tabulate, kernel, items);
    }

    /// Uploads lights, with what each counts for (empty: 1), and tabulates what lies along them. Returns how many they are.
    std::uint32_t set_lights(LightBuffers& to, std::span<const std::byte> records, std::span<const float> weights)
    {
        const auto count = static_cast<std::uint32_t>(records.size() / program.light_bytes);
        to.records.upload(device, records);
        if (program.selection) to.weights.upload(device, weights.empty() ? bytes_of(std::vector<float>(count, 1.0f)) : std::as_bytes(weights));
        const bool wanted = has_grids() && program.light_is_line;
        to.tables.reserve(device, wanted ? count * table_bytes() : 0);
        if (wanted) on_device(device, "tabulating what lies along lights", [&] { run_table(tabulate_lights, to.records, to.tables, count); });
        return count;
    }

    void tabulate_segments()
    {
        const bool wanted = has_grids() && program.eyes == EyeKind::segments;
        eye_tables.reserve(device, wanted ? eye_count * table_bytes() : 0);
        if (wanted) on_device(device, "tabulating what lies along eyes", [&] { run_table(tabulate_eyes, eyes, eye_tables, eye_count / lanes()); });
    }

    void weigh_lights(LightBuffers& from, std::uint32_t first, std::uint32_t count, const LightSelection& selection);
    void draw_lights(std::span<const EyeBlock> wanted, LightBuffers& from, std::uint32_t count, std::uint32_t slots, GrowingBuffer& shares, GrowingBuffer& sums_of_shares,
                     GrowingBuffer& drawn);

    /// The arguments that gather and sample share; returns the next index.
    cl_uint set_common(cl::Kernel& kernel, const PairTile& tile)
    {
        cl_uint i = 0;
        kernel.setArg(i++, eyes.get()), kernel.setArg(i++, tile.first_group), kernel.setArg(i++, tile.groups);
        kernel.setArg(i++, lights.records.get()), kernel.setArg(i++, tile.first_light), kernel.setArg(i++, tile.lights);
        kernel.setArg(i++, program.samples), kernel.setArg(i++, vertex_limit);
        i = set_surroundings(kernel, i);
        kernel.setArg(i++, eye_tables.get()), kernel.setArg(i++, lights.tables.get());
        kernel.setArg(i++, choices.get()), kernel.setArg(i++, slot_count);
        return i;
    }

    static const char* name_of(Timed what)
    {
        constexpr const char* names[] = {"gather", "sample", "accumulate", "tabulate", "select"};
        return names[static_cast<std::size_t>(what)];
    }

    void launch(Timed what, cl::Kernel& kernel, std::uint32_t groups, double work_per_group = 1) { launch(what, kernel, groups, work_per_group, device.queue, {}); }

    /// In one of the device's queues, when `before` has happened.
    cl::Event launch(Timed what, cl::Kernel& kernel, std::uint32_t groups, double work_per_group, const cl::CommandQueue& queue, const std::vector<cl::Event>& before)
    {
        const std::uint32_t few = what == Timed::gather || groups >= 256 ? 8 : 1;  // some drivers compile a kernel again for every local size
        const std::uint32_t local = local_size(device, kernel, device.info.is_cpu ? few : 64);  // two warps of a GPU
        cl::Event event;
        const auto now = std::chrono::steady_clock::now();
        queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(work_items(groups, local)), cl::NDRange(local), before.empty() ? nullptr : &before, &event);
        queue.flush();
        ++timings.launches;
        launched.push_back({what, groups * work_per_group, event, now});
        return event;
    }

    void launch_sample(TileSlot& slot, const cl::CommandQueue& queue, const std::vector<cl::Event>& before);
    cl::Event launch_accumulate(const TileSlot& slot, const cl::CommandQueue& queue, const std::vector<cl::Event>& before);

    /// By the device's clock; by the one on the wall, waiting included, where it has none and somebody waited for the launch.
    void count(const Launched& l, double seconds)
    {
        double* const sums[] = {&timings.gather, &timings.sample, &timings.accumulate, &timings.tabulate, &timings.select};
        *sums[static_cast<std::size_t>(l.what)] += seconds;
        timings.largest_launch = std::max(timings.largest_launch, seconds);
        budget.measured(name_of(l.what), l.work, seconds);
    }

    /// Counts the launches that have finished, in order; `all`: they all have.
    void harvest(bool all)
    {
        while (!launched.empty() && (all || launched.front().event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() <= CL_COMPLETE)) {
            const Launched& l = launched.front();
            if (const cl_int status = l.event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>(); status < 0) throw cl::Error(status, name_of(l.what));
            if (device.time_stamps)
                count(l, 1e-9 * static_cast<double>(l.event.getProfilingInfo<CL_PROFILING_COMMAND_END>() - l.event.getProfilingInfo<CL_PROFILING_COMMAND_START>()));
            launched.pop_front();
        }
    }

    /// Waits for the last launch, so that the next can be sized by it.
    void wait_and_count()
    {
        launched.back().event.wait();
        if (!device.time_stamps) count(launched.back(), std::chrono::duration<double>(std::chrono::steady_clock::now() - launched.back().start).count());
        harvest(true);
    }
};

}  // namespace tyndall
