#include "volumes/medium_line.hpp"

#include <gtest/gtest.h>

#include <random>

#include "grid_scene.hpp"
#include "transport/lit_stretch.hpp"
#include "visibility/visibility.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

/// A line through a turned box of blotches in one or three channels.
struct Blotches {
    BuiltScene s;
    int volume, medium;
    std::mt19937_64 engine{5};

    explicit Blotches(int channels) : volume(add_volume(s, {5, 4, 6}, turned_box({1, .8, 1.2}), blotches, channels)), medium(add_grid_medium(s, volume, {1, 3, .5}, Rgb(.9)))
    {
    }
    double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine); }
    /// Towards the middle from somewhere around.
    MediumLine line(double t0, double t1)
    {
        const Vec3 from(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)), to(uniform(-.3, .3), uniform(-.3, .3), uniform(-.3, .3));
        return {.medium = s.scene.media[std::size_t(medium)], .origin = from, .direction = glm::normalize(to - from), .t0 = t0, .t1 = t1};
    }
    Rgb plain_depth(const MediumLine& l, double t0, double t1) const
    {
        const Volume& v = s.scene.volumes[std::size_t(volume)];
        Rgb depth(0);
        for (int c = 0; c < 3; ++c) depth[c] = l.medium.sigma_t[c] * plain_integral(v, std::min(c, v.channels - 1), l.origin, l.direction, t0, t1);
        return depth;
    }
};

