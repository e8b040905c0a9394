/// The error's own error bar, and stopping at a target error, on simulated passes.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "film/error_estimate.hpp"

namespace tyndall {
namespace {

constexpr int side = 8;
using Random = std::mt19937_64;
/// The value of a pixel in a pass; mean 1.
using Noise = std::function<double(Random&, double of_pass)>;

LayerSet single_only() { return LayerSet().add(Layer::single); }

/// One pass. `shared`: drawn once a pass, as the light paths of a pass are shared by all pixels.
PassImage noisy_pass(Random& random, const Noise& noise, const std::function<double(Random&)>& shared)
{
    PassImage image(side, side, single_only());
    const double of_pass = shared(random);
    for (Rgb& pixel : image[Layer::single]) pixel = Rgb(noise(random, of_pass), noise(random, of_pass), noise(random, of_pass));
    return image;
}

double normal(Random& random) { return std::normal_distribution<double>()(random); }

/// Independent pixels: relative variance .25 per pass.
const Noise independent = [](Random& random, double) { return 1 + .5 * normal(random); };
/// All pixels move together: the same variance.
const Noise together = [](Random&, double of_pass) { return 1 + .5 * of_pass; };
/// Half and half, as in many-light renders.
const Noise correlated = [](Random& random, double of_pass) { return 1 + .3535534 * (normal(random) + of_pass); };
/// Log-normal with sigma 1.2 in the part that pixels share: most passes are quiet, a few are loud. Relative variance 3.22 = exp(1.44) - 1.
const Noise heavy = [](Random&, double of_pass) { return std::exp(1.2 * of_pass - .72); };

Film film_of(std::uint64_t seed, int passes, const Noise& noise)
{
    Random random(seed);
    Film film(side, side, single_only());
    for (int i = 0; i < passes; ++i) film.add_pass(noisy_pass(random, noise, normal));
    return film;
}

double true_error(double variance, int passes) { return std::sqrt(variance / passes / 1.0025); }

TEST(PassSpread, EqualsTheErrorFromSquares)
{
    for (const auto& [noise, tolerance] : {std::pair(independent, .03), std::pair(correlated, .25)}) {
        const Film film = film_of(1, 256, noise);
        EXPECT_NEAR(film.spread().relative_mse() / std::pow(estimated_error(film), 2), 1, tolerance);
        EXPECT_DOUBLE_EQ(estimated_error(film, Layer::single), std::sqrt(film.spread().relative_mse()));
    }
    EXPECT_LT(film_of(1, 1, independent).spread().relative_mse(), 0) << "one pass says nothing";
}

TEST(PassSpread, KnowsThatPixelsMoveTogether)
{
    // 192 pixels x channels: their squares average out to sqrt(2 / 192) a pass; together they do not average out: sqrt(2) a pass.
    const double terms = 128;
    EXPECT_NEAR(film_of(2, 256, independent).spread().relative_standard_error(), std::sqrt(2 / 192. / terms), .3 * std::sqrt(2 / 192. / terms));
    EXPECT_NEAR(film_of(2, 256, together).spread().relative_standard_error(), std::sqrt(2 / terms), .35 * std::sqrt(2 / terms));
}

TEST(PassSpread, CountsPassesThatDidNotBringALayerAsBlack)
{
    Film film(1, 1, LayerSet::all());
    PassImage bright(1, 1, single_only()), empty(1, 1, LayerSet().add(Layer::emitted));
    bright[Layer::single][0] = Rgb(1);
    for (int i = 0; i < 64; ++i) film.add_pass(i % 2 ? empty : bright);
    // Mean 1/2, variance 1/4 a pass: relMSE = (1/4) / 64 / (1/4 (1 + .0025)).
    EXPECT_NEAR(film.spread(Layer::single).relative_mse(), 1 / (64 * 1.0025), .04 / 64);
}

TEST(ErrorUpperBound, IsInfiniteInThePilot)
{
    EXPECT_EQ(error_upper_bound(film_of(3, pilot_passes - 1, independent)), std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isfinite(error_upper_bound(film_of(3, pilot_passes, independent))));
}

/// Share of films whose true error lies above the bound, of 400.
double missed(int passes, const Noise& noise, double variance)
{
    int above = 0;
    constexpr int films = 400;
    for (int i = 0; i < films; ++i) above += true_error(variance, passes) > error_upper_bound(film_of(100 + i, passes, noise));
    return double(above) / films;
}

TEST(ErrorUpperBound, HoldsInNinetyFivePercentOfFilms)
{
    // 400 films: 5 % +- 1.1 % (one deviation). Measured: 9.8 %, 3.8 %, 7.0 % and 3.0 %; the image stands for its own reference, which costs the first its excess.
    // The limits lie three deviations above what was measured.
    EXPECT_LT(missed(64, correlated, .25), .14);
    EXPECT_LT(missed(64, together, .25), .07);
    EXPECT_LT(missed(256, correlated, .25), .11);
    EXPECT_LT(missed(256, together, .25), .06);
    EXPECT_GT(missed(256, together, .25), .005) << "of a use";
}

/// Error and passes at which a render with this target would stop.
struct Stop {
    int passes;
    double true_error;
};
Stop stop_at(double target, std::uint64_t seed, const Noise& noise, double variance, int most)
{
    Random random(seed);
    Film film(side, side, single_only());
    do film.add_pass(noisy_pass(random, noise, normal));
    while (film.passes() < most && !(error_upper_bound(film) <= target));
    return {film.passes(), true_error(variance, film.passes())};
}

TEST(TargetError, IsReachedWhenARenderStops)
{
    int early = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Stop stop = stop_at(.1, seed, correlated, .25, 1000);
        early += stop.true_error > .1 * 1.1;
        EXPECT_LT(stop.passes, 200) << "25 passes are needed on average, and a bound on top";
    }
    EXPECT_LT(early, 12) << "few stop more than 10 % above the target (2 of 200 when this was written)";
}

TEST(TargetError, IsNotReachedByLuckWhereTailsAreHeavy)
{
    // 322 passes are needed. The plain estimate, asked after every pass, stops long before in most runs: the first passes are quiet.
    int early = 0, early_without_bound = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        early += stop_at(.1, seed, heavy, 3.22, 2000).passes < 322 / 2;
        Random random(seed);
        Film film(side, side, single_only());
        do film.add_pass(noisy_pass(random, heavy, normal));
        while (film.passes() < 322 && !(film.passes() >= 2 && estimated_error(film) <= .1));
        early_without_bound += film.passes() < 322 / 2;
    }
    EXPECT_LE(early, 4) << "0 of 60 when this was written";
    EXPECT_GT(early_without_bound, 2 * early + 5) << "otherwise the test asks for nothing";
}

}  // namespace
}  // namespace tyndall
