#pragma once
/// A renderer whose truth is known: pixels of given mean and noise, passes of given length, no clock.
#include <random>

#include "comparison/candidate.hpp"
#include "comparison/reference.hpp"

namespace tyndall::test {

inline constexpr int film_side = 24;

struct SyntheticMethod {
    double noise = .5;           ///< relative deviation of a pixel in one pass
    double common = 0;           ///< the same of a factor that all pixels of a pass share
    double bias = 0;             ///< relative, of every pixel
    double outlier = 0;          ///< added to one value of the fifth pass
    double pass_seconds = .25;
};

/// The truth: a ramp.
inline Rgb truth(std::size_t pixel) { return Rgb(1., 2., .5) * (.5 + double(pixel % film_side) / film_side); }

inline LayerSet synthetic_layers() { return LayerSet().add(Layer::single).add(Layer::media_to_media); }

/// Three quarters of the light in one layer, a quarter in another.
inline PassImage synthetic_pass(const SyntheticMethod& method, std::mt19937_64& random, int pass)
{
    std::normal_distribution<double> normal;
    PassImage image(film_side, film_side, synthetic_layers());
    const double common = 1 + method.common * normal(random);
    for (std::size_t i = 0; i < image[Layer::single].size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double value = truth(i)[c] * (1 + method.bias) * (common + method.noise * normal(random));
            image[Layer::single][i][c] = .75 * value, image[Layer::media_to_media][i][c] = .25 * value;
        }
    if (pass == 4) image[Layer::single][100][1] += method.outlier;
    return image;
}

/// Renders as its description says; which one is chosen by the settings' number of lights, an index into `methods`.
inline RenderFunction synthetic_renderer(std::vector<SyntheticMethod> methods)
{
    return [methods](const RenderSettings& settings, const ProgressCallback& after_pass) {
        const SyntheticMethod& method = methods.at(settings.lights);
        std::mt19937_64 random(settings.seed);
        RenderOutcome outcome{Film(film_side, film_side, synthetic_layers()), {}};
        for (int pass = 0; pass < settings.passes; ++pass) {
            outcome.film.add_pass(synthetic_pass(method, random, pass));
            Progress progress{.passes_done = pass + 1, .seconds = (pass + 1) * method.pass_seconds};
            if (after_pass && !after_pass(progress, outcome.film)) break;
        }
        outcome.report.passes = outcome.film.passes(), outcome.report.method = "synthetic";
        outcome.report.seconds = outcome.report.passes * method.pass_seconds;
        outcome.report.stages = {{"trace_paths", .6 * outcome.report.seconds}, {"media_to_media", .3 * outcome.report.seconds}, {"shadow_segments", .2 * outcome.report.seconds}};
        return outcome;
    };
}

inline Candidate candidate(std::string name, std::uint32_t index)
{
    Candidate c{std::move(name), {}};
    c.settings.lights = index;
    return c;
}

}  // namespace tyndall::test
