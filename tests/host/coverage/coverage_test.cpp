// Do error bars hold what they promise? 2,000 renders of 64 passes each; the truth is the mean of all their passes, which is 45 times better known than any of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstdio>

#include "../pipeline/whole_renderer.hpp"
#include "film/error_estimate.hpp"
#include "metrics/block_means.hpp"
#include "pipeline/pass_renderer.hpp"

namespace tyndall::test {
namespace {

constexpr int side = 32, renders = 2000, passes_each = 64, channel = 1;
constexpr double target = .06;
constexpr int most_passes_to_target = 256;

/// Fog in a box around a point light: noise of virtual ray lights, which pixels share, and of single scattering, which they do not.
Scene fog()
{
    const Rgb sigma_t(.5), albedo(.8);
    return scene_of(medium("fog", sigma_t, albedo) + sensor({.origin = {0, 0, 3}, .fov = 45, .pixels = side, .medium = "fog"}) + point_light({0, 1, 0}, Rgb(3, 2, 1), "fog") +
                    container(Vec3(-4), Vec3(4), "fog") + "<integrator type=\"volpath\"><integer name=\"max_depth\" value=\"4\"/></integrator>");
}

/// 16 pixels on a grid that meets the middle of the film, its edges and its corners.
std::size_t fixed_pixel(int i)
{
    constexpr int place[] = {0, 10, 21, 31};
    return static_cast<std::size_t>(place[i / 4] * side + place[i % 4]);
}

/// Intervals of the quantities that are watched, and how often they held the truth.
struct Interval {
    double middle, half_width;
};
using Intervals = std::vector<Interval>;

/// The mean of the image first, then the fixed pixels; 95 %, by Student's t.
Intervals intervals_of(const Film& film, const BlockStatistics& passes)
{
    Intervals intervals{{passes.whole().value, half_width(passes.whole(), .95)}};
    const double quantile = boost::math::quantile(boost::math::students_t(film.passes() - 1), .975);
    for (int i = 0; i < 16; ++i) {
        const std::size_t pixel = fixed_pixel(i);
        intervals.push_back({film.beauty(pixel)[channel], quantile * std::sqrt(film.variance_of_mean(pixel)[channel])});
    }
    return intervals;
}

Rgb at(const PassImage& image, std::size_t pixel)
{
    Rgb sum(0);
    for (const auto& layer : image.layers)
        if (!layer.empty()) sum += layer[pixel];
    return sum;
}

std::vector<Rgb> beauty(const PassImage& image)
{
    std::vector<Rgb> pixels(side * side);
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = at(image, i);
    return pixels;
}

/// Renders of consecutive passes of one renderer: passes are independent, so these are as good as renders with other seeds, without the start of each.
class Renders {
public:
    explicit Renders(const Scene& scene, RenderSettings settings) : renderer_(scene, settings) {}

    /// Passes are added until `done(film)` says so.
    template <class Done>
    std::pair<Film, BlockStatistics> next(Done&& done)
    {
        Film film(side, side, renderer_.plan().rendered());
        BlockStatistics passes;
        do {
            const PassResult result = renderer_.render(pass_++);
            film.add_pass(result.image);
            passes.add(beauty(result.image), side);
            all_.add(beauty(result.image), side);
            if (sum_.empty()) sum_.assign(side * side, Rgb(0));
            for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += at(result.image, i);
        } while (!done(film));
        return {std::move(film), std::move(passes)};
    }
    /// What every interval should hold.
    std::vector<double> truths() const
    {
        std::vector<double> truths{all_.whole().value};
        for (int i = 0; i < 16; ++i) truths.push_back(sum_[fixed_pixel(i)][channel] / double(pass_));
        return truths;
    }
    std::uint64_t passes() const { return pass_; }

private:
    PassRenderer renderer_;
    std::uint64_t pass_ = 0;
    BlockStatistics all_;
    std::vector<Rgb> sum_;
};

RenderSettings settings()
{
    RenderSettings settings;
    settings.passes = 1, settings.lights = 16, settings.seed = 1;
    return settings;
}

/// Share of the renders whose interval held the truth, for each quantity.
std::vector<double> coverage(const std::vector<Intervals>& all, const std::vector<double>& truths)
{
    std::vector<double> held(truths.size(), 0);
    for (const Intervals& intervals : all)
        for (std::size_t q = 0; q < truths.size(); ++q) held[q] += std::abs(intervals[q].middle - truths[q]) <= intervals[q].half_width;
    for (double& h : held) h /= static_cast<double>(all.size());
    return held;
}

void print(const char* what, const std::vector<double>& held)
{
    std::printf("%s: image mean %.2f %%, pixels", what, 100 * held[0]);
    for (std::size_t q = 1; q < held.size(); ++q) std::printf(" %.2f", 100 * held[q]);
    std::printf("\n");
}

TEST(Coverage, IntervalsOf95PercentHoldTheTruthIn93To97)
{
    const Scene scene = fog();
    Renders source(scene, settings());
    std::vector<Intervals> all;
    for (int r = 0; r < renders; ++r) {
        const auto [film, passes] = source.next([](const Film& f) { return f.passes() == passes_each; });
        all.push_back(intervals_of(film, passes));
    }
    const auto held = coverage(all, source.truths());
    print("64 passes", held);
    for (std::size_t q = 0; q < held.size(); ++q) {
        EXPECT_GE(held[q], .93) << (q ? "pixel " + std::to_string(q - 1) : "image mean");  // the binomial deviation of 2,000 is .5 %
        EXPECT_LE(held[q], .97) << (q ? "pixel " + std::to_string(q - 1) : "image mean");
    }
}

TEST(Coverage, OfRendersThatStopAtATargetErrorIsAtLeast90Percent)
{
    const Scene scene = fog();
    Renders source(scene, settings());
    std::vector<Intervals> all;
    int missed = 0;
    for (int r = 0; r < renders; ++r) {
        auto [film, passes] = source.next([](const Film& f) { return error_upper_bound(f) <= target || f.passes() == most_passes_to_target; });
        all.push_back(intervals_of(film, passes));
        missed += film.passes() == most_passes_to_target;
    }
    const auto held = coverage(all, source.truths());
    print("stopped at a target error", held);
    std::printf("passes to the target: %.1f on average; %d of %d ended first\n", double(source.passes()) / renders, missed, renders);
    EXPECT_LT(missed, renders / 100);
    for (std::size_t q = 0; q < held.size(); ++q) EXPECT_GE(held[q], .90) << (q ? "pixel " + std::to_string(q - 1) : "image mean");
}

}  // namespace
}  // namespace tyndall::test
