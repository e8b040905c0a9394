#include "pipeline/region_lights.hpp"

#include "transport/random_sequence.hpp"

namespace tyndall {

RegionLights::RegionLights(PairStage& stage, const VirtualLights& lights, const SelectionPlan& plan, std::uint32_t vertex_limit, std::uint64_t key)
    : stage_(stage), lights_(lights), plan_(plan), key_(mix_bits(key)), wanted_(plan.candidates > 0 && lights.count / 2 > plan.candidates)
{
    if (wanted_) stage_.offer(lights.records, vertex_limit);
}

LightBatch RegionLights::choose(std::span<const std::byte> standing)
{
    const std::uint64_t random = mix_bits(key_ + ++regions_);
    const std::uint32_t parts = (lights_.count + plan_.offered - 1) / plan_.offered, part = static_cast<std::uint32_t>(random >> 32) % parts;
    const auto start = [&](std::uint64_t p) { return static_cast<std::uint32_t>(p * lights_.count / parts); };
    const LightSelection selection{.standing = standing, .standing_count = eye_alignment, .blocks = {}, .slots = plan_.candidates, .defence = static_cast<float>(plan_.defence)};
    const std::vector<LightChoice> drawn = stage_.candidates(selection, start(part), start(part + 1) - start(part), static_cast<std::uint32_t>(random));
    const std::size_t bytes = lights_.records.size() / lights_.count;
    records_.clear(), weights_.clear();
    for (std::size_t i = 0, next = 0; i < drawn.size(); i = next) {
        float weight = 0;
        for (next = i; next < drawn.size() && drawn[next].light == drawn[i].light; ++next) weight += drawn[next].weight;
        if (!(weight > 0)) continue;                                        // no light is allowed
        const auto record = lights_.records.begin() + static_cast<std::ptrdiff_t>(drawn[i].light * bytes);
        records_.insert(records_.end(), record, record + static_cast<std::ptrdiff_t>(bytes));
        weights_.push_back(weight * static_cast<float>(parts));
    }
    return {records_, static_cast<std::uint32_t>(weights_.size()), weights_};
}

}  // namespace tyndall
