#include "comparison/stage_costs.hpp"

#include <algorithm>

namespace tyndall {
namespace {

bool is_one_of(const std::string& stage, std::initializer_list<const char*> names)
{
    return std::ranges::any_of(names, [&](const char* name) { return stage == name; });
}

}  // namespace

std::vector<StageCost> stage_costs(const Report& report)
{
    double trace = 0, sample = 0, shadow = 0, accumulate = 0, connect = 0;
    for (const StageTime& stage : report.stages) {
        const std::string part = stage.stage.substr(stage.stage.find('.') + 1);
        if (is_one_of(stage.stage, {"trace_lights", "trace_eyes", "trace_paths", "single"})) trace += stage.seconds;
        else if (is_one_of(stage.stage, {"media_to_media", "media_to_surface", "surface_to_media", "surface_indirect"})) connect += stage.seconds;
        else if (stage.stage == "shadow_segments") shadow += stage.seconds;
        else if (part == "accumulate_pairs") accumulate += stage.seconds;
        else if (part != stage.stage) sample += stage.seconds;
    }
    const double transfer = std::max(connect - sample - shadow - accumulate, 0.);
    const double rest = std::max(report.seconds - report.before_seconds - trace - std::max(connect, sample + shadow + accumulate), 0.);
    return {{"prepare", report.before_seconds}, {"trace", trace}, {"sample", sample}, {"shadow", shadow}, {"accumulate", accumulate}, {"transfer", transfer}, {"rest", rest}};
}

}  // namespace tyndall
