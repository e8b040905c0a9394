/// Method vrl against the reference images. Passes are chosen so that the block error is near, but below, its limit; the cost is in
/// README.md.
#include <gtest/gtest.h>

#include "reference_image.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

class VirtualRayLightImage : public testing::TestWithParam<ReferenceCase> {};

TEST_P(VirtualRayLightImage, MatchesItsReference) { expect_agreement(GetParam()); }

RenderSettings vrl(int passes, std::uint32_t lights = 256) { return {.method = Method::vrl, .passes = passes, .lights = lights}; }

std::string name_of(const testing::TestParamInfo<ReferenceCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Reference, VirtualRayLightImage,
                         testing::Values(whole_image(fog_room, vrl(80)), whole_image(juice, vrl(90)), whole_image(fog_cube, vrl(25)),
                                         at_most_one_scattering(fog_room, vrl(15)), at_most_one_scattering(juice, vrl(30)),
                                         at_most_one_scattering(fog_cube, vrl(60)), all_media_to_media(fog_room, vrl(70)),
                                         all_media_to_media(juice, vrl(440)), all_media_to_media(fog_cube, vrl(250)),
                                         double_scattering(fog_room, vrl(25)), double_scattering(juice, vrl(110)),
                                         double_scattering(fog_cube, vrl(90))),
                         name_of);

}  // namespace
