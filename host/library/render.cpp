/// api::render and api::devices.
#include <fmt/format.h>

#include "cli/version.hpp"
#include "device/device_list.hpp"
#include "library/api_state.hpp"
#include "pipeline/explain.hpp"
#include "pipeline/render.hpp"
#include "report/report_output.hpp"

namespace tyndall::api {
namespace {

void log_all(const RenderOptions& options, LogLevel level, const std::vector<std::string>& sentences)
{
    if (options.log)
        for (const std::string& sentence : sentences) options.log(level, sentence);
}

/// Host and device share one memory on a CPU, so each alone and both together are bounded.
void refuse_too_large(const tyndall::Scene& scene, const RenderSettings& settings, std::uint64_t most)
{
    if (most == 0) return;
    std::uint64_t bytes = 0;
    std::string largest;
    std::uint64_t largest_bytes = 0;
    for (const MemoryReport& part : explain(scene, settings).memory) {
        bytes += part.bytes;
        if (part.bytes > largest_bytes) largest = part.what, largest_bytes = part.bytes;
    }
    if (bytes > most)
        throw ResourceError(fmt::format("the render takes about {} bytes on host and device, more than the {} allowed; most of them for {} ({}): render a smaller film or fewer layers, or take fewer lights",
                                        bytes, most, largest, largest_bytes));
}

std::vector<float> floats(const std::vector<Rgb>& colours)
{
    std::vector<float> all;
    all.reserve(3 * colours.size());
    for (const Rgb& c : colours)
        for (int k = 0; k < 3; ++k) all.push_back(static_cast<float>(c[k]));
    return all;
}

Image image_of(RenderState&& render)
{
    auto state = std::make_unique<Image::State>();
    const Film& film = render.films.at(0);
    Report& report = render.report;
    report.ledger.not_finite_pixels = film.not_finite().count;
    for (const NotFinitePixel& pixel : film.not_finite().first_cases)
        report.ledger.first_cases.push_back(fmt::format("pass {}, layer {}, pixel ({}, {}) was not finite", pixel.pass, name(pixel.layer), pixel.x, pixel.y));
    state->beauty = floats(film.beauty()), state->variance = floats(film.variance_of_mean());
    for (std::size_t l = 0; l < layer_count; ++l)
        if (film.has(static_cast<Layer>(l))) state->layers[l] = floats(film.mean(static_cast<Layer>(l)));
    state->error = report.error, state->report = to_json(report);
    state->render = std::move(render);
    return Image(std::move(state));
}

}  // namespace

std::string version() { return tyndall::version(); }

std::vector<DeviceDescription> devices()
{
    std::vector<DeviceDescription> all;
    for (const DeviceInfo& d : list_devices())
        all.push_back({.index = d.index, .platform = d.platform, .name = d.name, .usable = d.usable, .why_not = d.why_not, .bytes = d.global_memory});
    return all;
}

namespace {

Image rendered(const Scene& scene, RenderSettings settings, const RenderOptions& options)
{
    if (settings.passes == 0 && settings.seconds == 0 && settings.target_error == 0) settings.passes = 16;  // the command line's default
    const tyndall::Scene& internal = scene.state().scene;
    refuse_too_large(internal, settings, options.max_bytes);
    log_all(options, LogLevel::warning, internal.warnings);
    RenderControl control{.program = tyndall::version()};
    control.progress = [&](const tyndall::Progress& p, const RenderState& state) {
        const Preview::State film{state.films.at(0)};
        const Progress progress{.passes_done = p.passes_done, .passes_wanted = p.passes_wanted, .seconds = p.seconds, .seconds_left = p.seconds_left, .error = p.error};
        return !options.progress || options.progress(progress, Preview(film));
    };
    RenderState state = render_state(internal, settings, std::move(control));
    for (const std::string& warning : state.report.warnings)
        if (std::find(internal.warnings.begin(), internal.warnings.end(), warning) == internal.warnings.end()) log_all(options, LogLevel::warning, {warning});
    log_all(options, LogLevel::info, {fmt::format("{} passes of {} in {:.2f} s, ended by: {}", state.report.passes, internal.file, state.report.seconds, state.report.stopped_by)});
    return image_of(std::move(state));
}

}  // namespace

Image render(const Scene& scene, const RenderSettings& settings, const RenderOptions& options)
try {
    return rendered(scene, settings, options);
} catch (const Error& error) {
    log_all(options, LogLevel::error, {error.what()});
    throw;
}

}  // namespace tyndall::api
