// Textures where rays meet shapes: every shape's own map, and what surfaces make of the colour that is looked up.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "built_scene.hpp"
#include "transport/bsdf.hpp"
#include "transport/surface_place.hpp"

namespace tyndall::test {
namespace {

Hit hit_of(const BuiltScene& built, const Vec3& origin, const Vec3& direction)
{
    const Visibility visibility(built.scene, 1);
    Hit hit;
    EXPECT_TRUE(visibility.intersect({.origin = origin, .direction = glm::normalize(direction)}, hit));
    return hit;
}

/// The corners' coordinates as Mitsuba 3.9.1 lists them for its cube, linear between: by face, what u and v are at a point (x, y, z).
TEST(TexturePlace, CubeIsMappedFaceByFace)
{
    BuiltScene built;
    built.box(Vec3(-1), Vec3(1), built.diffuse(Rgb(.5)));
    const double a = .3, b = -.6;
    struct Row {
        Vec3 point;
        Vec2 uv;
    };
    const Row rows[] = {{{-1, a, b}, {(1 + a) / 2, (1 + b) / 2}}, {{1, a, b}, {(1 + a) / 2, (1 - b) / 2}}, {{a, -1, b}, {(1 + b) / 2, (1 + a) / 2}},
                        {{a, 1, b}, {(1 - a) / 2, (1 - b) / 2}}, {{a, b, -1}, {(1 - b) / 2, (1 + a) / 2}}, {{a, b, 1}, {(1 + b) / 2, (1 + a) / 2}}};
    for (const Row& row : rows) {
        Vec3 outwards(0);
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(row.point[axis]) == 1) outwards[axis] = row.point[axis];
        const Vec2 uv = place_on_surface(built.scene, hit_of(built, row.point + outwards, -outwards)).uv;
        EXPECT_NEAR(uv.x, row.uv.x, 1e-12);
        EXPECT_NEAR(uv.y, row.uv.y, 1e-12);
    }
}

TEST(TexturePlace, RectangleSphereDiskAndCylinder)
{
    BuiltScene built;
    const int grey = built.diffuse(Rgb(.5));
    built.mesh(rectangle_mesh(), Mat4(1), grey);
    const Vec2 flat = place_on_surface(built.scene, hit_of(built, {.5, -.5, 3}, {0, 0, -1})).uv;
    EXPECT_NEAR(flat.x, .75, 1e-12);
    EXPECT_NEAR(flat.y, .25, 1e-12);
    BuiltScene ball;
    ball.sphere({1, 2, 3}, .5, ball.diffuse(Rgb(.5)));
    const Vec2 side = place_on_surface(ball.scene, hit_of(ball, {1, 4, 3}, {0, -1, 0})).uv;  // local +y: a quarter turn, half way down from +z
    EXPECT_NEAR(side.x, .25, 1e-9);
    EXPECT_NEAR(side.y, .5, 1e-9);
}

class PaintedFloor : public testing::Test {
protected:
    /// A floor, [-1, 1]^2 in z = 0, whose texture is black for u < 1/2 and red beyond.
    PaintedFloor()
    {
        built.scene.textures.push_back({.width = 2, .channels = 3, .texels = {0, 0, 0, .5f, 0, 0}, .filter = Texture::Filter::nearest, .largest = {.5, 0, 0}});
    }
    Bsdf painted(Bsdf::Type type) const { return {.type = type, .reflectance = {.5, 0, 0}, .reflectance_texture = 0}; }
    Hit at(double x) const { return hit_of(built, {x, 0, 1}, {0, 0, -1}); }

    BuiltScene built;
};

TEST_F(PaintedFloor, EveryQuestionAboutADiffuseSurfaceUsesTheColourThere)
{
    built.mesh(rectangle_mesh(), Mat4(1), built.bsdf(painted(Bsdf::Type::diffuse)));
    for (const double x : {-.5, .5}) {
        const Rgb colour = x < 0 ? Rgb(0) : Rgb(.5, 0, 0);
        const Hit hit = at(x);
        const Arrival arrival{.hit = hit, .in = {0, 0, -1}};
        const Vec3 out = glm::normalize(Vec3(.3, .4, 1));
        EXPECT_EQ(diffuse_reflectance(built.scene, hit, arrival.in), colour);
        EXPECT_EQ(sample_bsdf(built.scene, arrival, {.3, .6}).weight, colour);
        EXPECT_NEAR(glm::length(evaluate_bsdf(built.scene, arrival, out) - colour * (out.z / 3.14159265358979323846)), 0, 1e-12);
    }
}

TEST_F(PaintedFloor, MirrorsAndTheBackOfATwoSidedSurfaceToo)
{
    Bsdf mirror = painted(Bsdf::Type::conductor), back = painted(Bsdf::Type::diffuse);
    mirror.two_sided = true, mirror.back = 1;
    built.mesh(rectangle_mesh(), Mat4(1), built.bsdf(mirror));
    built.bsdf(back);
    EXPECT_NEAR(sample_specular(built.scene, {.hit = at(.5), .in = {0, 0, -1}}, {.3, .6}).weight.r, .5, 1e-12);
    EXPECT_EQ(sample_specular(built.scene, {.hit = at(-.5), .in = {0, 0, -1}}, {.3, .6}).weight.r, 0);
    EXPECT_EQ(diffuse_reflectance(built.scene, at(.5), {0, 0, 1}), Rgb(.5, 0, 0));
    EXPECT_EQ(diffuse_reflectance(built.scene, at(-.5), {0, 0, 1}), Rgb(0));
}

TEST_F(PaintedFloor, PlasticsAndGlassToo)
{
    Bsdf plastic{.type = Bsdf::Type::rough_plastic, .eta = 1.5, .diffuse = {.5, 0, 0}, .diffuse_texture = 0};
    built.mesh(rectangle_mesh(), Mat4(1), built.bsdf(plastic));
    EXPECT_EQ(diffuse_reflectance(built.scene, at(.5), {0, 0, -1}), Rgb(.5, 0, 0));
    EXPECT_EQ(diffuse_reflectance(built.scene, at(-.5), {0, 0, -1}), Rgb(0));
    BuiltScene sheet;
    sheet.scene.textures = built.scene.textures;
    sheet.mesh(rectangle_mesh(), Mat4(1), sheet.bsdf({.type = Bsdf::Type::thin_dielectric, .reflectance = Rgb(0), .specular_transmittance = {.5, 0, 0}, .eta = 1.5, .transmittance_texture = 0}));
    const auto passed = [&](double x) { return sample_bsdf(sheet.scene, {.hit = hit_of(sheet, {x, 0, 1}, {0, 0, -1}), .in = {0, 0, -1}}, {.5, .5}).weight; };
    const double share = 1 - 2 * .04 / 1.04;  // both faces of the sheet, at normal incidence
    EXPECT_NEAR(passed(.5).r, .5 * share, 1e-12);
    EXPECT_EQ(passed(-.5).r, 0);
}

}  // namespace
}  // namespace tyndall::test
