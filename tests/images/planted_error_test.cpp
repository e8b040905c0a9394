/// The tests of this folder can fail: an error of three percent, planted in renders that pass, is found.
#include <gtest/gtest.h>

#include "reference_image.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

std::vector<ImageRgb> scaled(std::vector<ImageRgb> renders, double factor)
{
    for (ImageRgb& render : renders)
        for (Vec3& pixel : render.pixels) pixel *= factor;
    return renders;
}

void expect_found(const ReferenceCase& test_case)
{
    const std::vector<ImageRgb> renders = eight_renders(test_case);
    const ImageComparison untouched = compare_with_reference(renders, test_case.reference);
    EXPECT_TRUE(untouched.passed()) << to_string(untouched);
    for (const double factor : {.97, 1.03}) {
        const ImageComparison wrong = compare_with_reference(scaled(renders, factor), test_case.reference);
        EXPECT_FALSE(wrong.passed()) << "times " << factor << '\n' << to_string(wrong);
    }
}

RenderSettings vrl(int passes) { return {.method = Method::vrl, .passes = passes, .lights = 256}; }

TEST(PlantedError, OfThreePercentInTheWholeImageIsFound) { expect_found(whole_image(fog_cube, vrl(25))); }
TEST(PlantedError, OfThreePercentInOneLayerIsFound) { expect_found(double_scattering(fog_cube, vrl(90))); }
TEST(PlantedError, OfThreePercentInSingleScatteringIsFound) { expect_found(at_most_one_scattering(fog_room, vrl(15))); }

TEST(PlantedError, ALayerThatIsLeftOutOfTheWholeImageIsFound)
{
    ReferenceCase test_case = whole_image(juice, vrl(20));
    test_case.layers = {Layer::emitted, Layer::surface_direct,   Layer::surface_indirect,
                        Layer::single,  Layer::surface_to_media, Layer::media_to_media};
    const ImageComparison wrong = compare_with_reference(eight_renders(test_case), test_case.reference);  // media_to_surface is missing
    EXPECT_FALSE(wrong.passed()) << to_string(wrong);
}

}  // namespace
