#include "../path_tracing/rendered.hpp"
#include "grid_scene.hpp"
#include "path_tracing/scatter_distances.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

constexpr double narrow = 1e-7;  ///< a field of view in which the radiance does not change

/// A lamp in blotches of smoke, seen along one ray.
struct LampInSmoke {
    BuiltScene s;
    Vec3 light{.1, .3, .05}, eye{-.9, .04, -.03};
    int volume, albedo_volume, smoke;

    explicit LampInSmoke(double sigma)
        : volume(add_volume(s, {5, 4, 6}, turned_box({1, .8, 1.2}), blotches)),
          albedo_volume(add_volume(s, {2, 1, 3}, turned_box({1, .8, 1.2}), [](int, const glm::ivec3& v) { return .2 + .3 * v.x + .1 * v.z; })),
          smoke(add_grid_medium(s, volume, Rgb(sigma), Rgb(.7)))
    {
        s.scene.media[std::size_t(smoke)].albedo_volume = albedo_volume;
        s.container(Vec3(-.8), Vec3(.8), {.interior = smoke});
        s.point(light, Rgb(2), smoke);
        s.camera(eye, {1, 0, 0}, 1, narrow);
    }
    double sigma() const { return s.scene.media[std::size_t(smoke)].sigma_t.x; }
    /// Integral along the ray of scattering x transmittances / distance^2 / 4 pi, by a plain sum.
    double expected() const
    {
        const Volume &density = s.scene.volumes[std::size_t(volume)], &albedo = s.scene.volumes[std::size_t(albedo_volume)];
        constexpr int steps = 2000;
        double sum = 0, depth = 0;
        for (int i = 0; i < steps; ++i) {
            const Vec3 x = eye + Vec3((i + .5) / steps * 1.8, 0, 0), to_light = light - x;
            const double step = 1.8 / steps, w = glm::length(to_light), through = sigma() * plain_value(density, 0, x) * step;
            if (through > 0) {
                const double arriving = std::exp(-sigma() * plain_integral(density, 0, x, to_light / w, 0, w, 400));
                sum += std::exp(-depth - .5 * through) * through * plain_value(albedo, 0, x) * arriving * 2 / (4 * pi * w * w);
            }
            depth += through;
        }
        return sum;
    }
};

TEST(GridSingleScattering, OfAPointLightMatchesQuadratureBothWays)
{
    for (const double sigma : {.01, 1., 6.}) {
        const LampInSmoke lamp(sigma);
        const double expected = lamp.expected();
        const Rendered by_light = render(lamp.s.scene, {.layers = only(Layer::single), .passes = 20000, .single_by_light = true});
        EXPECT_NEAR(by_light.image.value(), expected, allowed_sigmas * by_light.image.error() + 2e-3 * expected) << sigma << ", towards the lamp";
        EXPECT_LT(by_light.image.error(), .02 * expected);
        if (sigma < .1) continue;  // path tracing meets too few particles to say anything
        const Rendered by_path = render(lamp.s.scene, {.layers = only(Layer::single), .passes = 50000});
        EXPECT_NEAR(by_path.image.value(), expected, allowed_sigmas * by_path.image.error() + 2e-3 * expected) << sigma << ", by paths";
        EXPECT_LT(by_path.image.error(), .05 * expected);
    }
}

