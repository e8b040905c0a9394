/// Double scattering of a point source of unit power in an isotropic medium without end, against quadrature.
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

struct Fog {
    double sigma_t, albedo;
    double sigma_s() const { return sigma_t * albedo; }
};

/// Fluence of light scattered once, at distance r. With the sum xi r and the difference of the distances to source and receiver as
/// coordinates (confocal to both), the integral over the scattering point is (sigma_s / 4 pi r) int_1^inf exp(-sigma_t r xi) ln((xi + 1) /
/// (xi - 1)) / xi d xi; here xi = 1 / t.
double fluence_of_first_order(const Fog& fog, double r)
{
    const auto f = [&](long double t) { return std::exp(-fog.sigma_t * r / t) * std::log((1 + t) / (1 - t)) / t; };
    return fog.sigma_s() / (4 * pi * r) * double(integrate(f, 0, 1, 1e-11L, 40));
}

/// The same as the Fourier integral (1 / 2 pi^2 r) int k sin(kr) A (sigma_s A) dk with A = atan(k / sigma_t) / k: half waves in x = kr,
/// whose alternating sum is averaged until it stands still.
double fluence_by_fourier(const Fog& fog, double r)
{
    const auto f = [&](long double x) {
        const long double a = std::atan(x / (fog.sigma_t * r));
        return std::sin(x) * a * a / x;
    };
    std::vector<long double> sums;
    long double sum = 0;
    constexpr long double half_wave = 3.14159265358979323846264338327950288L;
    for (int n = 0; n < 60; ++n) {
        sum += integrate(f, n * half_wave, (n + 1) * half_wave, 1e-16L, 30);
        if (n >= 20) sums.push_back(sum);
    }
    for (; sums.size() > 1; sums.pop_back())
        for (std::size_t i = 0; i + 1 < sums.size(); ++i) sums[i] = (sums[i] + sums[i + 1]) / 2;
    return fog.sigma_s() / (2 * pi * pi * r) * double(sums.front());
}

/// Radiance at `origin` from direction `d` (unit) of light scattered exactly twice; the source is at 0.
double radiance_of_second_order(const Fog& fog, const Vec3& origin, const Vec3& d)
{
    const auto f = [&](long double u) {
        return (long double)(std::exp(-fog.sigma_t * double(u)) * fog.sigma_s() / (4 * pi) *
                             fluence_of_first_order(fog, glm::length(origin + double(u) * d)));
    };
    const double foot = std::max(-glm::dot(origin, d), 0.0), end = foot + 40 / fog.sigma_t;  // e^-40 is left out
    return double(integrate(f, 0, foot, 1e-9L, 20) + integrate(f, foot, foot + 1, 1e-9L, 20) + integrate(f, foot + 1, end, 1e-9L, 20));
}

TEST(PointSourceInEndlessFog, TwoFormulasOfTheFirstOrderAgree)
{
    for (const double sigma : {.2, 1., 5.})
        for (const double r : {.1, 1., 3.}) {
            const Fog fog{sigma, .7};
            const double direct = fluence_of_first_order(fog, r);
            EXPECT_NEAR(fluence_by_fourier(fog, r), direct, 1e-8 * direct + 1e-10) << sigma << ' ' << r;
        }
}

TEST(PointSourceInEndlessFog, FirstOrderTendsToItsThinLimit)
{
    const Fog thin{1e-7, 1};
    EXPECT_NEAR(fluence_of_first_order(thin, 2), pi * 1e-7 / (16 * 2), 1e-4 * pi * 1e-7 / 32);  // relative deviation of order sigma r log
}

class PointSourceSeenFrom : public testing::TestWithParam<std::tuple<Fog, Vec3, Vec3>> {};

TEST_P(PointSourceSeenFrom, ShowsItsSecondOrder)
{
    const auto& [fog, origin, target] = GetParam();
    const Scene scene = scene_of(medium("fog", Rgb(fog.sigma_t), Rgb(fog.albedo)) + point_light(Vec3(0), Rgb(1 / (4 * pi)), "fog") +
                                 sensor({.origin = origin, .target = target, .fov = 1e-4, .pixels = 4, .medium = "fog", .far_clip = 1e30}));
    const double expected = radiance_of_second_order(fog, origin, glm::normalize(target - origin));
    for (const std::uint64_t seed : {1, 2, 3}) {
        RenderSettings settings{
            .layers = only(Layer::media_to_media), .passes = 700, .lights = 256, .seed = seed, .light_segments = LightSegments::first};
        const WholeRender r = render_whole(scene, settings);
        expect_mean(r(Layer::media_to_media), expected, "first segments only");
        EXPECT_LT(r(Layer::media_to_media).error(), .012 * expected) << "the test is too weak";
        EXPECT_EQ(r.report().shadow_segments, 0u);
        if (seed > 1) continue;
        settings.light_segments = LightSegments::all, settings.max_depth = 3;
        expect_mean(render_whole(scene, settings)(Layer::media_to_media), expected, "max depth 3");
    }
}

// Beside the source, away from it, past it at a thousandth of the distance, from close by, in thin and in thick fog.
INSTANTIATE_TEST_SUITE_P(Views, PointSourceSeenFrom,
                         testing::Values(std::tuple{Fog{.5, .9}, Vec3(-1.5, 0, 0), Vec3(0, .5, 0)},
                                         std::tuple{Fog{.5, .9}, Vec3(-1.5, 0, 0), Vec3(-3, .2, .1)},
                                         std::tuple{Fog{1, .6}, Vec3(0, 1, .2), Vec3(.001, 0, 0)},
                                         std::tuple{Fog{.1, 1}, Vec3(.2, .1, .1), Vec3(1, 1, 0)},
                                         std::tuple{Fog{4, .8}, Vec3(0, 0, 1), Vec3(.4, .3, 0)}));

// A glowing ball: path tracing has no finite variance near a point source.
TEST(GlowingBallInEndlessFog, AllOrdersAreWhatPathTracingFinds)
{
    const Scene scene = scene_of(medium("fog", Rgb(.3, .6, 1), Rgb(.5), .4) + sphere(Vec3(0), .25, diffuse(Rgb(0)) + glow(Rgb(1), "fog")) +
                                 sensor({.origin = {-1.5, 0, 0}, .target = {0, .5, 0}, .pixels = 8, .medium = "fog", .far_clip = 1e30}));
    const RenderSettings vrl{.layers = only(Layer::media_to_media), .passes = 500, .lights = 256};
    RenderSettings path = vrl;
    path.method = Method::path, path.passes = 10000;
    const WholeRender a = render_whole(scene, vrl), b = render_whole(scene, path);
    for (const int channel : {0, 1, 2}) expect_layers_agree(a, b, {Layer::media_to_media}, .02, channel);
}

}  // namespace
