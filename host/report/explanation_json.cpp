#include <cmath>
#include <nlohmann/json.hpp>

#include "report/explanation.hpp"

namespace tyndall {
namespace {

using Json = nlohmann::ordered_json;

/// Null for what is not known.
Json known(double value) { return std::isfinite(value) && value >= 0 ? Json(value) : Json(nullptr); }

Json effects_of(const Explanation& e)
{
    Json list = Json::array();
    for (const EffectReport& effect : e.effects)
        list.push_back({{"effect", effect.effect}, {"found", effect.found}, {"cause", effect.cause.empty() ? Json(nullptr) : Json(effect.cause)}});
    return list;
}

Json layers_of(const Explanation& e)
{
    Json list = Json::array();
    for (const LayerReport& layer : e.layers)
        list.push_back({{"layer", layer.layer}, {"technique", layer.technique}, {"skipped", layer.skipped}, {"why", layer.why}, {"unbiased", layer.unbiased}, {"bias", layer.bias},
                        {"sampler", layer.sampler}, {"sampler_why", layer.sampler_why}});
    return list;
}

Json kernels_of(const Explanation& e)
{
    Json list = Json::array();
    for (const KernelReport& kernel : e.kernels)
        list.push_back({{"layer", kernel.layer}, {"kernel", kernel.kernel}, {"features", kernel.features}, {"options", kernel.options}});
    return list;
}

Json memory_of(const Explanation& e)
{
    Json list = Json::array();
    for (const MemoryReport& memory : e.memory) list.push_back({{"what", memory.what}, {"bytes", memory.bytes}, {"on_device", memory.on_device}});
    return list;
}

Json savings_of(const Explanation& e)
{
    Json list = Json::array();
    for (const SavingReport& saving : e.savings)
        list.push_back({{"what", saving.what}, {"because", saving.because}, {"predicted_processor_seconds_per_pass", known(saving.predicted_seconds)}});
    return list;
}

Json calibration_of(const Explanation& e)
{
    if (!e.calibration) return nullptr;
    const Calibration& c = *e.calibration;
    return {{"passes", c.passes},
            {"film_share", c.film_share},
            {"before_seconds", known(c.before_seconds)},
            {"first_pass_seconds", known(c.first_pass_seconds)},
            {"pass_seconds", known(c.pass_seconds)},
            {"error_of_one_pass", known(c.error)},
            {"seconds_to_one_percent", known(c.seconds_to_one_percent)}};
}

}  // namespace

std::string to_json(const Explanation& e)
{
    Json json;
    json["schema"] = explanation_schema;
    json["scene"] = e.scene;
    json["method"] = e.method;
    json["device"] = e.device.empty() ? Json(nullptr) : Json(e.device);
    json["lanes"] = e.lanes, json["lanes_from"] = e.lanes_from;
    json["width"] = e.width, json["height"] = e.height;
    json["passes"] = e.passes ? Json(e.passes) : Json(nullptr);
    json["seconds"] = e.seconds > 0 ? Json(e.seconds) : Json(nullptr);
    json["lights"] = e.lights;
    json["effects"] = effects_of(e);
    json["layers"] = layers_of(e);
    json["kernels"] = kernels_of(e);
    json["chosen_lights"] = e.selection.empty() ? Json(nullptr) : Json(e.selection);
    json["density_grids"] = e.grids.empty() ? Json(nullptr) : Json(e.grids);
    json["memory"] = memory_of(e);
    json["savings"] = savings_of(e);
    json["calibration"] = calibration_of(e);
    json["why_no_calibration"] = e.why_no_calibration.empty() ? Json(nullptr) : Json(e.why_no_calibration);
    json["warnings"] = e.warnings;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tyndall
