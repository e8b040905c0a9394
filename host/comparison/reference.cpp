#include "comparison/reference.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "film/error_estimate.hpp"
#include "report/readable.hpp"
#include "tyndall/error.hpp"
#include "tyndall/setting_names.hpp"

namespace tyndall {
namespace {

constexpr double exactly = std::numeric_limits<double>::infinity();

double mean_of(std::span<const Rgb> pixels)
{
    double total = 0;
    for (const Rgb& pixel : pixels) total += sum(pixel);
    return total / (3. * static_cast<double>(pixels.size()));
}

/// Means with the variance of each that follows from pixels that err alone (variance of the mean of n) or all together (square of the mean deviation).
void estimate_from_variances(Reference& reference, std::span<const Rgb> variance, bool independent_pixels)
{
    std::vector<Rgb> spread(variance.begin(), variance.end());
    if (!independent_pixels)
        for (Rgb& v : spread) v = glm::sqrt(v);
    const auto of = [&](double mean, double values) { return independent_pixels ? mean / values : mean * mean; };
    reference.whole.variance = of(mean_of(spread), static_cast<double>(spread.size()));
    const auto blocks = block_means(spread, reference.width);
    for (std::size_t b = 0; b < blocks.size(); ++b) reference.blocks[b].variance = of(blocks[b], block_side * block_side);
    reference.floor = expected_relative_mse(reference.pixels, variance);
    reference.error_known = true;
}

void take_film(Reference& reference, const Film& film, const BlockStatistics& passes)
{
    reference.width = film.width(), reference.height = film.height();
    reference.pixels = film.beauty();
    reference.whole = passes.whole();
    for (const RunningMean& block : passes.blocks()) reference.blocks.push_back(block.estimate());
    reference.floor = expected_relative_mse(reference.pixels, film.variance_of_mean());
    reference.error_known = true;
    for (std::size_t l = 0; l < layer_count; ++l) {
        const auto layer = static_cast<Layer>(l);
        if (!film.has(layer)) continue;
        reference.layers[std::string(name(layer))] = film.mean(layer);
        if (const double error = estimated_error(film, layer); error >= 0) reference.layer_floors[std::string(name(layer))] = error * error;
    }
}

}  // namespace

Reference reference_from_file(const ImageFile& file, bool independent_pixels, const std::string& scene_hash)
{
    Reference reference{.origin = file.file.string(), .width = file.width, .height = file.height, .pixels = file.pixels};
    reference.whole = {mean_of(file.pixels), 0, exactly};
    for (const double mean : block_means(file.pixels, file.width)) reference.blocks.push_back({mean, 0, exactly});
    if (file.variance.empty())
        reference.warnings.push_back(fmt::format("{}: says nothing of its own error (no channels variance.R/G/B for what is compared), so it counts as exact", file.file.string()));
    else
        estimate_from_variances(reference, file.variance, independent_pixels);
    if (!file.scene_hash.empty() && file.scene_hash != scene_hash)
        reference.warnings.push_back(fmt::format("{}: was rendered from another scene, or with other -D values (hash {}, the scene's is {}); part of every error may be the scenes'",
                                                 file.file.string(), file.scene_hash, scene_hash));
    return reference;
}

MadeReference make_reference(const RenderFunction& render, RenderSettings settings, double seconds, const std::function<bool()>& stop)
{
    BlockStatistics passes;
    std::vector<Rgb> before;
    settings.passes = std::numeric_limits<int>::max(), settings.seconds = 0, settings.target_error = 0;
    const auto after_pass = [&](const Progress& progress, const Film& film) {
        const std::vector<Rgb> image = film.beauty();
        if (before.empty()) before.assign(image.size(), Rgb(0));
        const double n = film.passes();
        for (std::size_t i = 0; i < image.size(); ++i) before[i] = n * image[i] - (n - 1) * before[i];
        passes.add(before, film.width());
        before = image;
        return !stop() && (progress.seconds < seconds || film.passes() < 2);
    };
    RenderOutcome outcome = render(settings, after_pass);
    if (outcome.film.passes() < 2) throw Error("stopped before the reference had two passes, so there is nothing to compare with");
    Reference reference;
    take_film(reference, outcome.film, passes);
    reference.origin = fmt::format("{}, {} passes in {}, seed {}, own error {}", name(settings.method), outcome.film.passes(), readable_seconds(outcome.report.seconds), settings.seed,
                                   readable_percent(std::sqrt(reference.floor)));
    return {std::move(reference), std::move(outcome)};
}

}  // namespace tyndall
