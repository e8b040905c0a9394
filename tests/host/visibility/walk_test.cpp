#include <gtest/gtest.h>

#include <algorithm>

#include "../transport/built_scene.hpp"
#include "transport/random_sequence.hpp"
#include "transport/warp.hpp"
#include "visibility/visibility.hpp"

using namespace tyndall;
using test::BuiltScene;

namespace {

RandomSequence numbers(std::uint64_t which) { return {11, 0, RandomStream::pilot, which}; }
Vec3 between(RandomSequence& random, const Vec3& low, const Vec3& high)
{
    return low + Vec3(random.next(), random.next(), random.next()) * (high - low);
}

struct Box {
    Vec3 low, high;
    int medium;
};

/// Length of the segment inside a box, by clipping to its slabs: shares nothing with the tracer.
std::pair<double, double> clip(const Box& box, const Vec3& from, const Vec3& to)
{
    double t0 = 0, t1 = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = to[axis] - from[axis];
        double a = (box.low[axis] - from[axis]) / d, b = (box.high[axis] - from[axis]) / d;
        if (a > b) std::swap(a, b);
        t0 = std::max(t0, a), t1 = std::min(t1, b);
    }
    return {t0, std::max(t0, t1)};
}

double length_in(const Box& box, const Vec3& from, const Vec3& to)
{
    const auto [t0, t1] = clip(box, from, to);
    return (t1 - t0) * glm::length(to - from);
}

bool inside(const Box& box, const Vec3& p) { return glm::all(glm::greaterThan(p, box.low)) && glm::all(glm::lessThan(p, box.high)); }

/// Random segments between points anywhere, against the lengths in the boxes. `inner` lies in `outer` (its depth replaces the outer's) or
/// beside it.
void expect_depths(const BuiltScene& s, const Box& first, const Box& second, bool nested)
{
    const Visibility visibility(s.scene, 1);
    RandomSequence random = numbers(1);
    for (int i = 0; i < 3000; ++i) {
        const Vec3 from = between(random, Vec3(-1), Vec3(1)), to = between(random, Vec3(-1), Vec3(1));
        const int start = inside(second, from) ? second.medium : inside(first, from) ? first.medium : vacuum;
        const double in_second = length_in(second, from, to), in_first = length_in(first, from, to) - (nested ? in_second : 0);
        const Rgb expected = s.scene.media[first.medium].sigma_t * in_first + s.scene.media[second.medium].sigma_t * in_second;
        const Rgb found = visibility.optical_depth(from, start, to);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(found[c], expected[c], 1e-12) << i;
        const Rgb back = visibility.optical_depth(to, inside(second, to) ? second.medium : inside(first, to) ? first.medium : vacuum, from);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(back[c], expected[c], 1e-12) << i;
        EXPECT_EQ(visibility.transmittance(from, start, to), glm::exp(-found));
    }
}

struct Media {
    BuiltScene s;
    int a, b;
    Media() : a(s.medium({1, 2, 3}, Rgb(.5))), b(s.medium({5, .25, 0}, Rgb(.5))) {}
};

TEST(Walk, OpticalDepthOfSeparateBoxes)
{
    Media m;
    const Box one{{-.8, -.5, -.5}, {-.2, .5, .5}, m.a}, two{{.1, -.3, -.5}, {.6, .5, .2}, m.b};
    m.s.container(one.low, one.high, {.interior = m.a}), m.s.container(two.low, two.high, {.interior = m.b});
    expect_depths(m.s, one, two, false);
}

TEST(Walk, OpticalDepthOfBoxesThatShareAFace)
{
    Media m;
    const Box one{{-.8, -.5, -.5}, {.1, .5, .5}, m.a}, two{{.1, -.5, -.5}, {.6, .5, .5}, m.b};
    m.s.container(two.low, two.high, {.interior = m.b}), m.s.container(one.low, one.high, {.interior = m.a});
    expect_depths(m.s, one, two, false);
}

