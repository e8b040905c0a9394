#include "transport/medium.hpp"

#include "built_scene.hpp"
#include "statistics.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

TEST(FreeFlight, PassesWithTheTransmittanceAndCollidesWithWhatScatters)
{
    BuiltScene s;
    const int a = s.medium({.3, 1, 4}, {.9, .5, .2}), b = s.medium({2, 0, .5}, {.3, 0, 1});
    const std::vector<MediumPiece> pieces{{vacuum, 0, .5}, {a, .5, 1.1}, {vacuum, 1.1, 1.2}, {b, 1.2, 2}};
    const Rgb throughput(.2, 1, .6), tau_a = .6 * s.scene.media[a].sigma_t, tau_b = .8 * s.scene.media[b].sigma_t;
    Mean passed[3], in_a[3], in_b[3];
    RandomSequence random = numbers(1);
    for (int i = 0; i < 200000; ++i) {
        const FreeFlight f = sample_free_flight(s.scene, std::span(pieces), throughput, random.next2());
        ASSERT_LE((throughput * f.weight).x + (throughput * f.weight).y + (throughput * f.weight).z, 3 * 1.8 + 1e-9);
        for (int c = 0; c < 3; ++c) {
            ASSERT_LE(throughput[c] * f.weight[c], 1.8 * (1 + 1e-12)) << "balanced weights are bounded by the throughput's sum";
            passed[c].add(f.collided ? 0 : f.weight[c]);
            in_a[c].add(f.collided && f.piece == 1 ? f.weight[c] : 0), in_b[c].add(f.collided && f.piece == 3 ? f.weight[c] : 0);
        }
        if (f.collided) {
            ASSERT_TRUE(f.piece == 1 || f.piece == 3);
            ASSERT_TRUE(f.t > pieces[f.piece].t0 && f.t <= pieces[f.piece].t1);
        }
    }
    for (int c = 0; c < 3; ++c) {
        expect_mean(passed[c], std::exp(-tau_a[c] - tau_b[c]), "passed");
        expect_mean(in_a[c], s.scene.media[a].albedo[c] * -std::expm1(-tau_a[c]), "first medium");
        expect_mean(in_b[c], s.scene.media[b].albedo[c] * std::exp(-tau_a[c]) * -std::expm1(-tau_b[c]), "second medium");
    }
}

TEST(FreeFlight, DistancesAreExponentialPerChannel)
{
    BuiltScene s;
    const int a = s.medium({.5, 2, 5}, Rgb(1));
    const std::vector<MediumPiece> pieces{{a, 0, 1}};
    constexpr int bins = 10;
    Mean counts[bins][3];
    RandomSequence random = numbers(2);
    for (int i = 0; i < 200000; ++i) {
        const FreeFlight f = sample_free_flight(s.scene, std::span(pieces), Rgb(1), random.next2());
        for (int bin = 0; bin < bins; ++bin)
            for (int c = 0; c < 3; ++c) counts[bin][c].add(f.collided && int(f.t * bins) == bin ? f.weight[c] : 0);
    }
    for (int bin = 0; bin < bins; ++bin)
        for (int c = 0; c < 3; ++c) {
            const double sigma = s.scene.media[a].sigma_t[c];
            expect_mean(counts[bin][c], std::exp(-sigma * bin / bins) * -std::expm1(-sigma / bins));
        }
}

// Hard case 16 and the unbounded medium: nothing becomes 0/0 or inf however deep.
TEST(FreeFlight, StaysFiniteInMediaOfAnyDepth)
{
    BuiltScene s;
    const int thick = s.medium({1, 1000, 1e6}, Rgb(.9)), half = s.medium({0, 0, 1}, {0, 0, .5}), thin = s.medium(Rgb(1e-300), Rgb(1));
    RandomSequence random = numbers(3);
    for (const int medium : {thick, half, thin})
        for (const double end : {1e-12, 1., 1e3, 1e30})
            for (const Rgb& throughput : {Rgb(1), Rgb(1, 0, 0), Rgb(0, 0, 1e-20), Rgb(1e-200, 1e200, 1)})
                for (int i = 0; i < 200; ++i) {
                    const std::vector<MediumPiece> pieces{{medium, 0, end}};
                    const FreeFlight f = sample_free_flight(s.scene, std::span(pieces), throughput, random.next2());
                    const Rgb next = throughput * f.weight;
                    for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(next[c]) && next[c] >= 0) << medium << ' ' << end << ' ' << c;
                    const Rgb t = transmittance_of(s.scene, std::span(pieces));
                    for (int c = 0; c < 3; ++c) ASSERT_TRUE(t[c] >= 0 && t[c] <= 1);
                }
}

