#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "../transport/built_scene.hpp"
#include "transport/random_sequence.hpp"
#include "transport/warp.hpp"
#include "visibility/visibility.hpp"

using namespace tyndall;
using test::BuiltScene;

namespace {

RandomSequence numbers(std::uint64_t which) { return {7, 0, RandomStream::pilot, which}; }

Vec3 in_cube(RandomSequence& random, double half) { return half * (2.0 * Vec3(random.next(), random.next(), random.next()) - 1.0); }

TEST(Intersection, SphereIsMetWhereTheQuadraticSaysFromInsideAndOutside)
{
    BuiltScene s;
    s.sphere({.1, -.2, .3}, .4, s.diffuse(Rgb(.5)));
    const Visibility visibility(s.scene, 1);
    RandomSequence random = numbers(1);
    int met = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 o = in_cube(random, 1), d = sample_uniform_sphere(random.next2()), c = o - Vec3(.1, -.2, .3);
        const double b = glm::dot(c, d), discriminant = b * b - glm::dot(c, c) + .16;
        const double near = -b - std::sqrt(std::max(discriminant, 0.0)), far = -b + std::sqrt(std::max(discriminant, 0.0)),
                     t = near > 0 ? near : far;
        Hit hit;
        const bool found = visibility.intersect({.origin = o, .direction = d}, hit);
        ASSERT_EQ(found, discriminant > 0 && t > 0) << i;
        if (!found) continue;
        ++met;
        EXPECT_NEAR(hit.t, t, 1e-14 / std::sqrt(discriminant) + 1e-14)
            << i;  // the discriminant is off by a few 1e-16, its root by that over 2 sqrt
        EXPECT_NEAR(glm::length(hit.position - Vec3(.1, -.2, .3)), .4, 1e-15);
        EXPECT_NEAR(glm::length(hit.position - (o + hit.t * d)), 0, 1e-12);
        EXPECT_NEAR(glm::dot(hit.geometric_normal, hit.position - Vec3(.1, -.2, .3)), .4, 1e-15);
    }
    EXPECT_GT(met, 150);
}

/// The shapes as implicit surfaces in their own space.
double off_surface(Shape::Type type, const Vec3& p)
{
    if (type == Shape::Type::sphere) return glm::length(p) - 1;
    if (type == Shape::Type::cylinder) return std::hypot(p.x, p.y) - 1;
    return p.z;
}

class AnalyticShape : public testing::TestWithParam<Shape::Type> {};

TEST_P(AnalyticShape, HitsLieOnTheStretchedShapeAndNormalsPointOutwards)
{
    BuiltScene s;
    const Mat4 to_world =
        glm::rotate(glm::translate(Mat4(1), Vec3(.2, .1, -.1)), 1.1, glm::normalize(Vec3(1, 2, 3))) * glm::scale(Mat4(1), Vec3(.5, .2, .3));
    for (const bool flip : {false, true}) {
        s.scene.shapes.clear();
        s.shape({.name = "shape", .type = GetParam(), .to_world = to_world, .flip_normals = flip, .bsdf = s.diffuse(Rgb(.5))});
        const Visibility visibility(s.scene, 1);
        RandomSequence random = numbers(2);
        int met = 0;
        for (int i = 0; i < 6000; ++i) {  // enough that the order in which a compiler takes the numbers does not matter
            const Ray ray{.origin = in_cube(random, 1), .direction = sample_uniform_sphere(random.next2())};
            Hit hit;
            if (!visibility.intersect(ray, hit)) continue;
            ++met;
            const Vec3 local(glm::inverse(to_world) * glm::dvec4(hit.position, 1));
            EXPECT_NEAR(off_surface(GetParam(), local), 0, 1e-14);
            EXPECT_LT(glm::length(hit.position - ray.origin - hit.t * ray.direction), 1e-9);
            // central difference along the normal: the implicit function grows outwards
            const auto value = [&](double h) {
                return off_surface(GetParam(), Vec3(glm::inverse(to_world) * glm::dvec4(hit.position + h * hit.geometric_normal, 1)));
            };
            const Vec3 tangent = glm::normalize(glm::cross(hit.geometric_normal, Vec3(.3, .5, .8)));
            const double along = off_surface(GetParam(), Vec3(glm::inverse(to_world) * glm::dvec4(hit.position + 1e-6 * tangent, 1)));
            EXPECT_GT((value(1e-6) - value(-1e-6)) * (flip ? -1 : 1), 1e-6);
            EXPECT_LT(std::abs(along), 1e-9) << "normal is not perpendicular";
        }
        EXPECT_GT(met, 100);
    }
}

