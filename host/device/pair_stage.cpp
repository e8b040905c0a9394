#include "device/pair_stage.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "device/device_state.hpp"
#include "device/kernel_source.hpp"
#include "kernels/shared/host_features.hpp"

namespace tyndall {
namespace {

template <typename T>
std::span<const std::byte> bytes_of(const std::vector<T>& values)
{
    return std::as_bytes(std::span(values));
}

struct Slot {
    GrowingBuffer packets{CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR}, contributions{CL_MEM_READ_WRITE | CL_MEM_ALLOC_HOST_PTR};
    PairTile tile;
    void *mapped_packets = nullptr, *mapped_contributions = nullptr;
    cl::Event ready;
};

enum class Timed { gather, sample, accumulate, tabulate };

constexpr std::size_t table_nodes = 65;  ///< kernels/volumes/optical_table.h

std::uint32_t work_items(std::uint32_t groups, std::uint32_t local) { return (groups + local - 1) / local * local; }

}  // namespace

struct PairStage::State {
    DeviceState& device;
    PairProgram program;
    cl::Kernel gather, sample, accumulate, tabulate_lights, tabulate_eyes;
    GrowingBuffer eyes{CL_MEM_READ_ONLY}, lights{CL_MEM_READ_ONLY}, media{CL_MEM_READ_ONLY}, containers{CL_MEM_READ_ONLY}, planes{CL_MEM_READ_ONLY};
    GrowingBuffer lobes{CL_MEM_READ_ONLY}, phase_values{CL_MEM_READ_ONLY}, grids{CL_MEM_READ_ONLY}, voxels{CL_MEM_READ_ONLY};
    GrowingBuffer eye_tables{CL_MEM_READ_WRITE}, light_tables{CL_MEM_READ_WRITE};
    GrowingBuffer sums{CL_MEM_READ_WRITE}, ledger{CL_MEM_READ_WRITE};
    std::array<Slot, 2> slots;
    std::uint32_t eye_count = 0, vertex_limit = 0, container_count = 0;
    std::vector<std::pair<Timed, cl::Event>> events;
    PairTimings timings;

    bool has_grids() const { return (program.features & feature_bit::heterogeneous) != 0; }
    std::size_t table_bytes() const { return (table_nodes * (program.features & feature_bit::coloured_grids ? 3 : 1) + 1) * sizeof(float); }
    std::uint32_t lanes() const { return static_cast<std::uint32_t>(program.lanes); }
    std::uint32_t pairs_in(const PairTile& tile) const { return tile.lights * program.samples; }
    std::size_t packet_count(const PairTile& tile) const { return std::size_t(tile.groups) * lanes() / SHADOW_PACKET_SIZE * pairs_in(tile); }
    std::size_t contribution_count(const PairTile& tile) const { return std::size_t(tile.groups) * lanes() * pairs_in(tile) * 3; }

    void build(const KernelBuild& wanted)
    {
        const bool shared = wanted.name == "accumulate_pairs";  // asks neither eyes nor lights: one program serves all
        const std::string eye = program.eyes == EyeKind::segments || shared ? "eye_segments" : "eye_points", light = shared ? PairProgram{}.light : program.light;
        const std::string text = flattened_kernel("kernels/stages/" + wanted.name + ".cl",
                                                  {{"LIGHT", "kernels/lights/" + light + ".h"}, {"EYE", "kernels/stages/" + eye + ".h"}});
        const cl::Program built = build_program(device, text, wanted.options);
        cl::Kernel& kernel = kernel_of(wanted.name);
        kernel = on_device(device, "creating a kernel", [&] { return cl::Kernel(built, wanted.name.c_str()); });
    }

    cl::Kernel& kernel_of(const std::string& name)
    {
        if (name == "tabulate_lights") return tabulate_lights;
        if (name == "tabulate_eyes") return tabulate_eyes;
        return name == "gather_lights" ? gather : name == "accumulate_pairs" ? accumulate : sample;
    }

    /// What all kernels take of media; returns the next index.
    cl_uint set_surroundings(cl::Kernel& kernel, cl_uint i)
    {
        kernel.setArg(i++, media.get()), kernel.setArg(i++, containers.get()), kernel.setArg(i++, planes.get()), kernel.setArg(i++, container_count);
        kernel.setArg(i++, lobes.get()), kernel.setArg(i++, phase_values.get()), kernel.setArg(i++, grids.get()), kernel.setArg(i++, voxels.get());
        return i;
    }