void expect_near(const Rgb& a, const Rgb& b, double tolerance)
{
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

TEST(MediumLine, DepthIsTheIntegralOfExtinction)
{
    for (const int channels : {1, 3}) {
        Blotches b(channels);
        for (int i = 0; i < 20; ++i) {
            const MediumLine line = b.line(.1, 2.5);
            // The midpoint rule is off by a step's share of the largest extinction where the box begins and ends; the grid's matrix is in float.
            expect_near(optical_depth(b.s.scene, line), b.plain_depth(line, .1, 2.5), 2.4 / 20000 * 9 + 1e-5);
        }
    }
}

TEST(MediumLine, EndlessLinesThroughABoxHaveTheDepthOfTheBox)
{
    Blotches b(3);
    for (int i = 0; i < 20; ++i) {
        MediumLine line = b.line(0, 4);
        const Rgb near = optical_depth(b.s.scene, line);
        line.t1 = 1e30;
        expect_near(optical_depth(b.s.scene, line), near, 1e-9);
        line.t1 = 1e300;
        const Rgb huge = optical_depth(b.s.scene, line);
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(huge[c] >= 0) << huge[c];
    }
}

TEST(MediumLine, ReachingADepthUndoesIt)
{
    for (const int channels : {1, 3}) {
        Blotches b(channels);
        for (int i = 0; i < 200; ++i) {
            MediumLine line = b.line(.05, i % 2 ? 1e30 : 3);
            const Rgb whole = optical_depth(b.s.scene, line);
            for (int c = 0; c < 3; ++c)
                for (const double share : {0., 1e-9, .1, .5, .9, .999999}) {
                    const DepthReached reached = reach_depth(b.s.scene, line, c, share * whole[c]);
                    ASSERT_EQ(reached.reached, whole[c] > 0) << share;
                    if (!reached.reached) continue;
                    MediumLine before = line;
                    before.t1 = reached.t;
                    expect_near(optical_depth(b.s.scene, before), reached.depth, 1e-12 * (1 + whole[c]));
                    EXPECT_NEAR(reached.depth[c], share * whole[c], 1e-14 * whole[c]);
                }
            for (int c = 0; c < 3; ++c) {
                const DepthReached past = reach_depth(b.s.scene, line, c, whole[c] * (1 + 1e-12) + 1e-300);
                EXPECT_FALSE(past.reached);
                expect_near(past.depth, whole, 0);
            }
        }
    }
}

TEST(MediumLine, NothingLiesOutsideOfItsExtent)
{
    Blotches b(1);
    int shorter = 0;
    for (int i = 0; i < 200; ++i) {
        const MediumLine line = b.line(0, 1e30);
        const LineExtent extent = extent_of(b.s.scene, line);
        const Rgb whole = optical_depth(b.s.scene, line);
        ASSERT_EQ(extent.t1 > extent.t0, whole.x > 0);
        if (!(whole.x > 0)) continue;
        ASSERT_TRUE(extent.t0 >= 0 && extent.t1 < 4) << "ends at the box at the latest";
        MediumLine inside = line;
        inside.t0 = extent.t0, inside.t1 = extent.t1;
        expect_near(optical_depth(b.s.scene, inside), whole, 1e-12 * (1 + whole.y));
        shorter += extent.t0 > 0;
    }
    EXPECT_GT(shorter, 50);
}

TEST(MediumLine, CoefficientsAtAPointAreThoseOfTheGrids)
{
    Blotches b(3);
    const int albedo = add_volume(b.s, {2, 2, 2}, turned_box({1, .8, 1.2}), [](int c, const glm::ivec3& v) { return .1 * (1 + v.x + 2 * v.y + 4 * v.z) * (c + 1) / 3; }, 3);
    b.s.scene.media[std::size_t(b.medium)].albedo_volume = albedo;
    for (int i = 0; i < 500; ++i) {
        const Vec3 point(b.uniform(-.8, .8), b.uniform(-.8, .8), b.uniform(-.8, .8));
        const MediumPoint at = medium_at(b.s.scene, b.s.scene.media[std::size_t(b.medium)], point);
        for (int c = 0; c < 3; ++c) {
            const double density = plain_value(b.s.scene.volumes[std::size_t(b.volume)], c, point);
            EXPECT_NEAR(at.sigma_t[c], b.s.scene.media[std::size_t(b.medium)].sigma_t[c] * density, 3e-5);
            EXPECT_TRUE(density == 0 || std::abs(at.albedo[c] - plain_value(b.s.scene.volumes[std::size_t(albedo)], c, point)) < 1e-6);
        }
    }
}

TEST(LitStretch, EndsWhereTheLastChannelThatScattersIsOpaque)
{
    BuiltScene s;
    const int volume = add_volume(s, {4, 4, 4}, glm::translate(Mat4(1), Vec3(-.5)), [](int, const glm::ivec3& v) { return v.z == 0 ? 0. : 1.; });
    const int medium = add_grid_medium(s, volume, {1000, 500, 1}, {.5, .5, 0});
    const MediumLine line{.medium = s.scene.media[std::size_t(medium)], .origin = {0, 0, -2}, .direction = {0, 0, 1}, .t0 = .5, .t1 = 1e30};
    // The density rises from 0 at z = -3/8 to 1 at -1/8: 1/8 by then, 104 = 500 x depth at 1/8 + what is left.
    const LitStretch lit = lit_stretch(s.scene, line);
    EXPECT_NEAR(lit.start, 2 - .375, 1e-6);
    EXPECT_NEAR(lit.start + lit.length, 2 - .125 + 104. / 500 - .125, 1e-5);
    expect_near(lit.whole, optical_depth(s.scene, line), 1e-12);
    EXPECT_NEAR(lit.depth.y, 104, 1e-9);
    EXPECT_LT(lit_stretch(s.scene, line, Rgb(200)).length, 0);
    expect_near(lit_stretch(s.scene, line, Rgb(200)).whole, lit.whole, 0);
    EXPECT_NEAR(lit_stretch(s.scene, line, Rgb(200, 0, 0)).length, lit.length, 1e-12);
    const MediumLine beside{.medium = line.medium, .origin = {2, 0, -2}, .direction = {0, 0, 1}, .t0 = .5, .t1 = 1e30};
    EXPECT_LE(lit_stretch(s.scene, beside).length, 0);
}

TEST(Visibility, ConnectionsAreDimmedByGrids)
{
    Blotches b(3);
    b.s.container(Vec3(-1.5), Vec3(1.5), {.interior = b.medium});
    const Visibility visibility(b.s.scene, 1);
    for (int i = 0; i < 10; ++i) {
        const MediumLine line = b.line(0, 1.4);
        const Vec3 end = line.origin + line.t1 * line.direction;
        expect_near(visibility.optical_depth(line.origin, b.medium, end), b.plain_depth(line, 0, 1.4), 1.4 / 20000 * 9 + 1e-5);
        expect_near(visibility.optical_depth(end, b.medium, line.origin), visibility.optical_depth(line.origin, b.medium, end), 1e-11);
    }
}

}  // namespace
