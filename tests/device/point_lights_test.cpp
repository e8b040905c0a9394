/// Virtual point lights on the device at every lane width, against the same mathematics on the host in double.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/glm.hpp>

#include "kernels/shared/host_features.hpp"
#include "tests/device/random_pairs.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall {
namespace maths_double {
#include "kernels/lights/virtual_point_light.h"
}
namespace {

using maths_double::VirtualPointLight;
using testing::RandomPairs;

/// The pairs with a point at the origin of every ray.
RandomPairs with_points(RandomPairs pairs)
{
    std::vector<VirtualPointLight> points;
    for (uint i = 0; i < pairs.light_count; ++i) {
        maths_double::RayLight ray;
        std::memcpy(&ray, pairs.lights.data() + i * sizeof ray, sizeof ray);
        points.push_back({ray.origin_x, ray.origin_y, ray.origin_z, ray.medium, ray.direction_x, ray.direction_y, ray.direction_z, ray.depth, ray.flux_r, ray.flux_g, ray.flux_b, 0});
    }
    pairs.lights.resize(points.size() * sizeof points[0]);
    std::memcpy(pairs.lights.data(), points.data(), pairs.lights.size());
    return pairs;
}

std::vector<double> sums_on_the_host(const RandomPairs& pairs, EyeKind kind)
{
    using namespace maths_double;
    std::vector<double> sums;
    const auto v = [](float x, float y, float z) { return real3{x, y, z}; };
    for (std::size_t i = 0; i < pairs.segments.size(); ++i) {
        glm::dvec3 sum(0);
        const EyeSegment& s = pairs.segments[i];
        const EyePoint& p = pairs.points[i];
        const MediumRecord m = pairs.tables.media[0];
        const MediumLanes eye_medium{v(m.sigma_t_r, m.sigma_t_g, m.sigma_t_b), v(m.sigma_s_r, m.sigma_s_g, m.sigma_s_b), m.g, {1, 0, 0, {phase_range(m)}}};
        for (uint k = 0; k < pairs.light_count; ++k) {
            VirtualPointLight light;
            std::memcpy(&light, pairs.lights.data() + k * sizeof light, sizeof light);
            const auto xi = maths_float::random2(kind == EyeKind::segments ? s.key : p.key, k);
            const Connection c =
                kind == EyeKind::segments
                    ? connect_segment({v(s.origin_x, s.origin_y, s.origin_z), v(s.direction_x, s.direction_y, s.direction_z), v(s.throughput_r, s.throughput_g, s.throughput_b), s.length},
                                      eye_medium, light, m, {}, {xi.first, xi.second})
                    : connect_point({v(p.position_x, p.position_y, p.position_z), v(p.normal_x, p.normal_y, p.normal_z), v(p.facing_x, p.facing_y, p.facing_z),
                                     v(p.throughput_r, p.throughput_g, p.throughput_b)},
                                    light, m, {}, {xi.first, xi.second});
            sum += glm::dvec3(c.radiance.x, c.radiance.y, c.radiance.z) * glm::exp(-glm::dvec3(m.sigma_t_r, m.sigma_t_g, m.sigma_t_b) * c.length);
        }
        sums.insert(sums.end(), {sum.x, sum.y, sum.z});
    }
    return sums;
}

PairProgram program(EyeKind kind, std::uint32_t features, int lanes)
{
    return {.light = "virtual_point_light", .light_bytes = sizeof(VirtualPointLight), .light_is_line = false, .eyes = kind, .features = features, .lanes = lanes};
}

class PointsAtEveryLaneWidth : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(PointLights, PointsAtEveryLaneWidth, ::testing::Values(1, 4, 8, 16));

TEST_P(PointsAtEveryLaneWidth, SumsEqualTheHostsInDouble)
{
    Device device;
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
        const auto pairs = with_points(testing::random_pairs({.g = .55, .coloured = true}));
        PairStage stage(device, program(kind, feature_bit::anisotropic | feature_bit::coloured, GetParam()), pairs.tables);
        const auto on_device = testing::gathered(stage, pairs, kind, 1000, 1024), on_host = sums_on_the_host(pairs, kind);
        // A sum of 300 positive terms, each good to some 1e-6; near contact it is the rounding of positions that counts.
        for (std::size_t i = 0; i < on_host.size(); ++i) EXPECT_NEAR(on_device[i] / (on_host[i] + 1e-30), on_host[i] > 0 ? 1 : 0, 2e-5) << i;
        EXPECT_EQ(stage.ledger().not_finite, 0u);
    }
}

TEST_P(PointsAtEveryLaneWidth, TouchingPairsAreFinite)
{
    Device device;
    for (const EyeKind kind : {EyeKind::segments, EyeKind::points}) {
        auto rays = testing::random_pairs({.g = .55});
        testing::degenerate(rays);
        auto pairs = with_points(rays);
        for (std::size_t i = 0; i < pairs.points.size(); i += 2)  // some surface points stand where a light does
            std::memcpy(&pairs.points[i].position_x, pairs.lights.data() + i * sizeof(VirtualPointLight), 12);
        PairStage stage(device, program(kind, feature_bit::anisotropic, GetParam()), pairs.tables);
        for (const double x : testing::gathered(stage, pairs, kind, 1000, 1024)) EXPECT_TRUE(std::isfinite(x));
        EXPECT_EQ(stage.ledger().not_finite, 0u);
        EXPECT_GE(stage.ledger().floored, kind == EyeKind::points ? pairs.points.size() / 2 : 0);
    }
}

}  // namespace
}  // namespace tyndall
