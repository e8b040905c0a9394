#include "film/film.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace tyndall {
namespace {

LayerSet set_of(std::initializer_list<Layer> layers)
{
    LayerSet set;
    for (const auto layer : layers) set.add(layer);
    return set;
}

/// One pass of one pixel: `single` and `media_to_media` hold the given grey values.
PassImage one_pixel(double single, double media)
{
    PassImage image(1, 1, set_of({Layer::single, Layer::media_to_media}));
    image[Layer::single][0] = Rgb(single);
    image[Layer::media_to_media][0] = Rgb(media);
    return image;
}

TEST(Film, MeanAndBeautyAreSumsOverPasses)
{
    Film film(1, 1, LayerSet::all());
    film.add_pass(one_pixel(1, 10));
    film.add_pass(one_pixel(2, 30));
    EXPECT_EQ(film.passes(), 2);
    EXPECT_EQ(film.mean(Layer::single)[0], Rgb(1.5));
    EXPECT_EQ(film.mean(Layer::media_to_media)[0], Rgb(20));
    EXPECT_EQ(film.mean(Layer::emitted)[0], Rgb(0));
    EXPECT_EQ(film.beauty()[0], Rgb(21.5));
    EXPECT_TRUE(film.has(Layer::single));
    EXPECT_FALSE(film.has(Layer::emitted));
}

TEST(Film, VarianceOfTheMeanMatchesHandComputedValues)
{
    Film film(1, 1, LayerSet::all(), {.layer_variance = true});
    for (const double media : {10., 30., 50.}) film.add_pass(one_pixel(1, media));
    // Beauty 11, 31, 51: mean 31, variance (400 + 0 + 400) / 2 = 400, of the mean 400 / 3. Sums are small integers: 2 ulp for two
    // divisions.
    EXPECT_DOUBLE_EQ(film.variance_of_mean()[0].x, 400. / 3);
    EXPECT_DOUBLE_EQ(film.variance_of_mean(Layer::media_to_media)[0].y, 400. / 3);
    EXPECT_EQ(film.variance_of_mean(Layer::single)[0].z, 0);
}

TEST(Film, VarianceIsZeroWhereItIsUnknownAndNeverNegative)
{
    Film film(1, 1, LayerSet::all());
    EXPECT_EQ(film.variance_of_mean()[0], Rgb(0));
    EXPECT_EQ(film.beauty()[0], Rgb(0));
    for (int pass = 0; pass < 100; ++pass) {
        film.add_pass(one_pixel(.1, .2));  // .1 + .2 squared and summed does not cancel exactly
        EXPECT_GE(film.variance_of_mean()[0].x, 0) << "pass " << pass;
        EXPECT_LT(film.variance_of_mean()[0].x, 1e-15) << "pass " << pass;
    }
}

TEST(Film, VarianceOfTheMeanIsUnbiased)
{
    // 4096 pixels x 3 channels of 5 passes of uniform noise: the mean of the estimates is 1/12/5. The estimate's relative deviation is
    // sqrt((kurtosis - 1 + 2/(n-1))/n) = sqrt((.8 + .5)/5) = .51; over 12288 values .0046. Limit 4 deviations: false alarm 6e-5, seed
    // fixed.
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> uniform;
    Film film(64, 64, set_of({Layer::single}));
    for (int pass = 0; pass < 5; ++pass) {
        PassImage image(64, 64, set_of({Layer::single}));
        for (auto& pixel : image[Layer::single]) pixel = Rgb(uniform(generator), uniform(generator), uniform(generator));
        film.add_pass(image);
    }
    double sum = 0;
    for (const auto& v : film.variance_of_mean()) sum += v.x + v.y + v.z;
    EXPECT_NEAR(sum / (3 * 4096) * 60, 1, 4 * .0046);
}

/// Sums as the film promises them: blocks of B, finished blocks into a total in order.
double blocked_sum(const std::vector<double>& values, int block_passes)
{
    double total = 0, block = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        block += values[i];
        if ((i + 1) % static_cast<std::size_t>(block_passes) == 0) total += block, block = 0;
    }
    return total + block;
}

TEST(Film, SumsAreBlockedExactlyAsPromised)
{
    std::mt19937_64 generator(2);
    std::exponential_distribution<double> exponential;
    for (const int block_passes : {1, 3, 8}) {
        Film film(1, 1, LayerSet::all(), {.block_passes = block_passes});
        std::vector<double> values;
        for (int pass = 0; pass < 29; ++pass) {
            values.push_back(exponential(generator));
            film.add_pass(one_pixel(values.back(), 0));
            EXPECT_EQ(film.mean(Layer::single)[0].x, blocked_sum(values, block_passes) / static_cast<double>(values.size()))
                << "block of " << block_passes << ", pass " << pass;
        }
    }
}

