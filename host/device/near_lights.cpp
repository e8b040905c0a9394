/// Density estimation on the device.
#include <stdexcept>

#include "device/pair_stage_state.hpp"

namespace tyndall {

void PairStage::gather_near(std::span<const std::uint32_t> starts, std::span<const std::uint32_t> near)
{
    State& s = *state_;
    if (starts.size() != s.eye_count / eye_alignment + 1) throw std::logic_error("every 16 eyes have a start, and the last an end");
    s.near_starts.upload(s.device, std::as_bytes(starts));
    s.near_lights.upload(s.device, std::as_bytes(near));
    const double work = std::max(double(near.size()) / std::max<double>(groups(), 1) * eye_alignment, 1.);  // pairs of a group of lanes, in the mean
    std::uint32_t piece = 0;
    for (std::uint32_t done = 0; done < groups() && !near.empty(); done += piece) {
        on_device(s.device, "adding what lights leave near eyes", [&] {
            s.harvest(false);
            if (s.launched.size() > 1) s.launched[s.launched.size() - 2].event.wait();
            const bool known = s.budget.knows("gather");
            piece = s.budget.items("gather", groups() - done, work);
            cl_uint i = 0;
            s.gather.setArg(i++, s.eyes.get()), s.gather.setArg(i++, done), s.gather.setArg(i++, piece), s.gather.setArg(i++, s.lights.records.get()), s.gather.setArg(i++, s.vertex_limit);
            i = s.set_surroundings(s.gather, i);
            s.gather.setArg(i++, s.eye_tables.get()), s.gather.setArg(i++, s.lights.tables.get());
            s.gather.setArg(i++, s.near_starts.get()), s.gather.setArg(i++, s.near_lights.get()), s.gather.setArg(i++, s.sums.get()), s.gather.setArg(i++, s.ledger.get());
            s.gather.setArg(i++, s.worst.get()), s.gather.setArg(i++, s.worst_counters.get());
            s.launch(Timed::gather, s.gather, piece, work);
            s.device.queue.flush();
            if (!known || !s.device.time_stamps) s.wait_and_count();
        });
    }
}

}  // namespace tyndall
