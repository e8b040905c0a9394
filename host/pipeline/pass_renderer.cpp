#include "pipeline/pass_renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <numeric>

#include "lights/progressive_radius.hpp"
#include "path_tracing/path_tracing.hpp"
#include "path_tracing/single_scattering.hpp"
#include "pipeline/explain.hpp"
#include "pipeline/media_tables.hpp"
#include "pipeline/memory_estimate.hpp"
#include "pipeline/savings.hpp"
#include "report/report_bytes.hpp"
#include "selftest/first_use.hpp"
#include "transport/random_sequence.hpp"
#include "tyndall/error.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

std::uint32_t vertex_limit(int max_depth) { return max_depth < 0 ? 0xffffffffu : static_cast<std::uint32_t>(std::max(max_depth - 1, 0)); }

int lanes_of(const RenderSettings& settings, const Device& device) { return settings.lanes ? settings.lanes : device.info().default_lanes; }

}  // namespace

template <typename Work>
auto StageClock::time(const std::string& stage, Work&& work)
{
    const auto start = std::chrono::steady_clock::now();
    struct AtEnd {
        StageClock& clock;
        const std::string& stage;
        std::chrono::steady_clock::time_point start;
        ~AtEnd() { clock.add(stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 1); }
    } at_end{*this, stage, start};
    return work();
}

void StageClock::add(const std::string& stage, double seconds, std::uint64_t count)
{
    auto found = std::find_if(stages_.begin(), stages_.end(), [&](const StageTime& s) { return s.stage == stage; });
    if (found == stages_.end()) found = stages_.insert(found, StageTime{stage});
    found->seconds += seconds, found->count += count;
}

PassRenderer::PassRenderer(const Scene& scene, const RenderSettings& settings, const std::optional<BuildMasks>& unchecked)
    : scene_(scene),
      settings_(settings),
      max_depth_(settings.max_depth.value_or(scene.max_depth)),
      features_(features_for(scene, settings)),
      plan_(plan_layers(scene, features_, settings)),
      masks_(unchecked ? *unchecked : build_masks(features_, plan_, settings.features)),
      visibility_(scene, settings.threads)
{
    if (plan_.on_device()) prepare_lights();
}

void PassRenderer::prepare_lights()
{
    if (settings_.opencl) devices_.emplace_back(*settings_.opencl);
    else
        for (const DeviceInfo& info : choose_devices(settings_.device)) devices_.emplace_back(std::to_string(info.index));
    for (Device& device : devices_) {
        device.bound_launches(settings_.launch_seconds), device.dump_kernels(settings_.dump_kernels);
        if (settings_.precision == Precision::f64 && !device.info().fp64)
            throw NoDeviceError("\"" + device.info().name + "\" has no 64-bit numbers (cl_khr_fp64), which --precision f64 needs; name another device, or leave it at f32");
    }
    const auto start = std::chrono::steady_clock::now();
    auto selftest = std::async(std::launch::async, [&] { return check_devices(); });
    std::vector<std::future<std::unique_ptr<EyeConnector>>> built;
    for (const Layer layer : connected_layers(plan_)) {
        connections_.push_back({layer});
        built.push_back(std::async(std::launch::async, [&, layer] { return make_connector(layer); }));
    }
    for (const GatherPlan& gather : plan_.gathers) gathers_.push_back(make_gathering(gather));
    clock_.time("pilot", [&] {
        if (plan_.lights_in_media()) light_paths_ = count_paths(*plan_.technique, plan_.selection.lights, LayerSet::all());
        if (plan_.lights_on_surfaces()) surface_light_paths_ = count_paths(*plan_.on_surfaces, plan_.selection.lights, LayerSet::all());
        for (Gathering& g : gathers_) g.paths = count_paths(*g.plan.technique, g.plan.lights, g.plan.layers);
    });
    for (std::size_t i = 0; i < built.size(); ++i) connections_[i].connector = built[i].get();
    selftest_ = selftest.get();
    clock_.add("build_kernels", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), programs_built());
}

/// All but the pass, its paths and its radius.
LightTracingSettings PassRenderer::light_settings(const LightTechnique& technique) const
{
    return {.seed = settings_.seed, .max_depth = max_depth_, .light_segments = settings_.light_segments, .segment_length = settings_.segment_length,
            .even = settings_.emission != Sequence::random, .vertices_to_come = technique.gathered() ? 1 : 2, .stop = settings_.stop};
}

