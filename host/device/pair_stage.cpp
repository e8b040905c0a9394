#include "device/pair_stage.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "device/pair_stage_state.hpp"

namespace tyndall {

/// Nine digits tell every float from its neighbours; a point, whatever the locale of the program that uses the library.
static std::string clamp_option(float clamp) { return fmt::format(" -DCLAMP={:.9e}f", static_cast<double>(clamp)); }

std::string build_options(const PairProgram& program)
{
    return "-cl-std=CL1.2 -DLANES=" + std::to_string(program.lanes) + " -DFEATURES=" + std::to_string(program.features) + "u -DSAMPLER=" + std::to_string(program.sampler) +
           " -DSEQUENCE=" + std::to_string(program.sequence) + (program.selection ? " -DSELECTION=1" : "") +
           (program.features & feature_bit::heterogeneous ? " -DTRANSMITTANCE=" + std::to_string(program.transmittance) : "") +
           (program.clamp > 0 ? clamp_option(program.clamp) : "") + (program.precision == 64 ? " -DPRECISION=64" : "") +
           (program.fast_math ? " -cl-unsafe-math-optimizations -cl-denorms-are-zero" : "");  // --math fast: infinities and NaN keep their meaning, so the ledger counts them
}

/// Estimates ask neither for samplers nor for what stands between: fewer programs serve more scenes.
static KernelBuild estimate_build(PairProgram program)
{
    program.features &= ~(feature_bit::occluders | feature_bit::boundaries | feature_bit::nonconvex_media);
    program.sampler = program.sequence = program.transmittance = 0, program.selection = false, program.clamp = 0, program.precision = 32, program.fast_math = false;
    return {"estimate_lights", build_options(program), program.features};
}

std::vector<KernelBuild> kernel_builds(const PairProgram& program)
{
    const std::string own = build_options(program);
    std::vector<KernelBuild> builds;
    if (program.features & feature_bit::heterogeneous && program.light_is_line) builds.push_back({"tabulate_lights", own, program.features});
    if (program.features & feature_bit::heterogeneous && program.eyes == EyeKind::segments) builds.push_back({"tabulate_eyes", own, program.features});
    if (program.gathers) builds.push_back({"gather_near", own, program.features});
    else if (program.features & feature_bit::occluders) builds.insert(builds.end(), {{"sample_pairs", own, program.features}, {"accumulate_pairs", build_options({.lanes = program.lanes, .clamp = program.clamp, .precision = program.precision}), 0}});
    else builds.push_back({"gather_lights", own, program.features});
    if (program.selection) builds.insert(builds.end(), {estimate_build(program), {"weigh_lights", build_options({.lanes = program.lanes}), 0}, {"pool_shares", build_options({.lanes = program.lanes}), 0}, {"select_lights", build_options({.lanes = program.lanes}), 0}});
    return builds;
}

std::string kernel_text(const PairProgram& program, const KernelBuild& wanted)
{
    const std::string kind = program.eyes == EyeKind::segments || wanted.serves_all() ? "_segments.h" : "_points.h", light = wanted.serves_all() ? PairProgram{}.light : program.light;
    return flattened_kernel("kernels/stages/" + wanted.file() + ".cl", {{"LIGHT", "kernels/lights/" + light + ".h"},
                                                                        {"EYE", (program.gathers ? "kernels/stages/near" : "kernels/stages/eye") + kind},
                                                                        {"STAGE", program.gathers ? "kernels/stages/near_stage.h" : "kernels/stages/pair_stage.h"}});
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
}

PairStage::~PairStage() = default;
PairStage::PairStage(PairStage&&) noexcept = default;

std::uint32_t PairStage::groups() const { return state_->eye_count / state_->lanes(); }

void PairStage::begin(std::span<const std::byte> eyes, std::uint32_t eye_count, std::span<const std::byte> lights, std::uint32_t vertex_limit, std::span<const float> weights)
{
    if (eye_count % eye_alignment != 0) throw std::logic_error("eyes are padded to a multiple of 16");
    state_->eye_count = eye_count, state_->vertex_limit = vertex_limit;
    state_->eyes.upload(state_->device, eyes);
    state_->light_count = state_->slot_count = state_->set_lights(state_->lights, lights, weights);
    state_->choices.reserve(state_->device, 0);
    cl::Buffer& sums = state_->sums.reserve(state_->device, state_->sum_count() * sizeof(float));
    state_->tabulate_segments();
    state_->ledger.upload(state_->device, bytes_of(std::vector<std::uint32_t>(4, 0)));
    const std::size_t bytes = std::max<std::size_t>(std::size_t(eye_count) * sizeof(float), 64);
    cl::Buffer &worst = state_->worst.reserve(state_->device, bytes), &counters = state_->worst_counters.reserve(state_->device, bytes);
    state_->worst_pair = {};
    on_device(state_->device, "clearing sums", [&] {
        state_->device.queue.enqueueFillBuffer(sums, 0.0f, 0, std::max<std::size_t>(state_->sum_count() * sizeof(float), 64));
        state_->device.queue.enqueueFillBuffer(worst, 0.0f, 0, bytes);
        state_->device.queue.enqueueFillBuffer(counters, 0u, 0, bytes);
    });
}

void PairStage::gather(const PairTile& tile)
{
    State& s = *state_;
    const double work = double(s.pairs_in(tile)) * s.lanes();
    PairTile piece = tile;
    for (std::uint32_t done = 0; done < tile.groups; done += piece.groups) {
        on_device(s.device, "adding lights", [&] {
            s.harvest(false);
            if (s.launched.size() > 1) s.launched[s.launched.size() - 2].event.wait();  // at most two on their way, so that a render can be stopped between launches
            const bool known = s.budget.knows("gather");
            piece.first_group = tile.first_group + done, piece.groups = s.budget.items("gather", tile.groups - done, work);
            cl_uint i = s.set_common(s.gather, piece);
            s.gather.setArg(i++, s.sums.get()), s.gather.setArg(i++, s.ledger.get());
            s.gather.setArg(i++, s.worst.get()), s.gather.setArg(i++, s.worst_counters.get());
            s.launch(Timed::gather, s.gather, piece.groups, work);
            s.device.queue.flush();
            if (!known || !s.device.time_stamps) s.wait_and_count();
        });
    }
}

std::uint32_t PairStage::most_sampled(std::uint32_t pairs) const { return state_->budget.knows("sample") ? state_->budget.items("sample", pairs, 1) : pairs; }

void PairStage::State::launch_sample(TileSlot& slot, const cl::CommandQueue& queue, const std::vector<cl::Event>& before)
{
    const PairTile& tile = slot.tile;
    if (tile.groups * lanes() % SHADOW_PACKET_SIZE != 0) throw std::logic_error("a tile with shadow segments holds whole packets of 16 eyes");
    cl_uint i = set_common(sample, tile);
    sample.setArg(i++, slot.packets.reserve(device, packet_count(tile) * sizeof(ShadowPacket)));
    sample.setArg(i++, slot.contributions.reserve(device, contribution_count(tile) * sizeof(float))), sample.setArg(i++, ledger.get());
    launch(Timed::sample, sample, tile.groups, double(pairs_in(tile)) * lanes(), queue, before);
}

cl::Event PairStage::State::launch_accumulate(const TileSlot& slot, const cl::CommandQueue& queue, const std::vector<cl::Event>& before)
{
    const PairTile& tile = slot.tile;
    cl_uint i = 0;
    accumulate.setArg(i++, tile.first_group), accumulate.setArg(i++, tile.groups), accumulate.setArg(i++, tile.first_light * program.samples);
    accumulate.setArg(i++, pairs_in(tile)), accumulate.setArg(i++, slot.packets.get()), accumulate.setArg(i++, slot.contributions.get());
    accumulate.setArg(i++, sums.get()), accumulate.setArg(i++, worst.get()), accumulate.setArg(i++, worst_counters.get());
    return launch(Timed::accumulate, accumulate, tile.groups, double(pairs_in(tile)) * lanes(), queue, before);
}

void PairStage::sample(int slot, const PairTile& tile)
{
    TileSlot& s = state_->slots[static_cast<std::size_t>(slot)];
    s.tile = tile;
    on_device(state_->device, "sampling pairs", [&] {
        state_->harvest(false);
        auto& queue = state_->device.queue;
        state_->launch_sample(s, queue, {});
        s.mapped_packets = queue.enqueueMapBuffer(s.packets.get(), CL_FALSE, CL_MAP_READ | CL_MAP_WRITE, 0, state_->packet_count(tile) * sizeof(ShadowPacket));
        s.mapped_contributions = queue.enqueueMapBuffer(s.contributions.get(), CL_FALSE, CL_MAP_READ | CL_MAP_WRITE, 0, state_->contribution_count(tile) * sizeof(float), nullptr, &s.ready);
        queue.flush();
    });
}

SampledTile PairStage::sampled(int slot)
{
    TileSlot& s = state_->slots[static_cast<std::size_t>(slot)];
    on_device(state_->device, "waiting for sampled pairs", [&] { s.ready.wait(); });
    return {{static_cast<ShadowPacket*>(s.mapped_packets), state_->packet_count(s.tile)}, {static_cast<float*>(s.mapped_contributions), state_->contribution_count(s.tile)}};
}

void PairStage::accumulate(int slot)
{
    TileSlot& s = state_->slots[static_cast<std::size_t>(slot)];
    on_device(state_->device, "adding visible pairs", [&] {
        auto& queue = state_->device.queue;
        queue.enqueueUnmapMemObject(s.packets.get(), s.mapped_packets);
        queue.enqueueUnmapMemObject(s.contributions.get(), s.mapped_contributions);
        s.mapped_packets = s.mapped_contributions = nullptr;
        state_->launch_accumulate(s, queue, {});
    });
}

void PairStage::wait()
{
    on_device(state_->device, "waiting for the device", [&] {
        state_->device.queue.finish();
        state_->harvest(true);
    });
}

std::vector<double> PairStage::sums()
{
    const std::uint32_t lanes = state_->lanes();
    const std::size_t kinds = state_->program.sums_of_eye(), eyes = state_->eye_count;
    std::vector<float> raw(state_->sum_count());
    std::vector<double> sums(eyes * kinds * 3);
    if (raw.empty()) return sums;
    std::array<std::uint32_t, 4> counted{};
    std::vector<float> worst(state_->eye_count);
    std::vector<std::uint32_t> counters(state_->eye_count);
    on_device(state_->device, "reading sums", [&] {
        state_->device.queue.enqueueReadBuffer(state_->worst.get(), CL_TRUE, 0, worst.size() * sizeof(float), worst.data());
        state_->device.queue.enqueueReadBuffer(state_->worst_counters.get(), CL_TRUE, 0, counters.size() * sizeof(std::uint32_t), counters.data());
        state_->device.queue.enqueueReadBuffer(state_->ledger.get(), CL_TRUE, 0, sizeof counted, counted.data());
        state_->device.queue.enqueueReadBuffer(state_->sums.get(), CL_TRUE, 0, raw.size() * sizeof(float), raw.data());
        state_->harvest(true);
    });
    state_->ledger_so_far.add(counted);
    const auto eye_of_worst = static_cast<std::uint32_t>(std::max_element(worst.begin(), worst.end()) - worst.begin());
    state_->worst_pair = {.eye = eye_of_worst, .slot = counters[eye_of_worst] / state_->program.samples, .value = double(worst[eye_of_worst])};
    for (std::size_t i = 0; i < eyes * kinds; ++i) {
        const std::size_t eye = i / kinds, kind = i % kinds, group = eye / lanes * kinds + kind, lane = eye % lanes;
        for (std::size_t c = 0; c < 3; ++c)
            sums[i * 3 + c] = double(raw[(group * 6 + 2 * c) * lanes + lane]) + double(raw[(group * 6 + 2 * c + 1) * lanes + lane]);
    }
    return sums;
}

PairLedger PairStage::ledger() const { return state_->ledger_so_far; }
WorstPair PairStage::worst() const { return state_->worst_pair; }

void PairStage::recover()
{
    State& s = *state_;
    const auto whatever_comes = [](auto&& call) {
        try {
            call();
        } catch (const cl::Error&) {  // the device has said already what is wrong
        }
    };
    drop_chain();
    for (TileSlot& slot : s.slots) {
        if (slot.mapped_packets) whatever_comes([&] { s.device.queue.enqueueUnmapMemObject(slot.packets.get(), slot.mapped_packets); });
        if (slot.mapped_contributions) whatever_comes([&] { s.device.queue.enqueueUnmapMemObject(slot.contributions.get(), slot.mapped_contributions); });
    }
    whatever_comes([&] { s.device.queue.finish(); });
    for (TileSlot& slot : s.slots) {
        slot.mapped_packets = slot.mapped_contributions = nullptr;
        slot.packets.release(), slot.contributions.release();
    }
    for (GrowingBuffer* buffer : {&s.eyes, &s.eye_tables, &s.standing, &s.blocks, &s.estimates, &s.ticks, &s.totals, &s.choices, &s.near_starts, &s.near_lights, &s.sums, &s.worst, &s.worst_counters}) buffer->release();
    s.launched.clear();
}

PairTimings PairStage::timings() const { return state_->timings; }
std::string PairStage::options() const { return build_options(state_->program) + state_->device.info.build_options; }

}  // namespace tyndall