    /// Room for the tables, and the tables themselves.
    void tabulate(std::uint32_t light_count)
    {
        eye_tables.reserve(device, has_grids() && program.eyes == EyeKind::segments ? eye_count * table_bytes() : 0);
        light_tables.reserve(device, has_grids() ? light_count * table_bytes() : 0);
        if (!has_grids()) return;
        const auto run = [&](cl::Kernel& kernel, GrowingBuffer& records, GrowingBuffer& tables, std::uint32_t items) {
            if (items == 0) return;
            kernel.setArg(0, records.get()), kernel.setArg(1, items);
            kernel.setArg(set_surroundings(kernel, 2), tables.get());
            launch(Timed::tabulate, kernel, items);
        };
        on_device(device, "tabulating what lies along lights and eyes", [&] {
            run(tabulate_lights, lights, light_tables, light_count);
            if (program.eyes == EyeKind::segments) run(tabulate_eyes, eyes, eye_tables, eye_count / lanes());
        });
    }

    /// The arguments that gather and sample share; returns the next index.
    cl_uint set_common(cl::Kernel& kernel, const PairTile& tile)
    {
        cl_uint i = 0;
        kernel.setArg(i++, eyes.get()), kernel.setArg(i++, tile.first_group), kernel.setArg(i++, tile.groups);
        kernel.setArg(i++, lights.get()), kernel.setArg(i++, tile.first_light), kernel.setArg(i++, tile.lights);
        kernel.setArg(i++, program.samples), kernel.setArg(i++, vertex_limit);
        i = set_surroundings(kernel, i);
        kernel.setArg(i++, eye_tables.get()), kernel.setArg(i++, light_tables.get());
        return i;
    }

    void launch(Timed what, cl::Kernel& kernel, std::uint32_t groups)
    {
        const std::uint32_t local = what == Timed::gather || groups >= 256 ? 8 : 1;  // some drivers compile a kernel again for every local size
        cl::Event event;
        device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(work_items(groups, local)), cl::NDRange(local), nullptr, &event);
        ++timings.launches;
        if (device.time_stamps) events.emplace_back(what, event);
    }

