#include "film/error_estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tyndall {
namespace {

TEST(RelativeMse, MatchesAHandComputedValue)
{
    // Mean of the reference 2, e = (.05 * 2)^2 = .01. Errors: 1 of 1 -> 1/1.01 in one of six values, .5 of 3 -> .25/9.01 in three.
    const std::vector<Rgb> reference{Rgb(1), Rgb(3)}, image{Rgb(1, 2, 1), Rgb(3.5)};
    EXPECT_NEAR(relative_mse(image, reference), (1 / 1.01 + 3 * .25 / 9.01) / 6, 1e-15);
}

TEST(RelativeMse, IsZeroForEqualAndForBlackImages)
{
    const std::vector<Rgb> image{Rgb(1, 0, 2), Rgb(0)}, black(2, Rgb(0));
    EXPECT_EQ(relative_mse(image, image), 0);
    EXPECT_EQ(relative_mse(black, black), 0);
}

TEST(RelativeMse, IsInfiniteForLightWhereTheReferenceIsAllBlack)
{
    EXPECT_EQ(relative_mse(std::vector<Rgb>{Rgb(1)}, std::vector<Rgb>{Rgb(0)}), std::numeric_limits<double>::infinity());
}

TEST(RelativeMse, DoesNotChangeWithTheUnitOfRadiance)
{
    std::vector<Rgb> reference{Rgb(1, 2, 3), Rgb(.01, 5, 0)}, image{Rgb(1.1, 2, 2), Rgb(.02, 5, .1)};
    const double before = relative_mse(image, reference);
    for (auto* pixels : {&reference, &image})
        for (auto& pixel : *pixels) pixel *= 1024;
    EXPECT_DOUBLE_EQ(relative_mse(image, reference), before);
}

TEST(EstimatedError, IsNegativeBelowTwoPasses)
{
    LayerSet single;
    single.add(Layer::single);
    Film film(2, 2, single);
    EXPECT_LT(estimated_error(film), 0);
    film.add_pass(PassImage(2, 2, single));
    EXPECT_LT(estimated_error(film), 0);
    film.add_pass(PassImage(2, 2, single));
    EXPECT_EQ(estimated_error(film), 0);  // black and certain
}

/// 16 passes over 64 x 64 of gamma noise with mean 1 and variance 1/4 per pixel.
Film noisy_film(std::uint64_t seed, int passes)
{
    LayerSet single;
    single.add(Layer::single);
    std::mt19937_64 generator(seed);
    std::gamma_distribution<double> gamma(4, .25);
    Film film(64, 64, single);
    for (int pass = 0; pass < passes; ++pass) {
        PassImage image(64, 64, single);
        for (auto& pixel : image[Layer::single]) pixel = Rgb(gamma(generator), gamma(generator), gamma(generator));
        film.add_pass(image);
    }
    return film;
}

TEST(EstimatedError, AgreesWithTheErrorAgainstTheTruth)
{
    // True relMSE: variance / passes / (1 + .0025) = .015586. The measured one scatters by sqrt(2/12288) = 1.3 %, the estimate by about
    // sqrt(2/15/12288) = .3 % and is biased by O(relMSE) because the image stands for the reference (E[1/x^2] for 1/E[x]^2): +- 8 % covers
    // 3 relMSE + 3 deviations of both.
    const Film film = noisy_film(3, 16);
    const std::vector<Rgb> truth(64 * 64, Rgb(1));
    const double measured = std::sqrt(relative_mse(film.beauty(), truth)), estimated = estimated_error(film);
    EXPECT_NEAR(measured, std::sqrt(.25 / 16 / 1.0025), .04 * .125);
    EXPECT_NEAR(estimated / measured, 1, .04);
}

TEST(EstimatedError, EqualsTheExpectedRelativeMseOfItsImages)
{
    const Film film = noisy_film(4, 5);
    EXPECT_DOUBLE_EQ(estimated_error(film), std::sqrt(expected_relative_mse(film.beauty(), film.variance_of_mean())));
}

TEST(EstimatedError, FallsWithTheRootOfThePasses)
{
    const double ratio = estimated_error(noisy_film(5, 16)) / estimated_error(noisy_film(6, 64));
    EXPECT_NEAR(ratio, 2, .1);  // scatter .5 %, bias of the estimate of 16 passes 2.5 %
}

}  // namespace
}  // namespace tyndall
