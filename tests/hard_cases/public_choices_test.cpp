// Bugs in public implementations that concern choices: phase functions, random numbers, which lights are left (host/docs/hard_cases.md lists them).
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "light_tracing/light_tracing.hpp"
#include "tests/host/transport/built_scene.hpp"
#include "transport/emitter.hpp"
#include "transport/medium.hpp"
#include "transport/random_sequence.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall::test {
namespace {

using maths_float::phase_henyey_greenstein;

constexpr float four_pi = 12.566370614f;

/// The largest value of Henyey and Greenstein's function, straight ahead for g > 0 and straight back for g < 0.
float peak_of(float g) { return (1 + std::abs(g)) / (four_pi * (1 - std::abs(g)) * (1 - std::abs(g))); }

TEST(PublicBugs, AnUpperBoundThatHenyeyAndGreensteinExceed)
{
    /// Mean cosine of draws that accept a uniform direction with probability value / bound: g, if the value nowhere exceeds the bound.
    const auto mean_by_rejection = [](float g, float bound) {
        double accepted = 0, cosines = 0;
        for (int i = 0; i < 20000; ++i) {
            const float cosine = -1 + (i + .5f) / 10000, sine = std::sqrt(1 - cosine * cosine);
            const double probability = std::min(1.f, phase_henyey_greenstein({0, 0, 1}, {sine, 0, cosine}, g) / bound);
            accepted += probability, cosines += probability * cosine;
        }
        return cosines / accepted;
    };
    for (const float g : {-.9f, -.5f, .5f, .9f}) {
        const float forward = (1 + g) / (four_pi * (1 - g) * (1 - g));  // "the value straight ahead is the largest"
        EXPECT_LE(phase_henyey_greenstein({0, 0, 1}, {0, 0, g > 0 ? 1.f : -1.f}, g), peak_of(g) * (1 + 1e-6f));
        EXPECT_NEAR(mean_by_rejection(g, peak_of(g)), g, 1e-3);
        EXPECT_TRUE(g > 0 || std::abs(mean_by_rejection(g, forward) - g) > .1) << g;
        EXPECT_GT(std::abs(mean_by_rejection(g, 1.5f / four_pi) - g), .1) << "one and a half times the isotropic value, for g = " << g;
        // The kernels invert the distribution and need no bound.
        double mean = 0;
        for (int i = 0; i < 20000; ++i) mean += maths_float::sample_henyey_greenstein(g, (i + .5f) / 20000) / 20000;
        EXPECT_NEAR(mean, g, 1e-4);
    }
}

/// The branch of a choice among `shares`, which sum to one, as it is often written.
std::size_t plain_choice(const std::array<float, 3>& shares, float xi)
{
    std::size_t i = 0;
    for (float sum = shares[0]; i + 1 < shares.size() && xi >= sum; sum += shares[++i]) {}
    return i;
}

TEST(PublicBugs, ABranchOfNoProbabilityTakenBecauseANumberWasRoundedToOne)
{
    // 32 random bits as a float: the largest 128 round to 2^32. The first key of the kernels' generator that gives such bits.
    const maths_float::uint shift = maths_float::mix_scalar(0x9e3779b9u);
    maths_float::bits key = 0;
    while (maths_float::mix_lanes(key + shift) < 0xffffff80u) ++key;
    const float rounded = float(maths_float::mix_lanes(key + shift)) * 0x1p-32f, ours = maths_float::random2(key, 0).first;
    const std::array<float, 3> shares{.5f, .5f, 0};
    EXPECT_EQ(rounded, 1);
    EXPECT_EQ(shares[plain_choice(shares, rounded)], 0) << "the bug";
    EXPECT_EQ(ours, 0x1.fffffep-1f);
    EXPECT_GT(shares[plain_choice(shares, ours)], 0);
}

TEST(PublicBugs, ABranchOfNoProbabilityTakenOnTheHost)
{
    // The largest number that the host draws, and 1 itself, should arithmetic on the way have rounded to it.
    for (const double xi : {std::nextafter(1., 0.), 1.}) {
        BuiltScene s;
        s.point({0, 0, 0}, Rgb(1)), s.point({0, 1, 0}, Rgb(0)), s.point({0, 2, 0}, Rgb(0));
        const EmitterChoice choice = EmitterSampler(s.scene).choose(xi);
        EXPECT_EQ(choice.emitter, 0);
        EXPECT_EQ(choice.probability, 1);
    }
    BuiltScene s;
    const int fog = s.medium({1, 1, 0}, Rgb(1));
    const std::vector<MediumPiece> pieces{{fog, 0, 2}};
    const double last = std::nextafter(1., 0.);
    for (const Vec2& xi : {Vec2(last, 0), Vec2(last, .5), Vec2(last, last)}) {
        const FreeFlight flight = sample_free_flight(s.scene, std::span(pieces), {1, .3, 0}, xi);  // the last channel is dark
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(flight.weight[c]) && flight.weight[c] >= 0);
        EXPECT_EQ(flight.weight.z, 0);
    }
}

/// What light tracing leaves, whatever the technique.
std::vector<LightPathSegment>& deposited()
{
    static std::vector<LightPathSegment> all;
    return all;
}

TEST(PublicBugs, FirstSegmentsOfLightPathsLeftOut)
{
    BuiltScene s;
    const int fog = s.medium(Rgb(1), Rgb(.9));
    s.container(Vec3(-1), Vec3(1), {.interior = fog});
    s.point({.1, .2, .3}, Rgb(2), fog);
    const LightTechnique recorder{.name = "recorder", .title = "recorder", .record_bytes = 1, .unbiased = true, .deposit = [](const LightPathSegment& segment, std::vector<std::byte>& records) {
                                      deposited().push_back(segment), records.push_back({});
                                  }};
    deposited().clear();
    const Visibility visibility(s.scene, 1);
    visibility.in_arena([&] { trace_lights(s.scene, visibility, recorder, {.paths = 500, .max_depth = 3}); });
    // Paths of two scattering vertices have one on the light's first segment: together these carry what the lamp emits, 4 pi of its intensity.
    double flux = 0, without_first = 0;
    for (const LightPathSegment& segment : deposited()) flux += segment.flux.y, without_first += segment.depth > 0 ? segment.flux.y : 0;
    EXPECT_NEAR(flux, 2 * four_pi, 1e-5);
    EXPECT_EQ(without_first, 0) << "the bug: no light that scatters twice";
}

}  // namespace
}  // namespace tyndall::test