    void harvest()
    {
        for (auto& [what, event] : events) {
            const double seconds = 1e-9 * static_cast<double>(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() - event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
            (what == Timed::gather ? timings.gather : what == Timed::sample ? timings.sample : what == Timed::accumulate ? timings.accumulate : timings.tabulate) += seconds;
            timings.largest_launch = std::max(timings.largest_launch, seconds);
        }
        events.clear();
    }
};

std::string build_options(const PairProgram& program)
{
    return "-cl-std=CL1.2 -DLANES=" + std::to_string(program.lanes) + " -DFEATURES=" + std::to_string(program.features) + "u -DSAMPLER=" + std::to_string(program.sampler) +
           " -DSEQUENCE=" + std::to_string(program.sequence) +
           (program.features & feature_bit::heterogeneous ? " -DTRANSMITTANCE=" + std::to_string(program.transmittance) : "");
}

std::vector<KernelBuild> kernel_builds(const PairProgram& program)
{
    const std::string own = build_options(program);
    std::vector<KernelBuild> builds;
    if (program.features & feature_bit::heterogeneous) builds.push_back({"tabulate_lights", own, program.features});
    if (program.features & feature_bit::heterogeneous && program.eyes == EyeKind::segments) builds.push_back({"tabulate_eyes", own, program.features});
    if (program.features & feature_bit::occluders) builds.insert(builds.end(), {{"sample_pairs", own, program.features}, {"accumulate_pairs", build_options({.lanes = program.lanes}), 0}});
    else builds.push_back({"gather_lights", own, program.features});
    return builds;
}

PairStage::PairStage(Device& device, const PairProgram& program, const MediaTables& tables) : state_(std::make_unique<State>(State{device.state(), program}))
{
    for (const KernelBuild& wanted : kernel_builds(program)) state_->build(wanted);
    state_->media.upload(state_->device, bytes_of(tables.media));
    state_->containers.upload(state_->device, bytes_of(tables.containers));
    state_->planes.upload(state_->device, bytes_of(tables.planes));
    state_->lobes.upload(state_->device, bytes_of(tables.lobes));
    state_->phase_values.upload(state_->device, bytes_of(tables.phase_values));
    state_->grids.upload(state_->device, bytes_of(tables.grids));
    state_->voxels.upload(state_->device, bytes_of(tables.voxels));
    state_->container_count = static_cast<std::uint32_t>(tables.containers.size());
    const std::vector<std::uint32_t> zero(4, 0);
    state_->ledger.upload(state_->device, bytes_of(zero));
}

PairStage::~PairStage() = default;
PairStage::PairStage(PairStage&&) noexcept = default;

std::uint32_t PairStage::groups() const { return state_->eye_count / state_->lanes(); }

void PairStage::begin(std::span<const std::byte> eyes, std::uint32_t eye_count, std::span<const std::byte> lights, std::uint32_t vertex_limit)
{
    if (eye_count % eye_alignment != 0) throw std::logic_error("eyes are padded to a multiple of 16");
    state_->eye_count = eye_count, state_->vertex_limit = vertex_limit;
    state_->eyes.upload(state_->device, eyes);
    state_->lights.upload(state_->device, lights);
    cl::Buffer& sums = state_->sums.reserve(state_->device, std::size_t(eye_count) * 6 * sizeof(float));
    state_->tabulate(static_cast<std::uint32_t>(lights.size() / state_->program.light_bytes));
    on_device(state_->device, "clearing sums", [&] { state_->device.queue.enqueueFillBuffer(sums, 0.0f, 0, std::max<std::size_t>(std::size_t(eye_count) * 6 * sizeof(float), 64)); });
}

void PairStage::gather(const PairTile& tile)
{
    on_device(state_->device, "adding lights", [&] {
        cl_uint i = state_->set_common(state_->gather, tile);
        state_->gather.setArg(i++, state_->sums.get()), state_->gather.setArg(i++, state_->ledger.get());
        state_->launch(Timed::gather, state_->gather, tile.groups);
        state_->device.queue.flush();
    });
}

void PairStage::sample(int slot, const PairTile& tile)
{
    Slot& s = state_->slots[static_cast<std::size_t>(slot)];
    s.tile = tile;
    const std::size_t packet_bytes = state_->packet_count(tile) * sizeof(ShadowPacket), contribution_bytes = state_->contribution_count(tile) * sizeof(float);
    cl::Buffer &packets = s.packets.reserve(state_->device, packet_bytes), &contributions = s.contributions.reserve(state_->device, contribution_bytes);
    on_device(state_->device, "sampling pairs", [&] {
        cl_uint i = state_->set_common(state_->sample, tile);
        state_->sample.setArg(i++, packets), state_->sample.setArg(i++, contributions), state_->sample.setArg(i++, state_->ledger.get());
        state_->launch(Timed::sample, state_->sample, tile.groups);
        auto& queue = state_->device.queue;
        s.mapped_packets = queue.enqueueMapBuffer(packets, CL_FALSE, CL_MAP_READ | CL_MAP_WRITE, 0, packet_bytes);
        s.mapped_contributions = queue.enqueueMapBuffer(contributions, CL_FALSE, CL_MAP_READ | CL_MAP_WRITE, 0, contribution_bytes, nullptr, &s.ready);
        queue.flush();
    });
}

SampledTile PairStage::sampled(int slot)
{
    Slot& s = state_->slots[static_cast<std::size_t>(slot)];
    on_device(state_->device, "waiting for sampled pairs", [&] { s.ready.wait(); });
    return {{static_cast<ShadowPacket*>(s.mapped_packets), state_->packet_count(s.tile)}, {static_cast<float*>(s.mapped_contributions), state_->contribution_count(s.tile)}};
}

void PairStage::accumulate(int slot)
{
    Slot& s = state_->slots[static_cast<std::size_t>(slot)];
    on_device(state_->device, "adding visible pairs", [&] {
        auto& queue = state_->device.queue;
        queue.enqueueUnmapMemObject(s.packets.get(), s.mapped_packets);
        queue.enqueueUnmapMemObject(s.contributions.get(), s.mapped_contributions);
        cl::Kernel& kernel = state_->accumulate;
        kernel.setArg(0, s.tile.first_group), kernel.setArg(1, s.tile.groups), kernel.setArg(2, state_->pairs_in(s.tile));
        kernel.setArg(3, s.packets.get()), kernel.setArg(4, s.contributions.get()), kernel.setArg(5, state_->sums.get());
        state_->launch(Timed::accumulate, kernel, s.tile.groups);
        queue.flush();
    });
}

std::vector<double> PairStage::sums()
{
    const std::uint32_t lanes = state_->lanes();
    std::vector<float> raw(std::size_t(state_->eye_count) * 6);
    std::vector<double> sums(std::size_t(state_->eye_count) * 3);
    if (raw.empty()) return sums;
    on_device(state_->device, "reading sums", [&] {
        state_->device.queue.enqueueReadBuffer(state_->sums.get(), CL_TRUE, 0, raw.size() * sizeof(float), raw.data());
        state_->harvest();
    });
    for (std::size_t eye = 0; eye < state_->eye_count; ++eye) {
        const std::size_t group = eye / lanes, lane = eye % lanes;
        for (std::size_t c = 0; c < 3; ++c)
            sums[eye * 3 + c] = double(raw[(group * 6 + 2 * c) * lanes + lane]) + double(raw[(group * 6 + 2 * c + 1) * lanes + lane]);
    }
    return sums;
}

PairLedger PairStage::ledger() const
{
    std::array<std::uint32_t, 4> raw{};
    on_device(state_->device, "reading the ledger", [&] { state_->device.queue.enqueueReadBuffer(state_->ledger.get(), CL_TRUE, 0, sizeof raw, raw.data()); });
    return {.not_finite = raw[0], .first_eye = raw[1], .first_counter = raw[2], .floored = raw[3]};
}

PairTimings PairStage::timings() const { return state_->timings; }
std::string PairStage::options() const { return build_options(state_->program); }

}  // namespace tyndall
