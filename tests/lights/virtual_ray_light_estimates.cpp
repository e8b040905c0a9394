/// The rough estimates by which lights are chosen: close to quadrature that shares no code with kernels/, bounded and finite for every pair, the same in float.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/lights/ray_on_host.hpp"

namespace tyndall {
namespace {

maths_double::real3 wide(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
maths_float::real3 narrow(const glm::dvec3& v) { return {float(v.x), float(v.y), float(v.z)}; }

double estimate(const Pair& p)
{
    using namespace maths_double;
    const MediumRecord medium = medium_of(p);
    const MediumLanes eye_medium{wide(p.sigma_t), wide(p.sigma_s), p.g, {1, 0, 0, {phase_range(medium)}}};
    const auto light = light_of<VirtualRayLight>(p);
    return estimate_to_segment({wide(p.o), wide(p.a), {1, 1, 1}, p.eye_length}, eye_medium, light, medium, 1);
}
float estimate_in_float(const Pair& p)
{
    using namespace maths_float;
    const MediumRecord medium = medium_of(p);
    const MediumLanes eye_medium{narrow(p.sigma_t), narrow(p.sigma_s), float(p.g), {1, 0, 0, {phase_range(medium)}}};
    const auto light = light_of<VirtualRayLight>(p);
    return estimate_to_segment({narrow(p.o), narrow(p.a), {1, 1, 1}, float(p.eye_length)}, eye_medium, light, medium, 1);
}
double estimate(const SurfacePair& s)
{
    using namespace maths_double;
    const MediumRecord medium = medium_of(s.light);
    const auto light = light_of<VirtualRayLight>(s.light);
    return estimate_to_point({wide(s.x), wide(s.n), wide(s.n), {1, 1, 1}}, light, medium, 1);
}

double sum(const glm::dvec3& v) { return v.x + v.y + v.z; }

struct Spread {
    double of_truth = 0, of_ratio = 0, ratio = 0;  ///< standard deviations of the logarithms; median of estimate over truth
};

/// estimate and truth of `count` pairs.
template <typename Draw>
Spread spread_of(int count, const Draw& draw)
{
    std::vector<double> truths, ratios;
    for (int i = 0; i < count; ++i) {
        const auto [estimated, truth] = draw();
        if (!(truth > 0)) continue;
        EXPECT_GT(estimated, 0);
        truths.push_back(std::log(truth)), ratios.push_back(std::log(estimated / truth));
    }
    const auto deviation = [](const std::vector<double>& x) {
        double mean = 0, square = 0;
        for (const double v : x) mean += v / double(x.size());
        for (const double v : x) square += (v - mean) * (v - mean) / double(x.size());
        return std::sqrt(square);
    };
    Spread s{deviation(truths), deviation(ratios)};
    std::nth_element(ratios.begin(), ratios.begin() + ratios.size() / 2, ratios.end());
    s.ratio = std::exp(ratios[ratios.size() / 2]);
    return s;
}

constexpr double sphere = 4 * 3.14159265358979323846;

TEST(LightEstimate, ToSegmentsFollowsQuadrature)
{
    for (const double g : {0.0, .55, .9, -.7})
        for (const bool is_short : {false, true}) {
            std::mt19937 engine(41);
            const Spread s = spread_of(300, [&] {
                const Pair p = plain::random_pair(engine, g, is_short);
                return std::pair(estimate(p) / (sphere * sphere), sum(plain::transport(p)));
            });
            // Two nodes, three angles and lobes that are broader than the medium's: what is left of the spread in logarithms is the measure of the choice.
            EXPECT_LT(s.of_ratio, (std::abs(g) > .8 ? .6 : .4) * s.of_truth) << "g " << g << ", short " << is_short;
            EXPECT_GT(s.ratio, .5) << g;
            EXPECT_LT(s.ratio, std::abs(g) > .8 ? 30 : 3) << g << ": half of the estimate is a lobe much broader than the medium's";
        }
}

TEST(LightEstimate, ToSurfacesFollowsQuadrature)
{
    for (const double g : {0.0, .55, -.7}) {
        std::mt19937 engine(42);
        const Spread s = spread_of(300, [&] {
            const SurfacePair p = plain::random_surface_pair(engine, g, false);
            return std::pair(estimate(p) / sphere, sum(plain::transport(p)));
        });
        EXPECT_LT(s.of_ratio, .6 * s.of_truth) << g;
        EXPECT_GT(s.ratio, .5) << g;
        EXPECT_LT(s.ratio, 4) << g;
    }
}

TEST(LightEstimate, IsTheSameInFloat)
{
    std::mt19937 engine(43);
    for (int i = 0; i < 2000; ++i) {
        const Pair p = plain::as_float(plain::random_pair(engine, i % 3 ? .9 : 0, i % 2));
        EXPECT_NEAR(estimate_in_float(p) / estimate(p), 1, 2e-4) << i;
    }
}

TEST(LightEstimate, IsFiniteForEveryDegeneratePair)
{
    std::mt19937 engine(44);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 4000; ++i) {
        Pair p = plain::random_pair(engine, i % 2 ? .999 : -.95, i % 3 == 0);
        const double wiggle = std::pow(10., -double(i / 8 % 9));
        if (i % 8 < 3) p.b = p.a;                                                                // parallel
        if (i % 8 < 2) p.p = p.o + wiggle * glm::dvec3(p.a.y, -p.a.x, 0);                         // and close
        if (i % 8 == 2) p.p = p.o + .3 * p.eye_length * p.a;                                      // on one line
        if (i % 8 == 3) p.p = p.o;                                                               // start together
        if (i % 8 == 4) p.p = p.o + .3 * p.eye_length * p.a - .5 * p.light_length * p.b;           // cross
        if (i % 8 == 5) p.light_length = 0;
        if (i % 8 == 6) p.sigma_t *= 1e4;
        if (i % 8 == 7) p.eye_length = 1e-6;
        const float e = estimate_in_float(plain::as_float(p));
        EXPECT_TRUE(std::isfinite(e) && e >= 0) << i << ": " << e;
    }
}

TEST(LightEstimate, PowerIsWhatALightScatters)
{
    std::mt19937 engine(45);
    for (int i = 0; i < 100; ++i) {
        const Pair p = plain::random_pair(engine, 0, i % 2);
        glm::dvec3 expected(0);  // integral of flux sigma_s exp(-sigma_t v), mid-point rule
        for (int k = 0; k < 2000; ++k) {
            const double v = (k + .5) / 2000 * p.light_length;
            expected += p.flux * p.sigma_s * (p.is_short ? glm::dvec3(1) : glm::exp(-p.sigma_t * v)) * p.light_length / 2000.;
        }
        EXPECT_NEAR(maths_double::light_power(light_of<maths_double::VirtualRayLight>(p), medium_of(p)) / sum(expected), 1, 1e-5);
    }
}

}  // namespace
}  // namespace tyndall
