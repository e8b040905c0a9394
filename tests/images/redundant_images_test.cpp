/// The same references by other roads through the program: virtual ray lights that end at their collision, two samples per pair, either
/// sampler, other lane widths.
#include <gtest/gtest.h>

#include "reference_image.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

class RedundantImage : public testing::TestWithParam<ReferenceCase> {};

TEST_P(RedundantImage, MatchesItsReference) { expect_agreement(GetParam()); }

RenderSettings short_lights(int passes)
{
    return {.method = Method::vrl, .passes = passes, .lights = 256, .segment_length = SegmentLength::short_};
}
RenderSettings two_samples(int passes) { return {.method = Method::vrl, .passes = passes, .lights = 256, .samples_per_pair = 2}; }
RenderSettings lanes(int width, int passes) { return {.method = Method::vrl, .passes = passes, .lights = 256, .lanes = width}; }
RenderSettings by(Sampler sampler, int passes) { return {.method = Method::vrl, .passes = passes, .lights = 256, .sampler = sampler}; }

ReferenceCase named(const char* suffix, ReferenceCase test_case)
{
    test_case.name += suffix;
    return test_case;
}

std::string name_of(const testing::TestParamInfo<ReferenceCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Reference, RedundantImage,
                         testing::Values(named("_short", all_media_to_media(fog_room, short_lights(90))),
                                         named("_short", all_media_to_media(juice, short_lights(650))),
                                         named("_short", all_media_to_media(fog_cube, short_lights(280))),
                                         named("_short", whole_image(juice, short_lights(130))),
                                         named("_two_samples", double_scattering(fog_cube, two_samples(90))),
                                         named("_one_lane", whole_image(fog_cube, lanes(1, 25))),
                                         named("_isotropic_sampler", all_media_to_media(juice, by(Sampler::paper_isotropic, 520))),
                                         named("_product_sampler", all_media_to_media(fog_cube, by(Sampler::paper, 250))),
                                         named("_four_lanes", double_scattering(juice, lanes(4, 110))),
                                         named("_eight_lanes", double_scattering(fog_room, lanes(8, 25)))),
                         name_of);

}  // namespace
