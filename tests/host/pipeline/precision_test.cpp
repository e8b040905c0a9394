/// Kernels in 64-bit numbers, and with arithmetic that compilers may reorder: the same image within what rounding explains.
#include <algorithm>
#include <cmath>

#include "device/device_list.hpp"
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

const std::string view = sensor({.origin = {.3, .6, 3}, .pixels = 13});
const std::string fog = medium("fog", Rgb(.5, 1, 2), Rgb(.9, .7, .5), .5) + container(Vec3(-.5), Vec3(.5), "fog") + point_light({.5, 1, .5}, Rgb(2)) + view;
const std::string shadowed = fog + horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75))) + sphere({.1, .1, .1}, .2, diffuse(Rgb(.5)));

/// Largest difference of a channel, relative to the brightest pixel.
double difference(const WholeRender& a, const WholeRender& b)
{
    const auto x = a.film().beauty(), y = b.film().beauty();
    double most = 0, brightest = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (const auto& [u, v] : {std::pair(x[i].r, y[i].r), std::pair(x[i].g, y[i].g), std::pair(x[i].b, y[i].b)}) most = std::max(most, std::abs(u - v)), brightest = std::max(brightest, std::abs(v));
    return most / brightest;
}

class Precisions : public testing::TestWithParam<std::string> {
protected:
    const Scene scene = scene_of(GetParam());
    const RenderSettings settings{.passes = 2, .lights = 600, .sampler = Sampler::paper, .selection = Selection::tile, .selected_lights = 64};
    const WholeRender single = render_whole(scene, settings);
};

/// Both draw the same numbers and choose the same lights, so all that differs is rounding: some hundred roundings of 6e-8 in a pair, of 600 pairs in a pixel.
TEST_P(Precisions, SixtyFourBitsGiveTheSameImageWithinThirtyTwoBitRounding)
{
    if (!choose_device("").fp64) GTEST_SKIP() << "this device has no 64-bit numbers";
    RenderSettings other = settings;
    other.precision = Precision::f64;
    for (const int lanes : {1, 16}) {
        other.lanes = lanes;
        const double far = difference(render_whole(scene, other), single);
        EXPECT_LT(far, 1e-4);
        EXPECT_GT(far, 0) << "it computed in 32 bits";
    }
}

TEST_P(Precisions, FastArithmeticIsNearAndSaysThatNothingProvesIt)
{
    RenderSettings other = settings;
    other.math = KernelMath::fast;
    const WholeRender fast = render_whole(scene, other);
    EXPECT_LT(difference(fast, single), 1e-3);
    EXPECT_NE(fast.report().build_options.find("-cl-unsafe-math-optimizations"), std::string::npos);
    EXPECT_TRUE(std::ranges::any_of(fast.report().warnings, [](const std::string& w) { return w.find("--math fast") != std::string::npos; }));
    EXPECT_FALSE(std::ranges::any_of(single.report().warnings, [](const std::string& w) { return w.find("--math fast") != std::string::npos; }));
}

INSTANTIATE_TEST_SUITE_P(Of, Precisions, testing::Values(fog, shadowed), [](const auto& info) { return info.index ? "Shadowed" : "Clear"; });

}  // namespace