std::uint64_t PassRenderer::count_paths(const LightTechnique& technique, std::uint32_t lights, const LayerSet& layers) const
{
    return paths_for(scene_, visibility_, technique, light_settings(technique), lights, layers);
}

/// What the first device's check said, with the warnings of all.
SelftestReport PassRenderer::check_devices()
{
    if (!settings_.selftest) return {.outcome = "skipped"};
    const int lanes = lanes_of(settings_, devices_.front());
    SelftestReport all;
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        const SelftestReport report = check_on_first_use({.device = devices_[i].info(), .lanes = lanes, .families = case_families(plan_, settings_, masks_)});
        if (i == 0) all = report;
        else if (all.warning.empty()) all.warning = report.warning;
    }
    return all;
}

std::uint64_t PassRenderer::programs_built() const
{
    return std::accumulate(devices_.begin(), devices_.end(), std::uint64_t(0), [](std::uint64_t sum, const Device& d) { return sum + d.programs_built(); });
}

std::unique_ptr<EyeConnector> PassRenderer::make_connector(Layer layer)
{
    const int lanes = lanes_of(settings_, devices_.front());
    const PairProgram program = pair_program(plan_, settings_, layer, masks_, lanes);
    const ConnectSettings connect{.features = program.features, .samples = program.samples, .vertex_limit = vertex_limit(max_depth_), .tile_pairs = settings_.tile_pairs, .lanes = lanes, .sums_of_eye = program.sums_of_eye(), .stop = settings_.stop};
    std::vector<PairStage> stages;
    for (Device& device : devices_) stages.emplace_back(device, program, media_tables(scene_, features_));
    return std::make_unique<EyeConnector>(std::move(stages), connect, plan_.selection, scene_.camera.crop_width);
}

PassRenderer::Gathering PassRenderer::make_gathering(const GatherPlan& gather)
{
    const PairProgram program = gather_program(gather, settings_, masks_, lanes_of(settings_, devices_.front()));
    const ConnectSettings connect{.features = program.features, .vertex_limit = vertex_limit(max_depth_), .tile_pairs = settings_.tile_pairs, .lanes = program.lanes, .stop = settings_.stop};
    std::vector<PairStage> stages;
    for (Device& device : devices_) stages.emplace_back(device, program, media_tables(scene_, features_));
    return {gather, std::make_unique<GatherConnector>(std::move(stages), connect, *gather.technique, plan_.selection.camera_samples)};
}

void PassRenderer::add_gathered(std::uint64_t pass, const EyeRecords& eyes, PassImage& image)
{
    for (Gathering& g : gathers_) {
        const LightTechnique& technique = *g.plan.technique;
        LightTracingSettings wanted = light_settings(technique);
        wanted.pass = pass, wanted.paths = g.paths, wanted.radius = progressive_radius(g.plan.radius, pass, technique.blur_dimensions);
        const std::vector<GatheredLights> all = clock_.time("trace_lights", [&] { return trace_gathered_lights(scene_, visibility_, technique, wanted, g.plan.layers); });
        for (const GatheredLights& lights : all) {
            virtual_lights_ += lights.lights.count;
            clock_.time(std::string(name(lights.layer)), [&] { g.connector->gather(eyes, lights.lights, visibility_, counts_, image[lights.layer]); });
        }
    }
}

void PassRenderer::add_virtual_lights(std::uint64_t pass, const EyeRecords& eyes, PassImage& image)
{
    const auto traced = [&](const LightTechnique& technique, std::uint64_t paths) {
        return clock_.time("trace_lights", [&] {
            LightTracingSettings wanted = light_settings(technique);
            wanted.pass = pass, wanted.paths = paths, wanted.radius = progressive_radius(plan_.radius, pass);
            return trace_lights(scene_, visibility_, technique, wanted);
        });
    };
    if (plan_.lights_in_media()) connect(traced(*plan_.technique, light_paths_), pass, {Layer::media_to_media, Layer::media_to_surface}, eyes, image);
    if (plan_.lights_on_surfaces()) connect(traced(*plan_.on_surfaces, surface_light_paths_), pass, {Layer::surface_to_media, Layer::surface_indirect}, eyes, image);
}

