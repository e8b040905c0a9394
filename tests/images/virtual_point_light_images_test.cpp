/// Method vpl against the reference images, in the layer whose variance is bounded but for a logarithm: points and eye segments. Near surfaces the variance of point lights has no bound, and no
/// comparison of images could judge them there; scenes whose surfaces stand apart do (tests/host/pipeline/surface_lights.hpp). 2048 lights, of which each pixel is connected to 64.
#include <gtest/gtest.h>

#include "reference_image.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

class VirtualPointLightImage : public testing::TestWithParam<ReferenceCase> {};

TEST_P(VirtualPointLightImage, MatchesItsReference) { expect_agreement(GetParam()); }

RenderSettings vpl(int passes) { return {.method = Method("vpl"), .passes = passes, .lights = 2048}; }

std::string name_of(const testing::TestParamInfo<ReferenceCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Reference, VirtualPointLightImage,
                         testing::Values(all_media_to_media(fog_room, vpl(60)), all_media_to_media(juice, vpl(60)), all_media_to_media(fog_cube, vpl(60)), all_media_to_media(plume, vpl(60)),
                                         double_scattering(fog_room, vpl(30)), double_scattering(juice, vpl(30)), double_scattering(fog_cube, vpl(30))),
                         name_of);

}  // namespace
