/// What choosing lights is worth: every shipped scene and layer with all lights and with chosen ones, in turns over eight seeds, as JSON on standard output.
///     selection [--seeds N] [--passes N] [--width PIXELS] [SCENE...]
/// relMSE of single pixels and of means over 8 x 8 pixels against a long run of its own seed, whose share is taken off; processor time per pass without the first.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "bench/measure.hpp"
#include "film/error_estimate.hpp"
#include "metrics/block_means.hpp"
#include "metrics/image_error.hpp"
#include "pipeline/render.hpp"
#include "scene/load_scene.hpp"

namespace tyndall::bench {
namespace {

constexpr int reference_passes = 256;
int width = 96;  ///< and height, of the images

struct Candidate {
    std::string name;
    RenderSettings settings;
};

/// relMSE of one pass and seconds of processor time for it.
struct Result {
    std::vector<double> pixels, trimmed, blocks, seconds;
};

Scene small_scene(const std::string& name)
{
    Scene scene = load_scene(std::string(TYNDALL_SOURCE_DIR) + "/scenes/" + name + "/scene.xml");
    scene.camera.width = scene.camera.height = scene.camera.crop_width = scene.camera.crop_height = width;
    scene.camera.crop_x = scene.camera.crop_y = 0;
    return scene;
}

void run(const Scene& scene, Layer layer, const RenderSettings& settings, const std::vector<Rgb>& reference, double of_reference, Result& result)
{
    double first = 0;
    const auto note = [&](const Progress& progress, const Film&) {
        if (progress.passes_done == 1) first = processor_seconds();
        return true;
    };
    const RenderOutcome outcome = render(scene, settings, note);
    result.seconds.push_back((processor_seconds() - first) / (settings.passes - 1));
    const std::vector<Rgb> image = outcome.film.mean(layer);
    const ImageError error = image_error(image, reference);
    result.pixels.push_back((error.relative_mse - of_reference) * settings.passes), result.trimmed.push_back(error.trimmed_relative_mse * settings.passes);
    result.blocks.push_back(blocks_relative_mse(image, reference, width) * settings.passes);
}

double mean(const std::vector<double>& x)
{
    double sum = 0;
    for (const double v : x) sum += v / double(x.size());
    return sum;
}

void print(const std::string& name, const Result& r, bool last)
{
    const double seconds = median(r.seconds);
    const auto efficiency = [&](const std::vector<double>& error) { return 1 / (std::max(mean(error), 1e-12) * seconds); };
    const auto [low, high] = std::minmax_element(r.pixels.begin(), r.pixels.end());
    fmt::print("      {{\"candidate\": \"{}\", \"relative_mse\": {:.6g}, \"lowest\": {:.6g}, \"highest\": {:.6g}, \"trimmed\": {:.6g}, \"blocks\": {:.6g}, \"seconds\": {:.6g}, "
               "\"efficiency\": {:.5g}, \"efficiency_trimmed\": {:.5g}, \"efficiency_blocks\": {:.5g}}}{}\n",
               name, mean(r.pixels), *low, *high, mean(r.trimmed), mean(r.blocks), seconds, efficiency(r.pixels), efficiency(r.trimmed), efficiency(r.blocks), last ? "" : ",");
}

void measure(const std::string& name, Layer layer, int seeds, int passes)
{
    const Scene scene = small_scene(name);
    const RenderSettings layer_alone{.layers = LayerSet().add(layer), .passes = passes};
    RenderSettings reference_settings = layer_alone;
    reference_settings.passes = reference_passes, reference_settings.seed = 999983;
    reference_settings.lights = 8192, reference_settings.selection = Selection::tile, reference_settings.selected_lights = 256;
    const RenderOutcome reference = render(scene, reference_settings, {});
    if (!reference.film.has(layer)) return fmt::print("    {{\"scene\": \"{}\", \"layer\": \"{}\", \"candidates\": []}}", name, tyndall::name(layer));
    const double of_reference = estimated_error(reference.film) * estimated_error(reference.film);
    std::vector<Candidate> candidates;
    for (const std::uint32_t lights : {128u, 512u, 2048u}) {
        candidates.push_back({fmt::format("all of {}", lights), layer_alone});
        candidates.back().settings.lights = lights, candidates.back().settings.selection = Selection::all;
    }
    candidates.push_back({"64 of 2048", layer_alone});
    std::vector<Result> results(candidates.size());
    for (int seed = 1; seed <= seeds; ++seed)
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            candidates[i].settings.seed = static_cast<std::uint64_t>(seed);
            run(scene, layer, candidates[i].settings, reference.film.mean(layer), of_reference, results[i]);
        }
    fmt::print("    {{\"scene\": \"{}\", \"layer\": \"{}\", \"reference_relative_mse\": {:.4g}, \"candidates\": [\n", name, tyndall::name(layer), of_reference);
    for (std::size_t i = 0; i < candidates.size(); ++i) print(candidates[i].name, results[i], i + 1 == candidates.size());
    fmt::print("    ]}}");
}

}  // namespace
}  // namespace tyndall::bench

int main(int argc, char** argv)
{
    int seeds = 8, passes = 16;
    std::vector<std::string> scenes;
    for (int i = 1; i < argc; ++i) {
        if (!std::strcmp(argv[i], "--seeds") && i + 1 < argc) seeds = std::stoi(argv[++i]);
        else if (!std::strcmp(argv[i], "--passes") && i + 1 < argc) passes = std::stoi(argv[++i]);
        else if (!std::strcmp(argv[i], "--width") && i + 1 < argc) tyndall::bench::width = std::stoi(argv[++i]);
        else scenes.push_back(argv[i]);
    }
    if (scenes.empty()) scenes = {"fruit_juice", "cornell_fog", "fog_and_slit", "glossy_medium", "backlit_smoke", "plume", "smoky_room"};
    fmt::print("{{\"pixels\": {0}, \"seeds\": {1}, \"passes\": {2}, \"measured\": [\n", tyndall::bench::width, seeds, passes);
    bool first = true;
    for (const std::string& scene : scenes)
        for (const tyndall::Layer layer : {tyndall::Layer::media_to_media, tyndall::Layer::media_to_surface}) {
            if (!first) fmt::print(",\n");
            first = false;
            tyndall::bench::measure(scene, layer, seeds, passes);
            std::fflush(stdout);
        }
    fmt::print("\n]}}\n");
}
