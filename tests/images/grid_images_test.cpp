/// Density grids: method vrl against the reference images of the plume, with both ways to find transmittances. Passes are chosen as in virtual_ray_light_images_test.cpp;
/// about ten minutes of one core, because most of the plume's light comes from few places.
#include <gtest/gtest.h>

#include "reference_image.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

class GridImage : public testing::TestWithParam<ReferenceCase> {};

TEST_P(GridImage, MatchesItsReference) { expect_agreement(GetParam()); }

RenderSettings vrl(int passes) { return {.method = Method::vrl, .passes = passes, .lights = 256}; }

ReferenceCase exactly(ReferenceCase test_case)
{
    test_case.settings.transmittance = GridTransmittance::exact;
    test_case.name += "_exact";
    return test_case;
}

std::string name_of(const testing::TestParamInfo<ReferenceCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Plume, GridImage,
                         testing::Values(whole_image(plume, vrl(60)), at_most_one_scattering(plume, vrl(60)), all_media_to_media(plume, vrl(600)),
                                         double_scattering(plume, vrl(260)), exactly(double_scattering(plume, vrl(240)))),
                         name_of);

}  // namespace
