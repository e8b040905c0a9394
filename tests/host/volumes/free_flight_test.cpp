#include "../transport/statistics.hpp"
#include "grid_scene.hpp"
#include "transport/medium.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

/// A line through grid, vacuum, homogeneous medium and a second stretch of the grid.
struct Flight {
    BuiltScene s;
    int volume, grid, fog;
    Vec3 origin{-.9, .11, -.07}, direction = glm::normalize(Vec3(1, -.1, .12));
    std::vector<MediumPiece> pieces;

    Flight(int channels, const Rgb& sigma_t, const Rgb& albedo)
        : volume(add_volume(s, {8, 3, 5}, turned_box({1, .8, 1.2}), blotches, channels)), grid(add_grid_medium(s, volume, sigma_t, albedo)), fog(s.medium(Rgb(.5), Rgb(.6)))
    {
        pieces = {{grid, .1, .9}, {vacuum, .9, 1}, {fog, 1, 1.1}, {grid, 1.1, 1e30}};
    }
    PieceView view() const { return {std::span<const MediumPiece>(pieces), origin, direction}; }
    /// Extinction by the plain value.
    double sigma(int channel, double t) const
    {
        if (t < .1 || (t > .9 && t < 1)) return 0;
        if (t > 1 && t < 1.1) return .5;
        const Volume& v = s.scene.volumes[std::size_t(volume)];
        return s.scene.media[std::size_t(grid)].sigma_t[channel] * plain_value(v, std::min(channel, v.channels - 1), origin + t * direction);
    }
};

/// Of collisions at t = i / bins x 2 and, last, of light that passes: per channel, by a fine sum.
std::vector<Rgb> expected_shares(const Flight& flight, int bins)
{
    constexpr int fine = 400;  // steps per bin
    std::vector<Rgb> shares(std::size_t(bins) + 1, Rgb(0));
    for (int c = 0; c < 3; ++c) {
        double depth = 0;
        for (int i = 0; i < bins * fine; ++i) {
            const double step = 2. / (bins * fine), through = flight.sigma(c, (i + .5) * step) * step;
            shares[std::size_t(i / fine)][c] += std::exp(-depth) * -std::expm1(-through);
            depth += through;
        }
        shares.back()[c] = std::exp(-depth);
    }
    return shares;
}

/// p-value that `counts` (bins, and what passed) follow the first channel of `shares`; what is rare in one cell.
double p_of(const std::vector<double>& counts, const std::vector<Rgb>& shares, double draws)
{
    std::vector<double> observed{0}, expected{0};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double mass = draws * shares[i].x;
        const bool rare = mass < 8;
        if (!rare) observed.push_back(0), expected.push_back(0);
        (rare ? observed.front() : observed.back()) += counts[i], (rare ? expected.front() : expected.back()) += mass;
    }
    if (expected.front() <= 5) {
        observed[1] += observed.front(), expected[1] += expected.front();
        observed.erase(observed.begin()), expected.erase(expected.begin());
    }
    return chi_square_p(observed, expected);
}

TEST(GridFlight, DistancesFollowQuadratureAlsoThroughEmptyVoxels)
{
    const Flight flight(1, Rgb(2.5), Rgb(1)), wrong(1, Rgb(2.55), Rgb(1));
    constexpr int bins = 50, draws = 400000;
    const std::vector<Rgb> shares = expected_shares(flight, bins);
    std::vector<double> counts(bins + 1, 0.0);
    RandomSequence random = numbers(11);
    for (int i = 0; i < draws; ++i) {
        const FreeFlight f = sample_free_flight(flight.s.scene, flight.view(), Rgb(1), random.next2());
        ++counts[f.collided ? std::size_t(std::min(f.t / 2 * bins, bins - 1.)) : bins];
    }
    int empty = 0;
    for (std::size_t i = 0; i < bins; ++i) {
        if (shares[i].x > 0) continue;
        ++empty;
        EXPECT_EQ(counts[i], 0) << "nothing is there to collide with";
    }
    EXPECT_GE(empty, 5) << "the line has empty stretches";
    EXPECT_GT(p_of(counts, shares, draws), false_alarm_rate);
    EXPECT_LT(p_of(counts, expected_shares(wrong, bins), draws), false_alarm_rate) << "two percent more extinction would be noticed";
}

TEST(GridFlight, ColouredGridsHaveTheRightMeansAndBoundedWeights)
{
    for (const int channels : {1, 3}) {
        const Flight flight(channels, {.5, 3, 20}, {.9, .8, .3});
        constexpr int bins = 8;
        const std::vector<Rgb> shares = expected_shares(flight, bins);
        const Rgb throughput(.2, 1, .6);
        std::vector<std::array<Mean, 3>> means(bins + 1);
        RandomSequence random = numbers(12);
        for (int i = 0; i < 200000; ++i) {
            const FreeFlight f = sample_free_flight(flight.s.scene, flight.view(), throughput, random.next2());
            const std::size_t bin = f.collided ? std::size_t(std::min(f.t / 2 * bins, bins - 1.)) : bins;
            for (int c = 0; c < 3; ++c) {
                ASSERT_LE(throughput[c] * f.weight[c], 1.8 * (1 + 1e-12));
                for (std::size_t b = 0; b <= bins; ++b) means[b][std::size_t(c)].add(b == bin ? f.weight[c] / (f.collided ? flight.s.scene.media[std::size_t(flight.pieces[f.piece].medium)].albedo[c] : 1) : 0);
            }
        }
        for (std::size_t b = 0; b <= bins; ++b)
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(means[b][std::size_t(c)].value(), shares[b][c], allowed_sigmas * means[b][std::size_t(c)].error() + 1e-4) << b << ' ' << c;
    }
}

TEST(GridFlight, StaysFiniteAtAnyDepthAndInEmptyGrids)
{
    RandomSequence random = numbers(13);
    for (const double sigma : {0., 1e-300, 1e-8, 1e3, 1e12})
        for (const bool empty : {false, true}) {
            BuiltScene s;
            const int volume = add_volume(s, {2, 2, 1}, glm::translate(Mat4(1), Vec3(-.5)), [&](int, const glm::ivec3& v) { return !empty && v == glm::ivec3(1, 0, 0); });
            const int medium = add_grid_medium(s, volume, {sigma, .5 * sigma, 0}, Rgb(.9));
            const std::vector<MediumPiece> pieces{{medium, 0, 1e30}};
            for (int i = 0; i < 2000; ++i) {
                const Vec3 origin(random.next() - .5, random.next() - .5, random.next() - .5);
                const FreeFlight f = sample_free_flight(s.scene, {std::span<const MediumPiece>(pieces), origin, sample_uniform_sphere(random.next2())}, {1, .1, 1e-9}, random.next2());
                for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(f.weight[c]) && f.weight[c] >= 0);
                ASSERT_FALSE(f.collided && empty);
            }
        }
}

}  // namespace
