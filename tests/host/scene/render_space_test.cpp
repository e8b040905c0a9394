// Render space: hard cases 23 and 24 begin here.
#include "scene/render_space.hpp"

#include <cmath>
#include <cstring>

#include "scene/describe.hpp"
#include "scene_text.hpp"

namespace tyndall::test {

/// Every number that the renderer computes with, in order: to compare bitwise.
std::vector<double> numbers_of(const Scene& scene)
{
    std::vector<double> numbers;
    const auto add = [&](const auto& v) {
        for (int i = 0; i < v.length(); ++i) numbers.push_back(v[i]);
    };
    const auto add_matrix = [&](const Mat4& m) {
        for (int c = 0; c < 4; ++c) add(m[c]);
    };
    for (const Medium& medium : scene.media) add(medium.sigma_t), add(medium.albedo);
    for (const Shape& shape : scene.shapes) {
        add_matrix(shape.to_world);
        for (const Vec3& v : shape.mesh.vertices) add(v);
        for (const Vec3& n : shape.mesh.normals) add(n);
    }
    for (const Emitter& emitter : scene.emitters) add(emitter.value), add(emitter.position), add(emitter.direction);
    add_matrix(scene.camera.to_world);
    numbers.insert(numbers.end(), {scene.camera.near_clip, scene.camera.far_clip, scene.camera.fov_x});
    return numbers;
}

bool bitwise_equal(const Scene& a, const Scene& b)
{
    const auto x = numbers_of(a), y = numbers_of(b);
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) == 0;
}

std::string triple(double x, double y, double z)
{
    char text[128];
    std::snprintf(text, sizeof text, "%.17g %.17g %.17g", x, y, z);
    return text;
}

/// A scene of every kind of shape and light, scaled by `k` about the origin and then moved by `t` along every axis.
std::string moved_scene(double k, double t)
{
    const auto at = [&](double x, double y, double z) { return triple(k * x + t, k * y + t, k * z + t); };
    const auto number = [](double x) { return triple(x, 0, 0).substr(0, triple(x, 0, 0).find(' ')); };
    const std::string place = "<scale value=\"" + number(k) + "\"/><translate value=\"" + triple(t, t, t) + "\"/>";
    return "<scene version=\"3.0.0\"><medium type=\"homogeneous\" id=\"m\"><rgb name=\"sigma_t\" value=\"" + triple(.75 / k, 1 / k, 3 / k) +
           "\"/></medium>"
           "<sensor type=\"perspective\"><float name=\"fov\" value=\"40\"/><float name=\"near_clip\" value=\"" +
           number(.125 * k) + "\"/><float name=\"far_clip\" value=\"" + number(64 * k) +
           "\"/><transform name=\"to_world\"><lookat origin=\"" + at(.5, .75, 4) + "\" target=\"" + at(0, -.25, 0) +
           "\" up=\"0 1 0\"/></transform></sensor>"
           "<shape type=\"cube\"><transform name=\"to_world\"><scale value=\"0.5 0.75 0.5\"/>" +
           place +
           "</transform><ref name=\"interior\" id=\"m\"/></shape>"
           "<shape type=\"rectangle\"><transform name=\"to_world\"><scale value=\"3\"/><rotate x=\"1\" angle=\"-90\"/><translate "
           "y=\"-1\"/>" +
           place +
           "</transform></shape>"
           "<shape type=\"sphere\"><point name=\"center\" value=\"1 -0.5 0.25\"/><float name=\"radius\" value=\"0.25\"/><transform "
           "name=\"to_world\">" +
           place +
           "</transform></shape>"
           "<shape type=\"disk\"><transform name=\"to_world\"><rotate y=\"1\" angle=\"90\"/>" +
           place +
           "</transform></shape>"
           "<shape type=\"cylinder\"><point name=\"p0\" value=\"1 0 0\"/><point name=\"p1\" value=\"1 2 0\"/><transform "
           "name=\"to_world\">" +
           place +
           "</transform></shape>"
           "<emitter type=\"point\"><rgb name=\"intensity\" value=\"" +
           triple(k * k, 2 * k * k, 3 * k * k) + "\"/><point name=\"position\" value=\"" + at(1, 2, .5) +
           "\"/></emitter>"
           "<emitter type=\"spot\"><rgb name=\"intensity\" value=\"" +
           triple(k * k, k * k, k * k) + "\"/><transform name=\"to_world\"><lookat origin=\"" + at(-1, 2, .5) + "\" target=\"" +
           at(0, 0, 0) + "\" up=\"0 1 0\"/></transform></emitter><emitter type=\"directional\"/><emitter type=\"constant\"/></scene>";
}