TEST(Film, BlockingDiffersFromPlainSummation)
{
    // Otherwise the test above would not see a film that forgets its blocks.
    std::mt19937_64 generator(2);
    std::exponential_distribution<double> exponential;
    std::vector<double> values;
    int different = 0;
    for (int pass = 0; pass < 29; ++pass) {
        values.push_back(exponential(generator));
        different += blocked_sum(values, 8) != blocked_sum(values, 1000);
    }
    EXPECT_GT(different, 0);
}

TEST(Film, IgnoresLayersOutsideItsSetAndTakesNoMemoryForMissingOnes)
{
    Film film(1, 1, set_of({Layer::single, Layer::emitted}));
    film.add_pass(one_pixel(1, 10));
    EXPECT_EQ(film.beauty()[0], Rgb(1));
    EXPECT_FALSE(film.has(Layer::media_to_media));
    EXPECT_EQ(film.memory_bytes(), 2 * sizeof(Rgb) + sizeof(glm::vec3));  // one layer with its deviations and the squares of the beauty
}

TEST(Film, ALayerThatComesLateCountsAsBlackBefore)
{
    Film film(1, 1, LayerSet::all(), {.block_passes = 2});
    for (int pass = 0; pass < 3; ++pass) film.add_pass(PassImage(1, 1, {}));
    film.add_pass(one_pixel(8, 0));
    EXPECT_EQ(film.mean(Layer::single)[0], Rgb(2));
}

TEST(Film, ListsPixelsThatAreNotFiniteAndCountsThemAsBlack)
{
    Film film(5, 4, LayerSet::all());
    PassImage image(5, 4, set_of({Layer::single, Layer::media_to_media}));
    image[Layer::single][7] = Rgb(1, std::numeric_limits<double>::quiet_NaN(), 1);
    image[Layer::media_to_media][19] = Rgb(std::numeric_limits<double>::infinity(), 0, 0);
    image[Layer::media_to_media][7] = Rgb(2);
    film.add_pass(PassImage(5, 4, {}));
    film.add_pass(image);
    ASSERT_EQ(film.not_finite().count, 2u);
    const auto& first = film.not_finite().first_cases;
    ASSERT_EQ(first.size(), 2u);
    EXPECT_EQ(first[0].pass, 1);
    EXPECT_EQ(first[0].layer, Layer::single);
    EXPECT_EQ(first[0].x, 2);
    EXPECT_EQ(first[0].y, 1);
    EXPECT_EQ(first[1].layer, Layer::media_to_media);
    EXPECT_EQ(first[1].x, 4);
    EXPECT_EQ(first[1].y, 3);
    EXPECT_EQ(film.beauty()[7], Rgb(1));  // 0 of single and 2 of media_to_media, over two passes
    EXPECT_EQ(film.beauty()[19], Rgb(0));
}

TEST(Film, KeepsAFewCasesButCountsAll)
{
    Film film(4, 4, LayerSet::all());
    PassImage image(4, 4, set_of({Layer::emitted}));
    for (auto& pixel : image[Layer::emitted]) pixel.x = std::numeric_limits<double>::quiet_NaN();
    film.add_pass(image);
    EXPECT_EQ(film.not_finite().count, 16u);
    EXPECT_EQ(film.not_finite().first_cases.size(), NotFiniteLedger::kept_cases);
}

TEST(Film, AveragesFeatures)
{
    Film film(1, 1, LayerSet::all());
    EXPECT_FALSE(film.features().has_value());
    const PixelFeatures first{{Rgb(.5)}, {Vec3(0, 0, 1)}, {3}}, second{{Rgb(.25)}, {Vec3(0, 1, 0)}, {5}};
    film.add_pass(one_pixel(0, 0), &first);
    film.add_pass(one_pixel(0, 0), &second);
    const auto features = film.features();
    ASSERT_TRUE(features.has_value());
    EXPECT_EQ(features->albedo[0], Rgb(.375));
    EXPECT_EQ(features->normal[0], Vec3(0, .5, .5));
    EXPECT_EQ(features->depth[0], 4);
}

TEST(Film, StaysBelow240MiBForAllLayersOf512Squared)
{
    Film film(512, 512, LayerSet::all());
    const PassImage image(512, 512, LayerSet::all());
    const PixelFeatures features{std::vector<Rgb>(512 * 512), std::vector<Vec3>(512 * 512), std::vector<double>(512 * 512)};
    for (int pass = 0; pass < 9; ++pass) film.add_pass(image, &features);  // beyond the first block, both sums exist
    EXPECT_LT(film.memory_bytes(), std::size_t(240) << 20);
}

}  // namespace
}  // namespace tyndall