INSTANTIATE_TEST_SUITE_P(Types, AnalyticShape, testing::Values(Shape::Type::sphere, Shape::Type::disk, Shape::Type::cylinder));

TEST(Intersection, CylinderAndDiskHaveEdges)
{
    BuiltScene s;
    s.shape({.name = "cylinder", .type = Shape::Type::cylinder, .bsdf = s.diffuse(Rgb(.5))});
    s.shape({.name = "disk", .type = Shape::Type::disk, .to_world = glm::translate(Mat4(1), Vec3(0, 0, 3)), .bsdf = 0});
    const Visibility visibility(s.scene, 1);
    Hit hit;
    EXPECT_FALSE(visibility.intersect({.origin = {-2, 0, 1.001}, .direction = {1, 0, 0}}, hit));
    ASSERT_TRUE(visibility.intersect({.origin = {-2, 0, .999}, .direction = {1, 0, 0}}, hit));
    EXPECT_DOUBLE_EQ(hit.t, 1);
    EXPECT_FALSE(visibility.intersect({.origin = {1.001, 0, 2}, .direction = {0, 0, 1}}, hit));
    ASSERT_TRUE(visibility.intersect({.origin = {.999, 0, 2}, .direction = {0, 0, 1}}, hit));
    EXPECT_DOUBLE_EQ(hit.t, 1);
}

TEST(Intersection, TrianglesAreMetInDouble)
{
    BuiltScene s;
    s.square({0, 0, .7}, {0, 0, -1}, .5, s.diffuse(Rgb(.5)));
    const Visibility visibility(s.scene, 1);
    RandomSequence random = numbers(3);
    for (int i = 0; i < 500; ++i) {
        const Vec3 o = in_cube(random, .4), target(random.next() - .5, random.next() - .5, .7), d = glm::normalize(target - o);
        Hit hit;
        ASSERT_TRUE(visibility.intersect({.origin = o, .direction = d}, hit));
        EXPECT_NEAR(hit.t, (.7 - o.z) / d.z, 1e-14);
        EXPECT_NEAR(hit.position.z, .7, 1e-15);
        EXPECT_EQ(hit.geometric_normal, Vec3(0, 0, -1));
    }
}

TEST(Intersection, ShadingNormalsAreInterpolatedOnTheSideOfTheGeometricOne)
{
    BuiltScene s;
    const int shape = s.square({0, 0, 0}, {0, 0, 1}, 1, s.diffuse(Rgb(.5)));
    Mesh& mesh = s.scene.shapes[shape].mesh;
    for (const Vec3& p : mesh.vertices) mesh.normals.push_back(glm::normalize(Vec3(.5 * p.x, .5 * p.y, 1)));
    const Visibility visibility(s.scene, 1);
    Hit hit;
    ASSERT_TRUE(visibility.intersect({.origin = {0, 0, 1}, .direction = {0, 0, -1}}, hit));
    EXPECT_NEAR(glm::length(hit.shading_normal - Vec3(0, 0, 1)), 0, 1e-12);
    s.scene.shapes[shape].flip_normals = true;
    ASSERT_TRUE(visibility.intersect({.origin = {.3, 0, 1}, .direction = {0, 0, -1}}, hit));
    EXPECT_LT(hit.shading_normal.z, 0);
    EXPECT_LT(hit.geometric_normal.z, 0);
}

TEST(Intersection, NumbersThatAreNotFiniteMeetNothingAndAreCounted)
{
    BuiltScene s;
    s.sphere({0, 0, 0}, 1, s.diffuse(Rgb(.5)));
    const Visibility visibility(s.scene, 1);
    Hit hit;
    EXPECT_FALSE(visibility.intersect({.origin = {NAN, 0, 0}, .direction = {0, 0, 1}}, hit));
    EXPECT_FALSE(visibility.intersect({.origin = {0, 0, 0}, .direction = {0, INFINITY, 1}}, hit));
    EXPECT_EQ(visibility.invalid_rays(), 2u);
}

TEST(Intersection, MovedVisibilityStillSees)
{
    BuiltScene s;
    s.sphere({0, 0, 0}, 1, s.diffuse(Rgb(.5)));
    Visibility first(s.scene, 1);
    const Visibility second = std::move(first);
    Hit hit;
    EXPECT_TRUE(second.intersect({.origin = {0, 0, -3}, .direction = {0, 0, 1}}, hit));
}

}  // namespace
