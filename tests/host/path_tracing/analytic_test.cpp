#include "rendered.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

/// One pixel so narrow that it is a ray (the radiance changes by less than 1e-6 across it).
constexpr double narrow = 1e-7;

double hg(double g, double mu) { return (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * mu, 1.5)); }

struct PointInFog {
    BuiltScene s;
    Vec3 light{.1, .3, .05}, eye{-.8, 0, 0};
    double sigma_t, sigma_s, g;

    PointInFog(double extinction, double albedo, double asymmetry) : sigma_t(extinction), sigma_s(extinction * albedo), g(asymmetry)
    {
        const int fog = s.medium(Rgb(sigma_t), Rgb(albedo), g);
        s.container(Vec3(-.5), Vec3(.5), {.interior = fog});
        s.point(light, Rgb(2), fog);
        s.camera(eye, {1, 0, 0}, 1, narrow);
    }
    /// Integral along the ray of phase x transmittances / distance^2; the light is inside the fog, so is its whole path.
    double expected() const
    {
        const auto f = [&](long double x) {
            const Vec3 to_light = light - Vec3(double(x), 0, 0);
            const double w = glm::length(to_light);
            return (long double)(sigma_s * std::exp(-sigma_t * (double(x) + .5)) * hg(g, to_light.x / w) * std::exp(-sigma_t * w) * 2 /
                                 (w * w));
        };
        return double(integrate(f, -.5, .5, 1e-12L));
    }
};

TEST(SingleScattering, OfAPointLightMatchesQuadratureBothWays)
{
    for (const double sigma : {1e-6, .3, 2., 15.})
        for (const double g : {0., .6, -.3}) {
            const PointInFog fog(sigma, .8, g);
            const Rendered by_light = render(fog.s.scene, {.layers = only(Layer::single), .passes = 20000, .single_by_light = true});
            expect_mean(by_light.image, fog.expected(), "equi-angular");
            EXPECT_LT(by_light.image.error(), .02 * fog.expected());
            if (sigma < 1e-3) continue;  // path tracing meets too few particles to say anything
            const Rendered by_path = render(fog.s.scene, {.layers = only(Layer::single), .passes = 50000});
            expect_mean(by_path.image, fog.expected(), "path tracing");
            EXPECT_LT(by_path.image.error(), .05 * fog.expected());
        }
}

TEST(SingleScattering, BothWaysAgreeForEveryKindOfLightAndColour)
{
    for (const std::string kind : {"area", "spot", "directional", "constant"}) {
        BuiltScene s;
        const int fog = s.medium({1, 3, 8}, {.9, .5, .7}, .4), grey = s.diffuse(Rgb(0));
        s.container(Vec3(-.5), Vec3(.5), {.interior = fog});
        s.box({-.1, .1, -.1}, {.1, .2, .1}, grey);  // an occluder
        if (kind == "area") s.glow(s.square({0, .8, 0}, {0, -1, 0}, .2, grey), Rgb(5));
        if (kind == "spot")
            s.emitter({.type = Emitter::Type::spot,
                       .value = Rgb(5),
                       .position = {.1, .8, -.1},
                       .direction = {0, -1, 0},
                       .cutoff = .6,
                       .beam = .3});
        if (kind == "directional")
            s.emitter({.type = Emitter::Type::directional, .value = Rgb(1), .direction = glm::normalize(Vec3(.3, -1, .2))});
        if (kind == "constant") s.constant(Rgb(1));
        s.camera({0, 0, -1.2}, {0, 0, 1}, 8, .8);
        for (const int channel : {0, 1, 2}) {
            const Rendered a = render(s.scene, {.layers = only(Layer::single), .passes = 800, .channel = channel, .single_by_light = true});
            const Rendered b = render(s.scene, {.layers = only(Layer::single), .passes = 800, .channel = channel});
            expect_same(a.image, b.image, kind.c_str());
            EXPECT_LT(a.image.error() + b.image.error(), .06 * a.image.value()) << kind << ": test is too weak";
        }
    }
}

