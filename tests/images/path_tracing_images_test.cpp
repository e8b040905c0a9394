/// Method path against the reference images: the brute-force twin of every layer passes the same tests.
#include <gtest/gtest.h>

#include "reference_image.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

class PathTracedImage : public testing::TestWithParam<ReferenceCase> {};

TEST_P(PathTracedImage, MatchesItsReference) { expect_agreement(GetParam()); }

RenderSettings path(int passes) { return {.method = Method::path, .passes = passes}; }

std::string name_of(const testing::TestParamInfo<ReferenceCase>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Reference, PathTracedImage,
                         testing::Values(whole_image(fog_room, path(220)), whole_image(juice, path(200)), whole_image(fog_cube, path(40)),
                                         at_most_one_scattering(fog_room, path(80)), at_most_one_scattering(juice, path(100)),
                                         at_most_one_scattering(fog_cube, path(200)), all_media_to_media(fog_room, path(2300)),
                                         all_media_to_media(juice, path(1800)), all_media_to_media(fog_cube, path(1200)),
                                         double_scattering(fog_room, path(2900)), double_scattering(juice, path(2500)),
                                         double_scattering(fog_cube, path(950)), whole_image(plume, path(40)), at_most_one_scattering(plume, path(120)),
                                         all_media_to_media(plume, path(400)), double_scattering(plume, path(340))),
                         name_of);

}  // namespace