/// Adds what `lights` send to those of the layers that are connected.
void PassRenderer::connect(const VirtualLights& lights, std::uint64_t pass, std::initializer_list<Layer> layers, const EyeRecords& eyes, PassImage& image)
{
    virtual_lights_ += lights.count;
    const std::uint64_t key = mix_bits(mix_bits(settings_.seed) + pass);
    for (const Connection& c : connections_) {
        if (std::find(layers.begin(), layers.end(), c.layer) == layers.end()) continue;
        clock_.time(std::string(name(c.layer)), [&] { c.connector->connect(eyes, eyes_of(c.layer), lights, visibility_, key, counts_, image[c.layer]); });
        note_worst_pair(c.connector->worst(), pass, c.layer, image);
    }
}

void PassRenderer::note_worst_pair(const EyeConnector::Worst& worst, std::uint64_t pass, Layer layer, PassImage& image)
{
    const double radiance = worst.radiance / 3;
    if (!(radiance > worst_pair_.radiance)) return;
    const int width = scene_.camera.crop_width, pixel = static_cast<int>(worst.pixel);
    worst_pair_ = {std::string(name(layer)), pass, pixel % width, pixel / width, radiance, worst.radiance / sum(image[layer][worst.pixel])};
}

void PassRenderer::add_host_layers(std::uint64_t pass, PassImage& image)
{
    const PathTracingSettings settings{.seed = settings_.seed, .pass = pass, .max_depth = max_depth_, .layers = plan_.path_traced, .glossy_only = plan_.glossy_by_paths, .glossy_lights = plan_.glossy_lights_by_paths, .stop = settings_.stop};
    if (!plan_.path_traced.empty()) clock_.time("trace_paths", [&] { trace_paths(scene_, visibility_, settings, image); });
    if (plan_.single) clock_.time("single", [&] { trace_single(scene_, visibility_, settings, image); });
}

PassResult PassRenderer::render(std::uint64_t pass)
{
    PassResult result{PassImage(scene_.camera.crop_width, scene_.camera.crop_height, plan_.rendered()), {}};
    const EyeTracingSettings wanted{.seed = settings_.seed, .pass = pass, .samples = plan_.on_device() ? plan_.selection.camera_samples : 1, .max_depth = max_depth_,
                                   .vertices_to_come = plan_.gathers.empty() ? 2 : 1, .segments = plan_.connects_segments() || plan_.gathers_at(Reach::near_segments),
                                   .points = plan_.connects_points() || plan_.gathers_at(Reach::near_points), .stop = settings_.stop};
    EyeRecords eyes = clock_.time("trace_eyes", [&] { return trace_eyes(scene_, visibility_, wanted); });
    if (plan_.on_device()) eye_segments_ += eyes.segments.size(), eye_points_ += eyes.points.size();
    add_virtual_lights(pass, eyes, result.image);
    add_gathered(pass, eyes, result.image);
    add_host_layers(pass, result.image);
    result.features = std::move(eyes.features);
    return result;
}

void PassRenderer::add_savings(Report& report) const
{
    const double passes = std::max(report.passes, 1), samples = settings_.samples_per_pair;
    const double lights = plan_.selection.chosen ? plan_.selection.slots_per_sample() : static_cast<double>(virtual_lights_) / passes;
    const PairCounts pairs{.to_segments = static_cast<double>(eye_segments_) * lights * samples, .to_points = static_cast<double>(eye_points_) * lights * samples,
                           .pixels = double(scene_.camera.crop_width) * scene_.camera.crop_height * passes,
                           .lights_per_pass = plan_.technique ? plan_.selection.slots : 0.};
    report.savings = savings_of(features_, plan_, masks_, pairs);
}

const EyeConnector* PassRenderer::connector_of(std::string_view layer) const
{
    for (const Connection& c : connections_)
        if (name(c.layer) == layer) return c.connector.get();
    return nullptr;
}

void PassRenderer::add_bias(Report& report) const
{
    for (LayerReport& layer : report.layers) {
        if (layer.bias.empty()) continue;
        const EyeConnector* connector = connector_of(layer.layer);
        const auto gathered = std::find_if(plan_.gathers.begin(), plan_.gathers.end(), [&](const GatherPlan& g) { return g.layers.contains(static_cast<Layer>(&layer - report.layers.data())); });
        const int dimensions = gathered == plan_.gathers.end() ? 1 : gathered->technique->blur_dimensions;
        const bool thick = gathered != plan_.gathers.end() || plan_.technique->is_thick;
        if (connector && gathered == plan_.gathers.end()) layer.removed = connector->removed_share(), layer.kept_light = connector->kept_light(), layer.removed_light = connector->removed_light();
        if (thick && report.passes > 0)
            layer.bias += fmt::format("; in the last of {} it was {:.3g} times as wide", report.passes, progressive_radius(1, static_cast<std::uint64_t>(report.passes - 1), dimensions));
    }
}

