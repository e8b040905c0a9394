#include "pipeline/light_selection_plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/light_budget.hpp"

namespace tyndall {
namespace {

constexpr std::uint32_t usual_lights = 2048, usual_slots = 64, usual_candidates = 4096;
constexpr std::uint32_t fewest_lights = 512;  ///< to choose from: of fewer the estimates cost more than they save

void decide(const RenderSettings& settings, SelectionPlan& plan)
{
    plan.chosen = settings.selection == Selection::tile;
    if (settings.selection != Selection::automatic) plan.why = "asked for";
    else if (settings.lights > 0) {
        plan.chosen = settings.lights >= fewest_lights;
        plan.why = fmt::format("{} lights per pass, choosing pays from {} on", settings.lights, fewest_lights);
    } else plan.chosen = true, plan.why = "wins at equal time";
}

}  // namespace

SelectionPlan plan_selection(const RenderSettings& settings, const Camera& camera)
{
    SelectionPlan plan;
    decide(settings, plan);
    plan.camera_samples = settings.camera_samples > 0 ? settings.camera_samples : 1;
    plan.lights = settings.lights ? settings.lights : plan.chosen ? usual_lights : default_lights(camera, settings.seconds);
    const std::uint32_t wanted = settings.selected_lights ? settings.selected_lights : usual_slots, samples = static_cast<std::uint32_t>(plan.camera_samples);
    plan.slots = plan.chosen ? std::max((wanted + samples / 2) / samples, 1u) * samples : plan.lights * samples;
    if (settings.selection_block > 0) plan.block = settings.selection_block;
    plan.candidates = !plan.chosen || settings.candidates == all_lights ? 0 : settings.candidates > 0 ? settings.candidates : usual_candidates;
    if (settings.selection_defence >= 0) plan.defence = settings.selection_defence;
    return plan;
}

RenderSettings with_plan(RenderSettings settings, const SelectionPlan& plan)
{
    settings.lights = plan.lights, settings.selection = plan.chosen ? Selection::tile : Selection::all;
    return settings;
}

std::string to_text(const SelectionPlan& plan)
{
    const std::string samples = plan.camera_samples > 1 ? fmt::format(", in {} camera samples", plan.camera_samples) : "";
    if (!plan.chosen) return fmt::format("all {} per pixel{}: {}", plan.lights, samples, plan.why);
    const std::string first = plan.by_region() ? fmt::format(" among {} per region", plan.candidates) : "";
    return fmt::format("{} of {} per pixel{}, by an estimate per {} x {} pixels{} and {:g} % by power: {}", plan.slots, plan.lights, samples, plan.block, plan.block, first,
                       100 * plan.defence, plan.why);
}

}  // namespace tyndall
