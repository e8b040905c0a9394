/// Choosing lights for blocks of eyes, on the device.
#include <stdexcept>

#include "device/pair_stage_state.hpp"

namespace tyndall {

void PairStage::select(const LightSelection& selection)
{
    State& s = *state_;
    const std::uint32_t lanes = s.lanes(), standing = selection.standing_count, blocks = static_cast<std::uint32_t>(selection.blocks.size());
    if (standing % eye_alignment != 0) throw std::logic_error("standing eyes are padded to a multiple of 16");
    if (!s.program.selection) throw std::logic_error("this program connects to all lights");
    if (s.light_count == 0 || selection.blocks.empty()) return;
    s.slot_count = selection.slots;
    const std::size_t estimates = std::size_t(standing) * s.light_count;
    s.standing.upload(s.device, selection.standing), s.blocks.upload(s.device, std::as_bytes(selection.blocks));
    s.estimates.reserve(s.device, estimates * sizeof(float)), s.ticks.reserve(s.device, estimates * sizeof(std::uint32_t));
    s.powers.reserve(s.device, s.light_count * sizeof(float)), s.totals.reserve(s.device, standing * sizeof(std::uint32_t));
    s.choices.reserve(s.device, std::size_t(s.eye_count) / eye_alignment * selection.slots * sizeof(LightChoice));
    on_device(s.device, "choosing lights", [&] {
        cl_uint i = 0;
        s.estimate.setArg(i++, s.standing.get()), s.estimate.setArg(i++, standing / lanes);
        s.estimate.setArg(i++, s.lights.get()), s.estimate.setArg(i++, s.light_count), s.estimate.setArg(i++, s.vertex_limit);
        i = s.set_surroundings(s.estimate, i);
        s.estimate.setArg(i++, s.eye_tables.get()), s.estimate.setArg(i++, s.light_tables.get());
        s.estimate.setArg(i++, s.estimates.get()), s.estimate.setArg(i++, s.powers.get());
        s.launch(Timed::select, s.estimate, standing / lanes * ((s.light_count + light_block - 1) / light_block));
        i = 0;
        s.weigh.setArg(i++, standing / lanes), s.weigh.setArg(i++, s.light_count), s.weigh.setArg(i++, selection.defence);
        s.weigh.setArg(i++, s.estimates.get()), s.weigh.setArg(i++, s.powers.get()), s.weigh.setArg(i++, s.ticks.get()), s.weigh.setArg(i++, s.totals.get());
        s.launch(Timed::select, s.weigh, standing / lanes);
        i = 0;
        s.select.setArg(i++, s.blocks.get()), s.select.setArg(i++, blocks), s.select.setArg(i++, s.light_count), s.select.setArg(i++, selection.slots);
        s.select.setArg(i++, s.ticks.get()), s.select.setArg(i++, s.totals.get()), s.select.setArg(i++, s.choices.get());
        s.launch(Timed::select, s.select, blocks);
    });
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