// Hard case 22: with the channel chosen in proportion to the throughput and the density balanced over channels, the sum of the throughput over channels never
// grows, so that no channel of white light exceeds 3 on a path of any length. One channel's density alone has no such bound.
TEST(FreeFlight, ChromaticWeightsStayBelowThreeAlongWholePaths)
{
    RandomSequence random = numbers(4);
    double largest = 0, largest_of_one_channel = 0;
    for (int path = 0; path < 4000; ++path) {
        BuiltScene s;
        const auto decades = [&](double low, double high) { return std::pow(10, low + (high - low) * random.next()); };
        const Rgb sigma(decades(-3, 3), decades(-3, 3), decades(-3, 3)), albedo(random.next(), 1, random.next());
        const int medium = s.medium(sigma, albedo);
        Rgb throughput(1), by_red_alone(1);
        for (int flight = 0; flight < 30; ++flight) {
            const std::vector<MediumPiece> pieces{{medium, 0, decades(-2, 2)}};
            const FreeFlight f = sample_free_flight(s.scene, std::span(pieces), throughput, random.next2());
            throughput *= f.weight;
            const double total = throughput.r + throughput.g + throughput.b;
            ASSERT_TRUE(std::isfinite(total) && total >= 0) << "path " << path << " flight " << flight;
            ASSERT_LE(total, 3 * (1 + 1e-13 * (flight + 1))) << "path " << path << " flight " << flight;
            largest = std::max(largest, std::max({throughput.r, throughput.g, throughput.b}));
            const double t = f.collided ? f.t : pieces[0].t1;
            by_red_alone *= glm::exp((sigma.r - sigma) * t);
            largest_of_one_channel = std::max(largest_of_one_channel, by_red_alone.g);
            if (!f.collided) break;
        }
    }
    EXPECT_GT(largest, 1.5) << "the bound of 3 is approached";
    EXPECT_GT(largest_of_one_channel, 1e6) << "and it is not trivial";
}

TEST(FreeFlight, NoLightNoFlightAndVacuumChangesNothing)
{
    BuiltScene s;
    const std::vector<MediumPiece> pieces{{vacuum, 0, 1e30}};
    EXPECT_EQ(sample_free_flight(s.scene, std::span(pieces), Rgb(0), {.5, .5}).weight, Rgb(0));
    const FreeFlight f = sample_free_flight(s.scene, std::span(pieces), Rgb(.5, 0, .25), {.5, 1 - 0x1p-53});
    EXPECT_FALSE(f.collided);
    EXPECT_EQ(f.weight * Rgb(.5, 0, .25), Rgb(.5, 0, .25));
}

TEST(OpticalDepth, ToADistanceIsTheSumOfWhatLiesBefore)
{
    BuiltScene s;
    const int a = s.medium({1, 2, 3}, Rgb(.5));
    const std::vector<MediumPiece> pieces{{a, 0, 1}, {vacuum, 1, 2}, {a, 2, 4}};
    EXPECT_EQ(optical_depth_to(s.scene, std::span(pieces), 2, 2.5), Rgb(1.5, 3, 4.5));
    EXPECT_EQ(optical_depth_of(s.scene, std::span(pieces)), Rgb(3, 6, 9));
    EXPECT_EQ(transmittance_of(s.scene, std::span(pieces)), glm::exp(-Rgb(3, 6, 9)));
}

// Hard case 17: thin stretches.
TEST(ExponentialDistance, UndoesItsDistributionAtEveryDepth)
{
    for (const double depth : {1e-16, 1e-12, 1e-7, 1e-5, .1, 1., 30., 700., 1e5}) {
        const double length = 2.5, sigma = depth / length;
        for (double xi = .001; xi < 1; xi += .0713) {
            const double t = sample_exponential(sigma, length, xi);
            ASSERT_TRUE(t > 0 && t <= length);
            EXPECT_NEAR(std::expm1(-sigma * t) / std::expm1(-depth), xi, 1e-12) << depth;
        }
        EXPECT_EQ(sample_exponential(sigma, length, 0), 0);
        const double end = std::min(length, 40 / sigma);  // beyond lies exp(-40)
        const double total =
            double(integrate([&](long double t) { return (long double)pdf_exponential(sigma, length, double(t)); }, 0, end, 1e-11L));
        EXPECT_NEAR(total, 1, 1e-9) << depth;
    }
    EXPECT_EQ(pdf_exponential(0, 4, 1), .25);
    EXPECT_EQ(sample_exponential(0, 4, .25), 1);
}

}  // namespace