TEST(RenderSpace, CentreIsTheOriginAndHalfTheDiagonalIsInOneHalfToOne)
{
    for (const double k : {1., .3, 5., 1e-18, 1e18, 7e5}) {
        const Scene scene = parse(moved_scene(k, k * 3));
        const Bounds bounds = bounds_of(scene);
        EXPECT_GT(bounds.radius(), .5) << k;
        EXPECT_LE(bounds.radius(), 1 + 1e-15) << k;
        expect_near(bounds.centre(), Vec3(0), 1e-15);
        int exponent = 0;
        EXPECT_EQ(std::frexp(scene.unit, &exponent), .5) << "a power of two";
    }
}

TEST(RenderSpace, MovingByPowersOfTwoChangesNoBit)
{
    const Scene here = parse(moved_scene(1, 0));
    for (const double t : {1., -2., 1024., -1048576., std::ldexp(1., 40)}) EXPECT_TRUE(bitwise_equal(here, parse(moved_scene(1, t)))) << t;
    EXPECT_FALSE(bitwise_equal(here, parse(moved_scene(1.25, 0))));
}

TEST(RenderSpace, ScalingByPowersOfTwoChangesNoBit)
{
    const Scene here = parse(moved_scene(1, 0));
    for (const int exponent : {1, -1, 10, -20, 60, -60}) {
        const Scene there = parse(moved_scene(std::ldexp(1., exponent), 0));
        EXPECT_TRUE(bitwise_equal(here, there)) << exponent;
        EXPECT_EQ(there.unit, std::ldexp(here.unit, exponent));
    }
}

TEST(RenderSpace, AnyScaleGivesTheSameSceneWithinRounding)
{
    // 1e-18 and 1e18 are no powers of two: numbers differ by roundings, and the unit by a power of two, so compare what has no unit
    const Scene here = parse(moved_scene(1, 0));
    for (const double k : {1e-18, 1e-6, 3., 1e6, 1e18}) {
        const Scene there = parse(moved_scene(k, 0));
        const double ratio = here.unit * k / there.unit;  // 1, 1/2 or 2 times a rounding
        EXPECT_NEAR(there.media[0].sigma_t.y * ratio, here.media[0].sigma_t.y, 1e-14) << k;
        expect_near(there.shapes[0].mesh.vertices[3] / ratio, here.shapes[0].mesh.vertices[3], 1e-14);
        expect_near(there.emitters[0].value / (ratio * ratio), here.emitters[0].value, 1e-14);
        EXPECT_NEAR(there.camera.near_clip / ratio, here.camera.near_clip, 1e-14);
        EXPECT_TRUE(there.shapes[0].mesh.convex) << k;
    }
}

TEST(RenderSpace, QuantitiesFollowTheirUnits)
{
    const Scene scene = parse(moved_scene(1, 0));
    EXPECT_EQ(scene.media[0].sigma_t, Rgb(.75, 1, 3) * scene.unit);
    EXPECT_EQ(scene.emitters[0].value, Rgb(1, 2, 3) / (scene.unit * scene.unit));
    EXPECT_EQ(scene.emitters[2].value, Rgb(1)) << "irradiance has no length in it";
    EXPECT_EQ(scene.emitters[3].value, Rgb(1)) << "nor has radiance";
    EXPECT_EQ(scene.camera.far_clip * scene.unit, 64);
    EXPECT_EQ(to_file_space(scene, scene.emitters[0].position), Vec3(1, 2, .5));
}

TEST(RenderSpace, APointKeepsItsUnit)
{
    const Scene scene = parse(
        "<scene version=\"3.0.0\"><sensor type=\"perspective\"><transform name=\"to_world\"><translate "
        "x=\"7\"/></transform></sensor></scene>");
    EXPECT_EQ(scene.unit, 1);
    EXPECT_EQ(scene.centre, Vec3(7, 0, 0));
    EXPECT_EQ(Vec3(scene.camera.to_world[3]), Vec3(0));
}

TEST(RenderSpace, ExactPowersOfTwoStayInTheInterval)
{
    // half diagonal exactly 1: the interval is closed at 1, so the unit is 1 and not 2
    Scene scene;
    scene.camera.to_world[3] = glm::dvec4(-1, 0, 0, 1);
    scene.emitters.push_back({.position = Vec3(1, 0, 0)});
    to_render_space(scene);
    EXPECT_EQ(scene.unit, 1);
}

TEST(RenderSpace, WhatOverflowsIsRefused)
{
    EXPECT_NE(
        fault_of_body(
            R"(<shape type="sphere"><transform name="to_world"><scale value="1e-60"/></transform></shape><emitter type="point"><float name="intensity" value="1e300"/></emitter>)")
            .find("the intensity is too large for a scene this small"),
        std::string::npos);
    EXPECT_NE(
        fault_of_body(
            R"(<shape type="sphere"><transform name="to_world"><scale value="1e60"/></transform></shape><medium type="homogeneous"><float name="sigma_t" value="1e300"/></medium>)")
            .find("sigma_t is too large for a scene this large"),
        std::string::npos);
    EXPECT_NE(fault_of_body(R"(<shape type="sphere"><float name="radius" value="1e-101"/></shape>)").find("half diagonal"),
              std::string::npos);
}

}  // namespace tyndall::test
