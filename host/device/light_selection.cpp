/// Choosing lights for blocks of eyes, and candidates for regions of many blocks, on the device.
#include <stdexcept>

#include "device/pair_stage_state.hpp"

namespace tyndall {
namespace {

constexpr std::uint32_t pooled_lights = 256;  ///< kernels/stages/select_lights.cl

std::uint32_t divided_up(std::uint32_t a, std::uint32_t b) { return (a + b - 1) / b; }

}  // namespace

/// Estimates of lights first ... first + count - 1 for the standing eyes, and their shares in ticks.
void PairStage::State::weigh_lights(LightBuffers& from, std::uint32_t first, std::uint32_t count, const LightSelection& selection)
{
    const std::uint32_t standing_groups = selection.standing_count / lanes();
    const std::size_t all = std::size_t(selection.standing_count) * count;
    standing.upload(device, selection.standing);
    estimates.reserve(device, all * sizeof(float)), ticks.reserve(device, all * sizeof(std::uint32_t));
    powers.reserve(device, count * sizeof(float)), totals.reserve(device, selection.standing_count * sizeof(std::uint32_t));
    cl_uint i = 0;
    estimate.setArg(i++, standing.get()), estimate.setArg(i++, standing_groups);
    estimate.setArg(i++, from.records.get()), estimate.setArg(i++, from.weights.get()), estimate.setArg(i++, first), estimate.setArg(i++, count), estimate.setArg(i++, vertex_limit);
    i = set_surroundings(estimate, i);
    estimate.setArg(i++, eye_tables.get()), estimate.setArg(i++, from.tables.get());
    estimate.setArg(i++, estimates.get()), estimate.setArg(i++, powers.get());
    launch(Timed::select, estimate, standing_groups * divided_up(count, light_block));
    i = 0;
    weigh.setArg(i++, standing_groups), weigh.setArg(i++, count), weigh.setArg(i++, selection.defence);
    weigh.setArg(i++, estimates.get()), weigh.setArg(i++, powers.get()), weigh.setArg(i++, ticks.get()), weigh.setArg(i++, totals.get());
    launch(Timed::select, weigh, standing_groups);
}

/// Draws `slots` of `count` lights for every group of the blocks.
void PairStage::State::draw_lights(std::span<const EyeBlock> wanted, LightBuffers& from, std::uint32_t count, std::uint32_t slots, GrowingBuffer& shares, GrowingBuffer& sums_of_shares,
                                   GrowingBuffer& drawn)
{
    blocks.upload(device, std::as_bytes(wanted));
    cl_uint i = 0;
    select.setArg(i++, blocks.get()), select.setArg(i++, static_cast<std::uint32_t>(wanted.size())), select.setArg(i++, from.weights.get());
    select.setArg(i++, count), select.setArg(i++, slots), select.setArg(i++, shares.get()), select.setArg(i++, sums_of_shares.get()), select.setArg(i++, drawn.get());
    launch(Timed::select, select, static_cast<std::uint32_t>(wanted.size()));
}

void PairStage::select(const LightSelection& selection)
{
    State& s = *state_;
    if (selection.standing_count % eye_alignment != 0) throw std::logic_error("standing eyes are padded to a multiple of 16");
    if (!s.program.selection) throw std::logic_error("this program connects to all lights");
    if (s.light_count == 0 || selection.blocks.empty()) return;
    s.slot_count = selection.slots;
    s.choices.reserve(s.device, std::size_t(s.eye_count) / eye_alignment * selection.slots * sizeof(LightChoice));
    on_device(s.device, "choosing lights", [&] {
        s.weigh_lights(s.lights, 0, s.light_count, selection);
        s.draw_lights(selection.blocks, s.lights, s.light_count, selection.slots, s.ticks, s.totals, s.choices);
    });
}

void PairStage::offer(std::span<const std::byte> lights, std::uint32_t vertex_limit)
{
    state_->vertex_limit = vertex_limit;
    state_->set_lights(state_->offered, lights, {});
}

std::vector<LightChoice> PairStage::candidates(const LightSelection& selection, std::uint32_t first, std::uint32_t count, std::uint32_t key)
{
    State& s = *state_;
    if (selection.standing_count != eye_alignment) throw std::logic_error("16 eyes stand for a region");
    std::vector<LightChoice> drawn(selection.slots);
    const EyeBlock region{.first = 0, .groups = 1, .key = key, .standing = 0, .part = 0, .parts = 1};
    on_device(s.device, "choosing candidates", [&] {
        s.weigh_lights(s.offered, first, count, selection);
        s.pooled.reserve(s.device, std::size_t(count) * s.lanes() * sizeof(std::uint32_t)), s.drawn.reserve(s.device, drawn.size() * sizeof(LightChoice));
        const std::uint32_t nothing = 0;
        s.pooled_total.upload(s.device, std::as_bytes(std::span(&nothing, 1)));
        cl_uint i = 0;
        s.pool.setArg(i++, s.ticks.get()), s.pool.setArg(i++, eye_alignment), s.pool.setArg(i++, count), s.pool.setArg(i++, s.pooled.get()), s.pool.setArg(i++, s.pooled_total.get());
        s.launch(Timed::select, s.pool, divided_up(count, pooled_lights));
        s.draw_lights({&region, 1}, s.offered, count, selection.slots, s.pooled, s.pooled_total, s.drawn);
        s.device.queue.enqueueReadBuffer(s.drawn.get(), CL_TRUE, 0, drawn.size() * sizeof(LightChoice), drawn.data());
    });
    for (LightChoice& choice : drawn) choice.light += first;
    return drawn;
}

std::vector<LightChoice> PairStage::chosen() const
{
    State& s = *state_;
    std::vector<LightChoice> choices(std::size_t(s.eye_count) / eye_alignment * s.slot_count);
    if (!choices.empty())
        on_device(s.device, "reading chosen lights", [&] { s.device.queue.enqueueReadBuffer(s.choices.get(), CL_TRUE, 0, choices.size() * sizeof(LightChoice), choices.data()); });
    return choices;
}

}  // namespace tyndall