void PassRenderer::fill(Report& report) const
{
    report.layers = plan_.reports;
    add_bias(report);
    report.max_depth = max_depth_;
    const std::uint64_t paths = std::accumulate(gathers_.begin(), gathers_.end(), light_paths_ + surface_light_paths_, [](std::uint64_t sum, const Gathering& g) { return sum + g.paths; });
    report.light_paths = paths * static_cast<std::uint64_t>(report.passes), report.virtual_lights = virtual_lights_;
    report.eye_segments = eye_segments_, report.eye_points = eye_points_;
    report.pairs = counts_.pairs, report.shadow_segments = counts_.shadow_segments;
    report.stages = clock_.stages();
    report.ledger.worst_pair = worst_pair_;
    report.ledger.runaway_walks = visibility_.runaway_walks();
    report.ledger.unsafe_shadow_segments = visibility_.invalid_rays();
    report.effects = effect_reports(features_);
    if (plan_.virtual_lights()) report.selection = to_text(plan_.selection);
    report.grids = grid_transmittance(settings_, plan_, masks_);
    add_savings(report);
    if (!devices_.empty()) add_devices(report);
    if (counts_.shadow_segments) report.stages.push_back({"shadow_segments", counts_.visibility_seconds, counts_.shadow_segments});
    add_counts(report, earlier_);
}

void PassRenderer::add_devices(Report& report) const
{
    report.programs = programs_built(), report.wall_clock = std::any_of(devices_.begin(), devices_.end(), [](const Device& d) { return !d.time_stamps(); });
    report.selftest = selftest_;
    if (const auto doubt = doubt_about_math(settings_); plan_.virtual_lights() && !doubt.empty()) report.warnings.push_back(doubt);
    if (selftest_ && !selftest_->warning.empty()) report.warnings.push_back(selftest_->warning);
    for (const Device& d : devices_) {
        report.device += (report.device.empty() ? "" : "; ") + d.info().platform + ": " + d.info().name;
        report.driver += (report.driver.empty() ? "" : "; ") + d.info().driver;
    }
    for (const Connection& c : connections_) add_connector(*c.connector, std::string(name(c.layer)), report);
    for (const Gathering& g : gathers_) add_connector(*g.connector, std::string(g.plan.technique->title), report);
}

/// Times are sums over devices.
template <typename Connector>
void PassRenderer::add_connector(const Connector& connector, const std::string& layer, Report& report) const
{
    PairTimings all;
    for (std::string& warning : connector.warnings()) report.warnings.push_back(std::move(warning));
    for (const PairStage* stage : connector.stages()) {
        const PairTimings t = stage->timings();
        all.gather += t.gather, all.sample += t.sample, all.accumulate += t.accumulate, all.tabulate += t.tabulate, all.select += t.select, all.launches += t.launches;
        report.largest_launch_seconds = std::max(report.largest_launch_seconds, t.largest_launch);
        const PairLedger ledger = stage->ledger();
        report.ledger.not_finite_pairs += ledger.not_finite, report.ledger.floored_pairs += ledger.floored;
        if (ledger.not_finite)
            report.ledger.first_cases.push_back(layer + ": eye " + std::to_string(ledger.first_eye) + ", light sample " + std::to_string(ledger.first_counter));
    }
    report.lanes = connector.settings().lanes, report.lanes_from = lanes_from(settings_), report.launches += all.launches;
    report.build_options += (report.build_options.empty() ? "" : "; ") + layer + ": " + connector.stages().front()->options();
    for (const auto& [stage, seconds] : {std::pair("gather_lights", all.gather), std::pair("sample_pairs", all.sample), std::pair("accumulate_pairs", all.accumulate),
                                        std::pair("tabulate_grids", all.tabulate), std::pair("select_lights", all.select)})
        if (seconds > 0) report.stages.push_back({layer + "." + stage, seconds, all.launches});
}

}  // namespace tyndall
