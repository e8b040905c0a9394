// What near contact does to the second moment of one sample, for each of the four connections of point and ray lights with surfaces and eye segments, over lights that lie evenly
// in space: what kernels/README.md, sections 5, 8 and 17, says of their weights.
#include <gtest/gtest.h>

#include "bench/singular_moments.hpp"

using namespace tyndall::singular;

namespace {

TEST(Singularities, PointsBesideASurfaceHaveAPowerLaw)
{
    for (const double h : {1e-2, 1e-3, 1e-4}) EXPECT_NEAR(point_to_surface(h / 2) / point_to_surface(h), 2, .05) << h;
}

TEST(Singularities, PointsBesideAnEyeSegmentDivergeWithTheLogarithm)
{
    for (const double h : {1e-2, 1e-3, 1e-4}) EXPECT_NEAR((point_to_segment(h / 10) - point_to_segment(h)) / (2 * pi * pi * pi * std::log(10.)), 1, .02) << h;
}

TEST(Singularities, RaysBesideASurfaceDivergeWithTheLogarithm)
{
    for (const double h : {1e-2, 1e-3, 1e-4}) EXPECT_NEAR((ray_to_surface(h / 10) - ray_to_surface(h)) / (2 * pi * 4 * std::log(10.)), 1, .02) << h;
}

TEST(Singularities, RaysAcrossAnEyeSegmentStayBounded)
{
    const double all = ray_to_segment(1e-8);
    EXPECT_LT(all - ray_to_segment(1e-4), 2e-2 * all);
    EXPECT_LT(all - ray_to_segment(1e-6), 4e-4 * all);
    EXPECT_GT(all - ray_to_segment(1e-1), .1 * all) << "the singularity is there, and integrable";
}

}  // namespace
