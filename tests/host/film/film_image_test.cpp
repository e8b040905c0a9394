#include "film/film_image.hpp"

#include <gtest/gtest.h>

#include "support/image_rgb.hpp"
#include "support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

/// 2 x 1 pixels, two passes of single, media_to_media and single.specular.
Film small_film(bool with_features)
{
    LayerSet all = LayerSet::all();
    Film film(2, 1, all.remove(Layer::emitted));
    for (const double value : {1., 3.}) {
        LayerSet brought;
        PassImage image(2, 1, brought.add(Layer::single).add(Layer::media_to_media).add(Layer::single_specular));
        image[Layer::single] = {Rgb(value, 0, 0), Rgb(0, value, 0)};
        image[Layer::media_to_media] = {Rgb(10), Rgb(20)};
        image[Layer::single_specular] = {Rgb(0, 0, 100), Rgb(0)};
        const PixelFeatures features{{Rgb(.5), Rgb(.25)}, {Vec3(1, 0, 0), Vec3(0, 0, -1)}, {7, 1e5}};
        film.add_pass(image, with_features ? &features : nullptr);
    }
    return film;
}

std::vector<float> values(const ExrImage& image, const std::string& channel) { return image.channels.at(channel).values; }

TEST(FilmImage, HoldsBeautyLayersVarianceAndSamples)
{
    const auto image = to_exr_image(small_film(false), {3, 4, 50, 40});
    EXPECT_EQ(image.x, 3);
    EXPECT_EQ(image.display_height, 40);
    EXPECT_EQ(values(image, "R"), (std::vector<float>{12, 20}));
    EXPECT_EQ(values(image, "B"), (std::vector<float>{110, 20}));
    EXPECT_EQ(values(image, "single.R"), (std::vector<float>{2, 0}));
    EXPECT_EQ(values(image, "single.G"), (std::vector<float>{0, 2}));
    EXPECT_EQ(values(image, "media_to_media.B"), (std::vector<float>{10, 20}));
    EXPECT_EQ(values(image, "single.specular.B"), (std::vector<float>{100, 0}));
    EXPECT_EQ(values(image, "variance.R"), (std::vector<float>{1, 0}));  // of 11 and 13: 2 / 2
    EXPECT_EQ(values(image, "samples"), (std::vector<float>{2, 2}));
}

TEST(FilmImage, LeavesOutLayersThatAreOffAndSpecularOnesThatNobodyBrought)
{
    const auto image = to_exr_image(small_film(false), {0, 0, 2, 1});
    EXPECT_FALSE(image.channels.contains("emitted.R"));
    EXPECT_FALSE(image.channels.contains("media_to_media.specular.R"));
    EXPECT_FALSE(image.channels.contains("Z"));
    EXPECT_EQ(values(image, "surface_direct.R"), (std::vector<float>{0, 0}));  // wanted, but black
}

TEST(FilmImage, WritesLayersThatTheFilmLacksAsBlackOnRequest)
{
    LayerSet emitted;
    const auto image = to_exr_image(small_film(false), {0, 0, 2, 1}, {.layers = emitted.add(Layer::emitted)});
    EXPECT_EQ(values(image, "emitted.B"), (std::vector<float>{0, 0}));
    EXPECT_EQ(values(image, "B"), (std::vector<float>{110, 20}));
}

TEST(FilmImage, HoldsFeatures)
{
    const auto image = to_exr_image(small_film(true), {0, 0, 2, 1});
    EXPECT_EQ(values(image, "albedo.G"), (std::vector<float>{.5, .25}));
    EXPECT_EQ(values(image, "N.X"), (std::vector<float>{1, 0}));
    EXPECT_EQ(values(image, "N.Z"), (std::vector<float>{0, -1}));
    EXPECT_EQ(values(image, "Z"), (std::vector<float>{7, 1e5}));
}

TEST(FilmImage, HalfSparesVarianceSamplesAndDepth)
{
    const auto image = to_exr_image(small_film(true), {0, 0, 2, 1}, {.half = true});
    for (const auto* name : {"R", "single.G", "albedo.B", "N.Y"}) EXPECT_TRUE(image.channels.at(name).half) << name;
    for (const auto* name : {"variance.R", "samples", "Z"}) EXPECT_FALSE(image.channels.at(name).half) << name;
}

TEST(FilmImage, IsReadBackByTheTestSupport)
{
    test::TemporaryFolder folder;
    write_exr(folder / "a.exr", to_exr_image(small_film(false), {0, 0, 2, 1}));
    EXPECT_EQ(test::read_rgb(folder / "a.exr").at(0, 0), Vec3(12, 10, 110));
    EXPECT_EQ(test::read_rgb(folder / "a.exr", "single").at(1, 0), Vec3(0, 2, 0));
    EXPECT_EQ(test::read_layers(folder / "a.exr", {"single", "media_to_media"}).at(0, 0), Vec3(12, 10, 10));
    EXPECT_THROW(test::read_rgb(folder / "a.exr", "emitted"), IoError);
}

}  // namespace
}  // namespace tyndall
