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

/// In a density grid: without the negative values that the correction of a march can leave in dark pixels.
RenderSettings exact(int passes)
{
    RenderSettings settings = vpl(passes);
    settings.transmittance = GridTransmittance::exact;
    return settings;
}

std::string name_of(const testing::TestParamInfo<ReferenceCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Reference, VirtualPointLightImage,
                         testing::Values(all_media_to_media(fog_room, vpl(60)), all_media_to_media(juice, vpl(280)), all_media_to_media(fog_cube, vpl(90)), all_media_to_media(plume, exact(150)),
                                         double_scattering(fog_room, vpl(30)), double_scattering(juice, vpl(110)), double_scattering(fog_cube, vpl(65))),
                         name_of);

}  // namespace
