#include "../path_tracing/rendered.hpp"
#include "grid_scene.hpp"
#include "transport/camera.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

Mat4 cube_around_origin() { return glm::translate(Mat4(1), Vec3(-.5)); }

/// In front of a glowing sky only what is absorbed is missing: every sample of the image is the transmittance along its ray.
TEST(GridTransmittance, OfABlackGridIsTheImageOfAConstantSky)
{
    for (const int channels : {1, 3}) {
        BuiltScene s;
        const int volume = add_volume(s, {6, 5, 7}, turned_box({1, .9, 1.1}), blotches, channels), smoke = add_grid_medium(s, volume, {1, 2, 4}, Rgb(0));
        s.container(Vec3(-.8), Vec3(.8), {.interior = smoke});
        s.constant({1, .5, 2});
        s.camera({.3, .2, -1.6}, glm::normalize(Vec3(-.2, -.1, 1)), 8, .7);
        const Visibility visibility(s.scene, 1);
        PassImage image(8, 8, LayerSet::all());
        trace_paths(s.scene, visibility, {.seed = 3, .pass = 1, .layers = LayerSet::all()}, image);
        int dimmed = 0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const Ray ray = sample_camera(s.scene.camera, x, y, 3, 1).ray;
                Rgb found(0);
                for (const auto& layer : image.layers)
                    if (!layer.empty()) found += layer[std::size_t(y * 8 + x)];
                for (int c = 0; c < 3; ++c) {
                    const double depth = s.scene.media[std::size_t(smoke)].sigma_t[c] * plain_integral(s.scene.volumes[std::size_t(volume)], std::min(c, channels - 1), ray.origin, ray.direction, 0, 4);
                    EXPECT_NEAR(found[c], s.scene.emitters[0].value[c] * std::exp(-depth), 3e-3) << x << ' ' << y << ' ' << c;
                    dimmed += depth > .3;
                }
            }
        EXPECT_GT(dimmed, 60);
    }
}

TEST(WhiteFurnace, AGridThatOnlyScattersIsInvisible)
{
    for (const double g : {0., .6}) {
        BuiltScene s;
        const int volume = add_volume(s, {4, 5, 3}, turned_box({.9, .8, 1}), blotches, 3), smoke = add_grid_medium(s, volume, {1, 2, 3}, Rgb(1), g);
        s.bound(s.sphere(Vec3(0), .6, s.null()), {.interior = smoke});  // cuts corners of the grid off
        s.constant(Rgb(1));
        s.camera({0, 0, -1.2}, {0, 0, 1}, 8, 1);
        for (const bool by_light : {false, true}) {
            const Rendered r = render(s.scene, {.single_by_light = by_light});
            expect_mean(r.image, 1, "image");
            for (const Mean& pixel : r.pixels) expect_mean(pixel, 1, "pixel");
            EXPECT_LT(r.image.error(), .01) << "test is too weak";
        }
    }
}

/// The box of the grid is the boundary then: no shape bounds the medium, which is all around.
TEST(WhiteFurnace, AGridInAnEndlessMediumIsInvisible)
{
    BuiltScene s;
    const int volume = add_volume(s, {3, 3, 3}, turned_box({.9, .8, 1}), blotches), smoke = add_grid_medium(s, volume, Rgb(2), Rgb(1));
    s.constant(Rgb(1));
    s.camera({0, 0, -1.2}, {0, 0, 1}, 6, 1, smoke);
    const Rendered r = render(s.scene, {});
    expect_mean(r.image, 1, "image");
    EXPECT_LT(r.image.error(), .01) << "test is too weak";
}

/// A box of smoke on a floor in the light of a lamp and of the sky: homogeneous, or as a grid of one value.
BuiltScene box_of_smoke(bool as_grid)
{
    BuiltScene s;
    const Rgb sigma_t(2, 3, 5), albedo(.9, .8, .6);
    int smoke = 0;
    if (as_grid) {
        const int volume = add_volume(s, {3, 2, 4}, cube_around_origin(), [](int, const glm::ivec3&) { return .5; });
        smoke = add_grid_medium(s, volume, 2. * sigma_t, albedo, .4);
    } else {
        smoke = s.medium(sigma_t, albedo, .4);
    }
    s.container(Vec3(-.5), Vec3(.5), {.interior = smoke});
    s.square({0, -.55, 0}, {0, 1, 0}, 1, s.diffuse(Rgb(.6)));
    s.point({.2, .9, -.3}, Rgb(3)), s.constant(Rgb(.2));
    s.camera({0, .2, -1.6}, {0, 0, 1}, 6, .9);
    return s;
}

TEST(ConstantGrid, HasTheImageOfAHomogeneousMedium)
{
    const BuiltScene homogeneous = box_of_smoke(false), grid = box_of_smoke(true);
    for (const bool by_light : {false, true}) {
        const RenderPlan plan{.passes = 600, .channel = 2, .single_by_light = by_light};
        const Rendered a = render(homogeneous.scene, plan), b = render(grid.scene, plan);
        expect_same(a.image, b.image, "image");
        for (std::size_t i = 0; i < a.pixels.size(); ++i) expect_same(a.pixels[i], b.pixels[i], "pixel");
        EXPECT_LT(a.image.error(), .01 * a.image.value()) << "test is too weak";
    }
}

/// The same random numbers make the same paths until rounding tells them apart: single passes agree, not only means.
TEST(ConstantGrid, HasTheSamePathsAsAHomogeneousMedium)
{
    const BuiltScene homogeneous = box_of_smoke(false), grid = box_of_smoke(true);
    const Rendered a = render(homogeneous.scene, {.passes = 4}), b = render(grid.scene, {.passes = 4});
    int same = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) same += std::abs(a.pixels[i].value() - b.pixels[i].value()) < 1e-4 * a.pixels[i].value();
    EXPECT_GT(same, int(.9 * double(a.pixels.size())));
}

}  // namespace
