/// What the bytes of a pass depend on, and counting on after an interruption.
#include <fmt/format.h>

#include "device/pair_stage.hpp"
#include "pipeline/pass_renderer.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

std::string names_of(const LayerSet& layers)
{
    std::string names;
    for (std::size_t l = 0; l < layer_count; ++l)
        if (layers.contains(static_cast<Layer>(l))) names += (names.empty() ? "" : " ") + std::string(layer_names[l]);
    return names;
}

/// All of it: a part that is missing here does not compile.
std::string text_of(const SelectionPlan& plan)
{
    [[maybe_unused]] const auto& [lights, chosen, slots, block, defence, candidates, offered, camera_samples, why] = plan;
    if (!chosen) return fmt::format("all {} in {} camera samples", lights, camera_samples);
    const std::string regions = plan.by_region() ? fmt::format(", from {} candidates of {}", candidates, offered) : "";
    return fmt::format("{} of {}{} in {} camera samples, per {} x {} pixels, {:.17g} by power", slots, lights, regions, camera_samples, block, block, defence);
}

}  // namespace

std::vector<StateSetting> PassRenderer::settings() const
{
    // Every setting has a name here, so that one which is added does not compile before it is decided whether bytes depend on it. Those that are left to a rule stand in the plan.
    [[maybe_unused]] const auto& [method, layers, path_layers, passes, seconds, target_error, lights, seed, threads, max_depth, light_segments, segment_length, sampler, sequence, emission, transmittance, precision, math, features,
                 device, opencl, lanes, lanes_calibrated, tile_pairs, launch_seconds, samples, selection, selected_lights, selection_block, candidates, defence, camera_samples, skip_thin, clamp, beam_radius, block_passes, dump_kernels, selftest, stop] = settings_;
    const Camera& camera = scene_.camera;
    std::vector<StateSetting> all{
        {"film", fmt::format("{} x {}, window {} x {} at ({}, {})", camera.width, camera.height, camera.crop_width, camera.crop_height, camera.crop_x, camera.crop_y)},
        {"seed", fmt::to_string(seed)},
        {"block of passes", fmt::to_string(block_passes)},
        {"method", std::string(name(method))},
        {"layers", names_of(plan_.rendered())},
        {"max depth", fmt::to_string(max_depth_)},
        {"light by paths", names_of(plan_.path_traced) + (plan_.single ? ", single by light" : "")},
    };
    if (!plan_.on_device()) return all;
    for (const Gathering& g : gathers_)
        all.push_back({std::string(g.plan.technique->title), fmt::format("{} of {} paths, {:.17g} thick, for {}", g.plan.lights, g.paths, g.plan.radius, names_of(g.plan.layers))});
    if (plan_.virtual_lights()) add_light_settings(all);
    all.insert(all.end(), {
        {"light segments", light_segments == LightSegments::all ? "all" : "first"},
        {"segment length", std::string(name_in(segment_length_names, segment_length))},
        {"emission", std::string(name_in(sequence_names, emission))},
        {"precision", std::string(name_in(precision_names, precision))},
        {"math", std::string(name_in(math_names, math))},
        {"features", fmt::format("{:x} {:x}", masks_.media_to_media, masks_.media_to_surface)},
        {"features of lights on surfaces", plan_.lights_on_surfaces() ? fmt::format("{:x} {:x}", masks_.surface_to_media, masks_.surface_indirect) : "none"},
    });
    add_device_settings(all);
    return all;
}

/// Of lights that eyes are connected to.
void PassRenderer::add_light_settings(std::vector<StateSetting>& all) const
{
    all.insert(all.end(), {
        {"virtual lights", std::string(plan_.technique->name) + (plan_.on_surfaces ? ", " + std::string(plan_.on_surfaces->name) : "")},
        {"bound of 1 / w^2", fmt::format("{:.17g}", plan_.clamp)},
        {"radius of the first pass", fmt::format("{:.17g}", plan_.radius)},
        {"lights", text_of(plan_.selection)},
        {"light paths", plan_.lights_on_surfaces() ? fmt::format("{} and {}", light_paths_, surface_light_paths_) : fmt::to_string(light_paths_)},
        {"samples", fmt::to_string(settings_.samples_per_pair)},
        {"sampler", fmt::to_string(plan_.sampler)},
        {"sequence", std::string(name_in(sequence_names, settings_.sequence))},
        {"transmittance", std::string(name_in(transmittance_names, settings_.transmittance))},
    });
}

const ConnectSettings* PassRenderer::connect_settings() const
{
    if (!connections_.empty()) return &connections_.front().connector->settings();
    return &gathers_.front().connector->settings();
}

/// What a machine brings with it.
void PassRenderer::add_device_settings(std::vector<StateSetting>& all) const
{
    all.push_back({"lanes", fmt::to_string(connect_settings()->lanes)});
    std::string names, drivers;
    for (const Device& device : devices_) {
        names += (names.empty() ? "" : "; ") + device.info().platform + ": " + device.info().name;
        drivers += (drivers.empty() ? "" : "; ") + device.info().driver;
    }
    all.push_back({"device", names}), all.push_back({"driver", drivers});
    for (const Connection& c : connections_) all.push_back({"kernels of " + std::string(name(c.layer)), c.connector->stages().front()->options()});
    for (const Gathering& g : gathers_) all.push_back({"kernels of " + std::string(g.plan.technique->title), g.connector->stages().front()->options()});
}

void PassRenderer::continue_from(const Report& earlier)
{
    virtual_lights_ = earlier.virtual_lights, eye_segments_ = earlier.eye_segments, eye_points_ = earlier.eye_points;
    counts_.pairs = earlier.pairs, counts_.shadow_segments = earlier.shadow_segments;
    worst_pair_ = earlier.ledger.worst_pair;
    earlier_ = earlier;
    earlier_.light_paths = earlier_.virtual_lights = earlier_.eye_segments = earlier_.eye_points = earlier_.pairs = earlier_.shadow_segments = 0;
    earlier_.seconds = earlier_.before_seconds = 0;
}

}  // namespace tyndall
