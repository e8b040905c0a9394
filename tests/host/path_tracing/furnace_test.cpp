#include "rendered.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

void expect_uniform(const BuiltScene& s, double radiance, const RenderPlan& plan = {})
{
    const Rendered r = render(s.scene, plan);
    expect_mean(r.image, radiance, "image");
    for (std::size_t i = 0; i < r.pixels.size(); ++i) expect_mean(r.pixels[i], radiance, ("pixel " + std::to_string(i)).c_str());
    EXPECT_LT(r.image.error(), .01 * radiance) << "test is too weak";
}

TEST(WhiteFurnace, AMediumThatOnlyScattersIsInvisible)
{
    for (const double g : {0., .7, -.4})
        for (const double sigma : {.5, 8.}) {
            BuiltScene s;
            const int fog = s.medium({sigma, 2 * sigma, 3 * sigma}, Rgb(1), g);
            s.bound(s.sphere(Vec3(0), .5, s.null()), {.interior = fog});
            s.constant(Rgb(1));
            s.camera({0, 0, -1.2}, {0, 0, 1}, 8, 1);
            expect_uniform(s, 1);
        }
}

TEST(WhiteFurnace, ThinMediaInsideThickOnesAreInvisible)
{
    BuiltScene s;
    const int fog = s.medium(Rgb(3), Rgb(1), .3), haze = s.medium(Rgb(.2), Rgb(1));
    s.container(Vec3(-.5), Vec3(.5), {.interior = fog});
    s.container({-.5, -.2, -.2}, {.3, .2, .5}, {.interior = haze, .exterior = fog});  // shares two faces
    s.constant(Rgb(1));
    s.camera({0, .1, -1.2}, {0, 0, 1}, 8, 1);
    expect_uniform(s, 1);
}

TEST(WhiteFurnace, WhiteSurfacesAreInvisibleInFogAndOut)
{
    BuiltScene s;
    const int fog = s.medium(Rgb(2), Rgb(1), .5), white = s.bsdf({.reflectance = Rgb(1), .two_sided = true});
    s.container(Vec3(-.5), Vec3(.5), {.interior = fog});
    s.sphere({.1, 0, 0}, .2, white), s.square({0, -.5, 0}, {0, 1, 0}, .8, white), s.box({.4, -.3, -.3}, {.7, 0, .1}, white);
    s.constant(Rgb(1));
    s.camera({0, .1, -1.2}, {0, 0, 1}, 8, 1);
    expect_uniform(s, 1);
}

TEST(WhiteFurnace, GlassAndMirrorsAreInvisible)
{
    BuiltScene s;
    const int glass = s.bsdf({.type = Bsdf::Type::dielectric, .reflectance = Rgb(1), .eta = 1.5}),
              mirror = s.bsdf({.type = Bsdf::Type::conductor, .reflectance = Rgb(1), .conductor_eta = Rgb(0), .conductor_k = Rgb(1)});
    s.sphere({-.25, 0, 0}, .25, glass), s.box({.1, -.2, -.1}, {.4, .2, .3}, glass), s.sphere({.1, .5, 0}, .2, mirror);
    s.constant(Rgb(1));
    s.camera({0, .1, -1.2}, {0, 0, 1}, 8, 1);
    expect_uniform(s, 1);
}

TEST(WhiteFurnace, FogInsideAGlassSphereIsInvisible)
{
    BuiltScene s;
    const int fog = s.medium(Rgb(2), Rgb(1), .3);
    s.bound(s.sphere(Vec3(0), .5, s.bsdf({.type = Bsdf::Type::dielectric, .reflectance = Rgb(1), .eta = 1.33})), {.interior = fog});
    s.constant(Rgb(1));
    s.camera({0, 0, -1.2}, {0, 0, 1}, 6, 1);
    expect_uniform(s, 1, {.passes = 512});
}

// Walls that emit 1 and reflect 1/2: 1 + 1/2 + 1/4 ... = 2 everywhere, fog or not.
TEST(WhiteFurnace, AGlowingRoomSettlesAtEmissionOverAbsorption)
{
    for (const double sigma : {0., 1.5}) {
        BuiltScene s;
        const int fog = s.medium(Rgb(sigma), Rgb(1), .2), half = s.diffuse(Rgb(.5));
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1., 1.}) {
                Vec3 normal(0);
                normal[axis] = side;
                s.glow(s.square(.5 * normal, -normal, .5, half), Rgb(1), fog);
            }
        s.camera({.1, -.1, -.4}, {0, 0, 1}, 6, 1.5, fog);
        expect_uniform(s, 2);
    }
}

TEST(WhiteFurnace, ASmallAbsorptionIsNotLostByRussianRoulette)
{
    // one colour absorbs, two do not: their difference is the albedo's, the same paths carry all three
    BuiltScene s;
    const int fog = s.medium(Rgb(6), {1, .9, 0});
    s.bound(s.sphere(Vec3(0), .5, s.null()), {.interior = fog});
    s.constant(Rgb(1));
    s.camera({0, 0, -1.2}, {0, 0, 1}, 4, .3);
    const double white = render(s.scene, {.channel = 0}).image.value(), grey = render(s.scene, {.channel = 1}).image.value(),
                 black = render(s.scene, {.channel = 2}).image.value();
    EXPECT_NEAR(white, 1, .02);
    EXPECT_LT(grey, .9);
    EXPECT_GT(grey, black);
    // straight through: exp(-6 chord); the narrow view sees chords of at least .9
    EXPECT_LT(black, std::exp(-6 * .9));
}

}  // namespace
