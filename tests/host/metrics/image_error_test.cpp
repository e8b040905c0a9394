// Numbers worked out by hand, and numbers that an independent script (NumPy, its own formulas) gave for the images of synthetic_image.hpp.
#include "metrics/image_error.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "film/error_estimate.hpp"
#include "synthetic_image.hpp"

namespace tyndall::test {
namespace {

using testing::DoubleNear;

TEST(ImageError, OfTwoPixelsByHand)
{
    // mean of the reference 2, e = .01; terms .25 / 1.01 three times, 1 / 9.01 three times
    const std::vector<Rgb> reference{Rgb(1), Rgb(3)}, image{Rgb(1.5), Rgb(2)};
    const ImageError error = image_error(image, reference);
    EXPECT_DOUBLE_EQ(error.relative_mse, (.25 / 1.01 + 1 / 9.01) / 2);
    EXPECT_DOUBLE_EQ(error.rmse, std::sqrt((.25 + 1) / 2));
    EXPECT_DOUBLE_EQ(error.mean, 1.75);
    EXPECT_DOUBLE_EQ(error.reference_mean, 2);
    EXPECT_EQ(error.worst_pixel, 0u);
    EXPECT_DOUBLE_EQ(error.worst_difference, .5);
    EXPECT_DOUBLE_EQ(error.share_of_largest, .25 / 1.01 / (3 * (.25 / 1.01 + 1 / 9.01)));
    EXPECT_DOUBLE_EQ(error.trimmed_relative_mse, error.relative_mse) << "a thousandth of six values is none";
}

TEST(ImageError, OfEqualImagesIsZeroEvenIfTheyAreBlack)
{
    for (const double value : {0., 1.}) {
        const std::vector<Rgb> image(12, Rgb(value));
        const ImageError error = image_error(image, image);
        EXPECT_EQ(error.relative_mse, 0);
        EXPECT_EQ(error.trimmed_relative_mse, 0);
        EXPECT_EQ(error.share_of_largest, 0);
        EXPECT_FALSE(error.has_outliers());
    }
}

TEST(ImageError, TermsHaveTheOneErrorAsTheirMean)
{
    const auto image = noisy_render(3, 1), reference = reference_image();
    const auto terms = relative_squared_errors(image, reference);
    ASSERT_EQ(terms.size(), 3 * image.size());
    const double mean = std::accumulate(terms.begin(), terms.end(), 0.) / static_cast<double>(terms.size());
    EXPECT_THAT(relative_mse(image, reference) / mean, DoubleNear(1, 1e-12));
}

TEST(ImageError, AgreesWithAnotherProgram)
{
    auto image = noisy_render(40, 1);
    const ImageError quiet = image_error(image, reference_image());
    EXPECT_FALSE(quiet.has_outliers()) << quiet.share_of_largest;
    image[13 * image_width + 9][1] += 8;
    const ImageError error = image_error(image, reference_image());
    EXPECT_THAT(error.relative_mse / 0.02040418720800317, DoubleNear(1, 1e-12));
    EXPECT_THAT(error.trimmed_relative_mse / 0.0029954028438461252, DoubleNear(1, 1e-12));
    EXPECT_THAT(error.rmse / 0.22252964482845836, DoubleNear(1, 1e-12));
    EXPECT_THAT(error.mean / error.reference_mean - 1, DoubleNear(0.00925325525450238, 1e-12));
    EXPECT_TRUE(error.has_outliers()) << "one value of 1680 holds " << error.share_of_largest;
    EXPECT_EQ(error.worst_pixel, 13u * image_width + 9);
    EXPECT_GT(error.worst_difference, 7);
}

TEST(ImageError, WithoutTheLargestThousandthIsHandChecked)
{
    // 4000 values of error .1 but for four of 10: floor(12000 / 1000) = 12 of 12000 terms go.
    std::vector<Rgb> reference(4000, Rgb(1)), image(4000, Rgb(1.1));
    for (const std::size_t i : {7u, 100u, 2000u, 3999u}) image[i] = Rgb(11);
    const double e = .05 * .05, small = .1 * .1 / (1 + e), large = 100 / (1 + e);
    const ImageError error = image_error(image, reference);
    EXPECT_THAT(error.trimmed_relative_mse / small, DoubleNear(1, 1e-12));
    EXPECT_THAT(error.relative_mse / ((3996 * small + 4 * large) / 4000), DoubleNear(1, 1e-12));
    EXPECT_THAT(error.share_of_largest, DoubleNear(4 * large / (3996 * small + 4 * large), 1e-12));
    EXPECT_TRUE(error.has_outliers());
}

}  // namespace
}  // namespace tyndall::test