TEST(SingleScattering, AnUnboundedMediumEndsWhereFloatIsZero)
{
    BuiltScene s;
    const int fog = s.medium(Rgb(1.5), Rgb(.8));
    s.point({.3, .2, .4}, Rgb(1), fog);
    s.camera({0, 0, -.5}, {0, 0, 1}, 1, narrow, fog);
    s.scene.camera.far_clip = 1e30;
    const auto f = [&](long double u) {
        const double w = glm::length(Vec3(.3, .2, .9 - double(u)));
        return (long double)(1.2 / (4 * pi) * std::exp(-1.5 * (double(u) + w)) / (w * w));
    };
    const double expected = double(integrate(f, 0, 30, 1e-13L));
    for (const bool by_light : {true, false}) {
        const Rendered r = render(s.scene, {.layers = only(Layer::single), .passes = 30000, .single_by_light = by_light});
        expect_mean(r.image, expected);
        EXPECT_LT(r.image.error(), .03 * expected);
    }
}

TEST(SurfaceDirect, OfASquareMatchesItsFormFactor)
{
    BuiltScene s;
    const int grey = s.diffuse(Rgb(.6));
    s.square({0, 0, 0}, {0, 1, 0}, 1, grey);
    s.glow(s.square({.3, .7, .1}, {0, -1, 0}, .4, grey), Rgb(3));
    s.camera({-.6, .4, -.8}, glm::normalize(Vec3(.6, -.4, .8)), 1, narrow);
    // the point below sees a parallel rectangle: four quarters with a common corner above it [Howell, configuration factors, A-1]
    const auto quarter = [](double a, double b) {
        const double x = a / .7, y = b / .7, p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
        return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * pi);
    };
    const double x0 = .3 - .4, x1 = .3 + .4, z0 = .1 - .4, z1 = .1 + .4;
    const double factor = quarter(x1, z1) - quarter(x0, z1) - quarter(x1, z0) + quarter(x0, z0);
    const Rendered r = render(s.scene, {.layers = only(Layer::surface_direct), .passes = 40000});
    expect_mean(r.image, .6 * 3 * factor);
    EXPECT_LT(r.image.error(), .01 * r.image.value());
}

TEST(SurfaceDirect, IsAttenuatedByTheFogOnBothWays)
{
    BuiltScene s;
    const int fog = s.medium({.5, 1, 2}, Rgb(0)), grey = s.diffuse(Rgb(.6));
    s.square({0, 0, 0}, {0, 1, 0}, 1, grey);
    s.container({-.5, .1, -.5}, {.5, .4, .5}, {.interior = fog});
    s.point({0, .8, 0}, Rgb(1));
    s.camera({.3, .9, 0}, glm::normalize(Vec3(-.3, -.9, 0)), 1, narrow);
    const double slant = std::hypot(.3, .9) / .9 * .3;  // through the slab of fog
    for (const int channel : {0, 1, 2}) {
        const double sigma = s.scene.media[fog].sigma_t[channel];
        const Rendered r = render(s.scene, {.layers = only(Layer::surface_direct), .passes = 20000, .channel = channel});
        expect_mean(r.image, .6 / pi / .64 * std::exp(-sigma * (.3 + slant)));
    }
}

TEST(Emitted, ConstantLightThroughFogIsItsTransmittance)
{
    BuiltScene s;
    s.container(Vec3(-.5), Vec3(.5), {.interior = s.medium({.5, 1, 2}, Rgb(.5))});
    s.constant(Rgb(3));
    s.camera({0, 0, -1.2}, {0, 0, 1}, 1, narrow);
    for (const int channel : {0, 1, 2}) {
        const Rendered r = render(s.scene, {.layers = only(Layer::emitted), .passes = 2, .channel = channel});
        EXPECT_NEAR(r.image.value(), 3 * std::exp(-s.scene.media[0].sigma_t[channel]), 1e-6);
    }
}

TEST(Glass, ASpotOfLightBehindAPaneIsSeenThroughTwoFresnelFaces)
{
    BuiltScene s;
    const int glass = s.bsdf({.type = Bsdf::Type::dielectric, .reflectance = Rgb(1), .eta = 1.5});
    s.box({-1, -1, 0}, {1, 1, .1}, glass);
    s.glow(s.square({0, 0, .5}, {0, 0, -1}, .5, s.diffuse(Rgb(0))), Rgb(2));
    s.camera({0, 0, -.5}, {0, 0, 1}, 1, narrow);
    // a pane at normal incidence passes (1 - R)^2 / (1 - R^2) = (1 - R) / (1 + R); what it reflects sees nothing
    const Rendered r = render(s.scene, {.layers = only(Layer::emitted), .passes = 20000});
    expect_mean(r.image, 2 * (1 - .04) / (1 + .04));
}

}  // namespace