TEST(Walk, OpticalDepthOfNestedBoxes)
{
    Media m;
    const Box outer{Vec3(-.8), Vec3(.7), m.a}, inner{{-.3, -.5, -.2}, {.2, .1, .3}, m.b};
    m.s.container(outer.low, outer.high, {.interior = m.a}), m.s.container(inner.low, inner.high, {.interior = m.b, .exterior = m.a});
    expect_depths(m.s, outer, inner, true);
}

TEST(Walk, OpticalDepthOfNestedBoxesThatShareFaces)
{
    Media m;
    const Box outer{Vec3(-.7), Vec3(.7), m.a}, inner{Vec3(-.7), {.7, .2, .3}, m.b};
    m.s.container(inner.low, inner.high, {.interior = m.b, .exterior = m.a}), m.s.container(outer.low, outer.high, {.interior = m.a});
    const Visibility visibility(m.s.scene, 1);
    RandomSequence random = numbers(2);
    // Where the inner box touches the outer one's face its outside is vacuum, but it says medium a: leaving both there must give vacuum, in
    // either order.
    for (int i = 0; i < 3000; ++i) {
        const Vec3 from = between(random, inner.low, inner.high), d = sample_uniform_sphere(random.next2());
        const RayWalk walk = visibility.walk({.origin = from, .direction = d, .t_max = 10}, m.b);
        ASSERT_EQ(walk.medium, vacuum) << i;
        const double in_inner = length_in(inner, from, from + 10.0 * d), in_outer = length_in(outer, from, from + 10.0 * d) - in_inner;
        double a = 0, b = 0, in_vacuum = 0;
        for (const MediumPiece& piece : walk.pieces) (piece.medium == m.a ? a : piece.medium == m.b ? b : in_vacuum) += piece.t1 - piece.t0;
        ASSERT_NEAR(b, in_inner, 1e-12);
        ASSERT_NEAR(a, in_outer, 1e-12);
    }
}

TEST(Walk, RaysThroughEdgesCornersAndAlongAxesComeOutInVacuum)
{
    Media m;
    m.s.container(Vec3(-.5), Vec3(.5), {.interior = m.a});
    const Visibility visibility(m.s.scene, 1);
    int rays = 0;
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z)
                for (const double nudge : {0.0, 0x1p-53, -0x1p-53, 1e-9, -1e-9}) {
                    const Vec3 target = .25 * Vec3(x, y, z) + nudge, from(1.5 * (x < 0 ? 1 : -1), y % 2 ? .25 * y : 2, z == 0 ? 0 : 1.5);
                    if (target == from) continue;
                    const RayWalk walk = visibility.walk({.origin = from, .direction = glm::normalize(target - from), .t_max = 20}, vacuum);
                    EXPECT_EQ(walk.medium, vacuum) << x << ' ' << y << ' ' << z << ' ' << nudge;
                    ++rays;
                }
    EXPECT_GT(rays, 600);
}

TEST(Walk, APointThatRoundsAcrossABoundaryStillLeavesIt)
{
    Media m;
    m.s.container(Vec3(-.5), {.5, .5, 1. / 3}, {.interior = m.a});
    const Visibility visibility(m.s.scene, 1);
    for (const double depth : {1e-15, 1e-12, 1e-9, 1e-8, 1e-7}) {  // float rounds all of them to the face or beyond
        const RayWalk out = visibility.walk({.origin = {.1, .2, 1. / 3 - depth}, .direction = {0, 0, 1}, .t_max = 1}, m.a);
        EXPECT_EQ(out.medium, vacuum) << depth;
        ASSERT_EQ(out.pieces.size(), 2u) << depth;
        EXPECT_NEAR(out.pieces[0].t1, depth, 1e-15);
        EXPECT_EQ(visibility.walk({.origin = {.1, .2, 1. / 3 + depth}, .direction = {0, 0, 1}, .t_max = 1}, vacuum).pieces.size(), 1u)
            << depth;
    }
}

