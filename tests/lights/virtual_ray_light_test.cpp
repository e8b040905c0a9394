/// The light contract for virtual ray lights: transport equals quadrature that shares no code with kernels/, float agrees with double, and the laws that
/// light obeys hold.
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <random>

#include "tests/lights/ray_on_host.hpp"

#include "tests/lights/found_places.hpp"

namespace tyndall {
namespace {

/// Relative differences between float and double over 4000 random pairs, sorted; a value that is not finite fails the test.
std::vector<double> float_errors(unsigned seed)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<double> errors;
    for (int i = 0; i < 4000; ++i) {
        const Pair p = plain::as_float(plain::random_pair(engine, i % 2 ? .55 : 0, i % 3 == 0));
        const float xi0 = uniform(engine), xi1 = uniform(engine);
        const glm::dvec3 f = Float::segment(p, xi0, xi1), d = Double::segment(p, xi0, xi1);
        EXPECT_TRUE(std::isfinite(f.x + f.y + f.z)) << "pair " << i;
        errors.push_back(glm::length(f - d) / glm::length(d));
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

TEST(VirtualRayLight, TransportToASegmentEqualsQuadrature)
{
    std::mt19937 engine(11);
    for (const double g : {0.0, .55, -.7})
        for (const bool is_short : {false, true})
            for (int i = 0; i < 4; ++i) {
                const Pair p = plain::random_pair(engine, g, is_short);
                // Midpoint rule, 192 x 192: the error of a smooth integrand is far below 5e-4; the quadrature's is below 1e-6.
                expect_near(mean_over_segment(p, 192), plain::transport(p), 5e-4, "g " + std::to_string(g) + " short " + std::to_string(is_short) + " pair " + std::to_string(i));
            }
}

/// Every sampler but the equi-angular one, which the other tests use. It is set for the length of a test.
class BySampler : public testing::TestWithParam<int> {
protected:
    void SetUp() override { tested_sampler = GetParam(); }
    void TearDown() override { tested_sampler = SAMPLER_PAPER_ISOTROPIC; }
};
INSTANTIATE_TEST_SUITE_P(VirtualRayLight, BySampler, testing::Values(SAMPLER_PAPER, SAMPLER_PAPER_6, SAMPLER_TABLE, SAMPLER_TABLE_4X4, SAMPLER_TABLE_3X2));

TEST_P(BySampler, TransportEqualsQuadrature)
{
    std::mt19937 engine(21);
    for (const double g : {0.0, .55, .9, -.7})
        for (int i = 0; i < 2; ++i) {
            const Pair p = plain::random_pair(engine, g, i % 2 == 1);
            // The densities' corners at their vertices cost the mid-point rule some accuracy.
            expect_near(mean_over_segment(p, 240), plain::transport(p), 1e-3, "g " + std::to_string(g) + " pair " + std::to_string(i));
        }
}

TEST_P(BySampler, FloatAgreesWithDouble)
{
    const std::vector<double> errors = float_errors(22);
    // A table adds some fifty roundings to the place and its density, and where xi lies at a corner the density changes by as much as its slope.
    EXPECT_LT(errors[errors.size() / 2], 4e-6);
    EXPECT_LT(errors.back(), 2e-3);
}

/// The pair in a medium with these lobes.
Pair with(Pair p, const Lobes& lobes)
{
    p.phase = lobes.phase, p.g = lobes.mean;
    return p;
}

TEST(VirtualRayLight, TransportBySumsOfLobesEqualsQuadratureWithEverySampler)
{
    std::mt19937 engine(31);
    for (const Lobes& lobes : all_lobes())
        for (const int sampler : {int(SAMPLER_PAPER_ISOTROPIC), int(SAMPLER_PAPER)})
            for (int i = 0; i < 4; ++i) {
                tested_sampler = sampler;
                const Pair p = with(plain::random_pair(engine, 0, i % 2 == 1), lobes);
                // As above; the corners of a table cost the rule some more accuracy.
                expect_near(mean_over_segment(p, 400, lobes), plain::transport(p), 1e-3, lobes.name + " sampler " + std::to_string(sampler) + " pair " + std::to_string(i));
            }
    tested_sampler = SAMPLER_PAPER_ISOTROPIC;
}

TEST(VirtualRayLight, TransportToASurfaceBySumsOfLobesEqualsQuadrature)
{
    std::mt19937 engine(32);
    for (const Lobes& lobes : all_lobes())
        for (int i = 0; i < 4; ++i) {
            SurfacePair s = plain::random_surface_pair(engine, 0, i % 2 == 1);
            s.light = with(s.light, lobes);
            glm::dvec3 sum(0);
            const int n = 4096;
            for (int k = 0; k < n; ++k) sum += Double::point(s, (k + .5) / n, lobes);
            expect_near(sum / double(n), plain::transport(s), 2e-4, lobes.name + " pair " + std::to_string(i));
        }
}

TEST(VirtualRayLight, AMissingLobeAndATableRunBackwardsAreSeen)
{
    std::mt19937 engine(33);
    std::vector<Lobes> planted{all_lobes()[1], all_lobes()[2]};
    std::reverse(planted[0].values.begin(), planted[0].values.end());
    planted[1].records[3].weight = 0;
    for (const Lobes& lobes : planted) {
        const Pair p = with(plain::random_pair(engine, 0, false), lobes);
        EXPECT_GT(std::abs(mean_over_segment(p, 128, lobes).x / plain::transport(p).x - 1), 1e-2) << lobes.name;
    }
}

TEST(VirtualRayLight, FloatAgreesWithDoubleInSumsOfLobes)
{
    std::mt19937 engine(34);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (const int sampler : {int(SAMPLER_PAPER_ISOTROPIC), int(SAMPLER_PAPER)})
        for (const Lobes& lobes : all_lobes()) {
            tested_sampler = sampler;
            std::vector<double> errors;
            for (int i = 0; i < 2000; ++i) {
                const Pair p = plain::as_float(with(plain::random_pair(engine, 0, i % 3 == 0), lobes));
                const float xi0 = uniform(engine), xi1 = uniform(engine);
                const glm::dvec3 f = Float::segment(p, xi0, xi1, lobes), d = Double::segment(p, xi0, xi1, lobes);
                ASSERT_TRUE(std::isfinite(f.x + f.y + f.z)) << "pair " << i;
                errors.push_back(glm::length(f - d) / glm::length(d));
            }
            std::sort(errors.begin(), errors.end());
            EXPECT_LT(errors[errors.size() / 2], 3e-6) << lobes.name;  // as for one lobe; the product's table has some thirty roundings more
            EXPECT_LT(errors[errors.size() * 99 / 100], 1e-4) << lobes.name;
        }
    tested_sampler = SAMPLER_PAPER_ISOTROPIC;
}

TEST(VirtualRayLight, APlantedErrorOfOnePerMilleIsSeen)
{
    std::mt19937 engine(11);
    const Pair p = plain::random_pair(engine, 0, false);
    const glm::dvec3 ours = mean_over_segment(p, 192) * 1.001, oracle = plain::transport(p);
    EXPECT_GT(std::abs(ours.x / oracle.x - 1), 5e-4);
}

TEST(VirtualRayLight, TransportToASurfaceEqualsQuadrature)
{
    std::mt19937 engine(12);
    for (const double g : {0.0, .55, -.7})
        for (const bool is_short : {false, true})
            for (int i = 0; i < 4; ++i) {
                const SurfacePair s = plain::random_surface_pair(engine, g, is_short);
                glm::dvec3 sum(0);
                const int n = 4096;
                for (int k = 0; k < n; ++k) sum += Double::point(s, (k + .5) / n);
                expect_near(sum / double(n), plain::transport(s), 5e-5, "g " + std::to_string(g) + " short " + std::to_string(is_short) + " pair " + std::to_string(i));
            }
}

TEST(VirtualRayLight, FloatAgreesWithDouble)
{
    const std::vector<double> errors = float_errors(13);
    EXPECT_LT(errors[errors.size() / 2], 1e-6);  // some ten roundings of 6e-8
    EXPECT_LT(errors.back(), 1e-3);              // pairs that nearly cross magnify the rounding of their ends (hard_cases row 4)
}

TEST(VirtualRayLight, SwappingEyeAndLightChangesNothing)
{
    std::mt19937 engine(14);
    for (int i = 0; i < 6; ++i) {
        const Pair p = plain::random_pair(engine, i % 2 ? .4 : 0, false);
        // The light travels along b; seen from its other end it would be an eye looking along b: reverse both directions of travel.
        const Pair swapped = plain::swapped(p);
        expect_near(mean_over_segment(p, 128), mean_over_segment(swapped, 128), 2e-3, "pair " + std::to_string(i));
    }
}

TEST(VirtualRayLight, IsLinearInItsFlux)
{
    std::mt19937 engine(15);
    for (const int exponent : {-60, -3, 5, 60}) {
        Pair p = plain::as_float(plain::random_pair(engine, .3, false));
        const glm::dvec3 one = Float::segment(p, .3, .6);
        p.flux *= std::ldexp(1.0, exponent);
        const glm::dvec3 scaled = Float::segment(p, .3, .6);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(scaled[c], std::ldexp(one[c], exponent)) << "2^" << exponent;
    }
}

TEST(VirtualRayLight, ADarkChannelStaysDark)
{
    std::mt19937 engine(16);
    Pair p = plain::as_float(plain::random_pair(engine, .3, true));
    p.flux.y = 0, p.share = {.5, 0, .5};
    const glm::dvec3 radiance = Float::segment(p, .3, .6);
    EXPECT_EQ(radiance.y, 0);
    EXPECT_GT(radiance.x, 0);
}

TEST(VirtualRayLight, DoesNotDependOnTheUnitOfLength)
{
    std::mt19937 engine(17);
    for (const int exponent : {-50, -10, 10, 50}) {  // 1e-15 ... 1e15
        const Pair p = plain::as_float(plain::random_pair(engine, .3, false));
        Pair q = p;
        const double k = std::ldexp(1.0, exponent);
        q.o *= k, q.p *= k, q.eye_length *= k, q.light_length *= k, q.sigma_t /= k, q.sigma_s /= k;  // L(k x, sigma / k, k^2 flux) = L; here flux stays, so L / k^2 ...
        const glm::dvec3 one = Float::segment(p, .3, .6), other = Float::segment(q, .3, .6);
        // ... and both sigma_s of the connection carry 1 / k each while du dv / w^2 carries none.
        for (int c = 0; c < 3; ++c) EXPECT_EQ(other[c] * k * k, one[c]) << "2^" << exponent;
    }
}

TEST(VirtualRayLight, ShortWeightsAreBoundedByTheShareOfTheChannel)
{
    std::mt19937 engine(18);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (int i = 0; i < 2000; ++i) {
        Pair p = plain::as_float(plain::random_pair(engine, 0, true));
        p.sigma_t *= 40.0;  // transmittances down to e^-100 and far apart between channels
        const float v = uniform(engine) * float(p.light_length);
        const maths_float::AlongLight along = maths_float::along_light(light_of<maths_float::VirtualRayLight>(p), medium_of(p), {v, v, v});
        for (int c = 0; c < 3; ++c) {
            const double weight = std::exp(-double(c == 0 ? along.depth.x : c == 1 ? along.depth.y : along.depth.z)) / along.divisor;
            EXPECT_LE(weight * p.share[c], 1 + 1e-5) << "balance heuristic over channels: share x weight <= 1";
        }
    }
}

TEST_P(BySampler, PlacesThatAreFoundWeighAsTheyDoWhenDrawn) { expect_found_places_to_weigh_as_drawn(61, 1e-6); }

TEST(VirtualRayLight, PlacesThatAreFoundWeighAsTheyDoWhenDrawn)
{
    expect_found_places_to_weigh_as_drawn(62, 1e-9);
    expect_found_places_seen_from_points_to_weigh_as_drawn(63);
}

TEST(VirtualRayLight, IsTheLineOfItsRecord) { expect_the_line_of_the_record(64); }

}  // namespace
}  // namespace tyndall