TEST(GridSingleScattering, BothWaysAgreeForEveryKindOfLightAndColour)
{
    for (const std::string kind : {"area", "directional", "constant"}) {
        BuiltScene s;
        const int volume = add_volume(s, {4, 3, 4}, turned_box({1, .8, 1.2}), blotches, 3), smoke = add_grid_medium(s, volume, {1, 3, 6}, {.9, .5, .7}, .4);
        s.container(Vec3(-.8), Vec3(.8), {.interior = smoke});
        if (kind == "area") s.glow(s.square({0, .95, 0}, {0, -1, 0}, .2, s.diffuse(Rgb(0))), Rgb(5));
        if (kind == "directional") s.emitter({.type = Emitter::Type::directional, .value = Rgb(1), .direction = glm::normalize(Vec3(.3, -1, .2))});
        if (kind == "constant") s.constant(Rgb(1));
        s.camera({0, 0, -1.4}, {0, 0, 1}, 8, .8);
        for (const int channel : {0, 2}) {
            const Rendered a = render(s.scene, {.layers = only(Layer::single), .passes = 600, .channel = channel, .single_by_light = true});
            const Rendered b = render(s.scene, {.layers = only(Layer::single), .passes = 600, .channel = channel});
            expect_same(a.image, b.image, kind.c_str());
            EXPECT_LT(a.image.error() + b.image.error(), .06 * a.image.value()) << kind << ": test is too weak";
        }
    }
}

/// Draws follow the density, which integrates to one, in coloured blotches with empty cells between them.
TEST(ScatterDistances, FollowTheirDensityInGrids)
{
    BuiltScene s;
    const int volume = add_volume(s, {8, 3, 5}, turned_box({1, .8, 1.2}), blotches, 3), smoke = add_grid_medium(s, volume, {.5, 3, 9}, {.9, .8, .3});
    const MediumLine line{.medium = s.scene.media[std::size_t(smoke)], .origin = {-.9, .11, -.07}, .direction = glm::normalize(Vec3(1, -.1, .12)), .t0 = 0, .t1 = 2};
    const ScatterDistances distances(s.scene, line, {1, .5, 2}, optical_depth(s.scene, line));
    constexpr int bins = 40, draws = 200000, fine = 500;
    std::vector<double> counts(bins, 0.0), observed{0}, expected{0};
    RandomSequence random = numbers(21);
    for (int i = 0; i < draws; ++i) ++counts[std::size_t(std::min(distances.sample(random.next2()) / 2 * bins, bins - 1.))];
    double total = 0;
    for (int i = 0; i < bins; ++i) {
        double mass = 0;
        for (int k = 0; k < fine; ++k) {
            const double u = (i + (k + .5) / fine) * 2 / bins;
            mass += distances.pdf(u, distances.at(u)) * 2 / bins / fine;
        }
        total += mass;
        const bool rare = draws * mass < 8;
        if (!rare) observed.push_back(0), expected.push_back(0);
        (rare ? observed.front() : observed.back()) += counts[std::size_t(i)], (rare ? expected.front() : expected.back()) += draws * mass;
    }
    EXPECT_NEAR(total, 1, 1.5e-3) << "half a step of the sum times the largest density, 27, where the box begins";
    EXPECT_LT(observed.front(), 50) << "empty cells";
    observed.erase(observed.begin()), expected.erase(expected.begin());
    EXPECT_GT(chi_square_p(observed, expected), false_alarm_rate);
}

TEST(ScatterDistances, OfAnEmptyStretchAreNone)
{
    BuiltScene s;
    const int volume = add_volume(s, {2, 1, 1}, glm::translate(Mat4(1), Vec3(-.5)), [](int, const glm::ivec3& v) { return double(v.x); });
    const int smoke = add_grid_medium(s, volume, {1, 0, 2}, Rgb(.5));
    const MediumLine empty{.medium = s.scene.media[std::size_t(smoke)], .origin = {-.4, -.3, 0}, .direction = {0, 1, 0}, .t0 = 0, .t1 = .6};
    const auto nothing_on = [&](const MediumLine& line, const Rgb& throughput) { return ScatterDistances(s.scene, line, throughput, optical_depth(s.scene, line)).empty(); };
    EXPECT_TRUE(nothing_on(empty, Rgb(1)));
    MediumLine full = empty;
    full.origin.x = .4;
    EXPECT_FALSE(nothing_on(full, Rgb(1)));
    EXPECT_TRUE(nothing_on(full, Rgb(0, 1, 0))) << "the only channel with light has no extinction";
}

}  // namespace