TEST(Walk, AFogBoxThatStandsOnAFloorKeepsItsMediumThere)
{
    Media m;
    m.s.container({-.5, 0, -.5}, {.5, .5, .5}, {.interior = m.a});
    m.s.square({0, 0, 0}, {0, 1, 0}, 1, m.s.diffuse(Rgb(.5)));
    const Visibility visibility(m.s.scene, 1);
    RandomSequence random = numbers(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from = between(random, {-.4, .01, -.4}, {.4, .49, .4}), to(random.next() * .8 - .4, 0, random.next() * .8 - .4);
        const RayWalk walk = visibility.walk({.origin = from, .direction = glm::normalize(to - from)}, m.a);
        ASSERT_TRUE(walk.found);
        EXPECT_EQ(walk.medium, m.a);
        const Vec3 up = sample_uniform_sphere(random.next2()) + Vec3(0, 1.01, 0), direction = glm::normalize(up);
        const RayWalk away =
            visibility.walk({.origin = visibility.leave(walk.surface, direction), .direction = direction, .t_max = 5}, walk.medium);
        EXPECT_EQ(away.medium, vacuum);
        EXPECT_EQ(away.pieces.front().medium, m.a);
    }
}

TEST(Walk, MediaBehindASurfaceFollowTheSideOfTheNormal)
{
    Media m;
    m.s.bound(m.s.box(Vec3(-.5), Vec3(.5), m.s.bsdf({.type = Bsdf::Type::dielectric})), {.interior = m.a, .exterior = m.b});
    const int plain = m.s.square({0, 0, .9}, {0, 0, -1}, .5, 0);
    const Visibility visibility(m.s.scene, 1);
    const RayWalk walk = visibility.walk({.origin = {0, 0, -.9}, .direction = {0, 0, 1}}, m.b);
    ASSERT_TRUE(walk.found);
    EXPECT_EQ(visibility.medium_behind(walk.surface, {0, 0, 1}, walk.medium), m.a);
    EXPECT_EQ(visibility.medium_behind(walk.surface, {0, 0, -1}, walk.medium), m.b);
    const RayWalk other = visibility.walk({.origin = {0, 0, .8}, .direction = {0, 0, 1}}, m.b);
    ASSERT_EQ(other.surface.shape, plain);
    EXPECT_EQ(visibility.medium_behind(other.surface, {0, 0, 1}, m.b), m.b);
    EXPECT_GT(glm::dot(visibility.leave(other.surface, {0, 0, 1}) - other.surface.position, Vec3(0, 0, 1)), 0);
    EXPECT_LT(glm::dot(visibility.leave(other.surface, {0, 0, -1}) - other.surface.position, Vec3(0, 0, 1)), 0);
}

TEST(Walk, UnboundedMediaEndAtTheRaysEnd)
{
    Media m;
    const Visibility visibility(m.s.scene, 1);
    const RayWalk walk = visibility.walk({.origin = Vec3(0), .direction = {0, 0, 1}}, m.a);
    EXPECT_FALSE(walk.found);
    ASSERT_EQ(walk.pieces.size(), 1u);
    EXPECT_EQ(walk.pieces[0].t1, 1e30);
}

TEST(Walk, MoreBoundariesThanTheLimitAreCountedAndEndTheWalk)
{
    Media m;
    Mesh sheets;  // 5000 squares one behind the other
    for (unsigned i = 0; i < 5000; ++i) {
        const double z = .0001 * i;
        for (const Vec2 corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) sheets.vertices.push_back({corner.x, corner.y, z});
        sheets.triangles.push_back({4 * i, 4 * i + 1, 4 * i + 2}), sheets.triangles.push_back({4 * i, 4 * i + 2, 4 * i + 3});
    }
    m.s.bound(m.s.mesh(sheets, Mat4(1), m.s.null()), {.interior = m.a, .exterior = m.b});
    const Visibility visibility(m.s.scene, 1);
    EXPECT_EQ(visibility.runaway_walks(), 0u);
    visibility.walk({.origin = {.1, .2, -1}, .direction = {0, 0, 1}}, m.a);
    EXPECT_EQ(visibility.runaway_walks(), 1u);
}

}  // namespace
