#pragma once
/// Lights that are lines: places that another density has drawn (in density grids, where there is matter) weigh what the light's own steps would have given them, and what is drawn by either has the
/// weight of the mixture. After ray_on_host.hpp or its like; in double.
#include <random>

#include "tests/lights/both_precisions.hpp"

namespace tyndall {
namespace {

constexpr double other_density = .7, other_share = .05;

struct InDouble {
    Pair pair;
    MediumRecord medium = medium_of(pair);
    maths_double::Light light = light_of<maths_double::Light>(pair);
    maths_double::EyeSegmentLanes eye{{pair.o.x, pair.o.y, pair.o.z}, {pair.a.x, pair.a.y, pair.a.z}, {1, 1, 1}, pair.eye_length};
    maths_double::MediumLanes eye_medium{{pair.sigma_t.x, pair.sigma_t.y, pair.sigma_t.z}, {pair.sigma_s.x, pair.sigma_s.y, pair.sigma_s.z}, pair.g, {1, false, 0, {maths_double::phase_range(medium)}}};
    maths_double::PhaseTables tables{nullptr, nullptr};
};

/// tolerance: of a found weight, relative.
void expect_found_places_to_weigh_as_drawn(unsigned seed, double tolerance)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 300; ++i) {
        const InDouble x{plain::as_float(plain::random_pair(engine, i % 2 ? .55 : 0, i % 3 == 0))};
        const auto on_light = place_on_light(x.eye, x.eye_medium, x.light, x.medium, uniform(engine));
        const auto drawn = place_on_segment(x.eye, x.eye_medium, x.light, x.medium, on_light, x.tables, uniform(engine));
        const auto found = find_on_segment(x.eye, x.eye_medium, x.light, x.medium, find_on_light(x.eye, x.eye_medium, x.light, x.medium, drawn.v), x.tables, drawn.u);
        EXPECT_NEAR(found.weight / drawn.weight, 1, tolerance) << "pair " << i;
        EXPECT_EQ(found.u, drawn.u);
        EXPECT_EQ(found.v, drawn.v);
        const glm::dvec3 d = x.pair.p + drawn.v * x.pair.b - x.pair.o - drawn.u * x.pair.a;
        const double w2 = glm::dot(d, d), density = 1 / (drawn.weight * w2);
        const auto mixed = share_places(x.eye, x.light, drawn, other_density, other_share);
        EXPECT_NEAR(mixed.weight * w2 * ((1 - other_share) * density + other_share * other_density), 1, 1e-9) << "pair " << i;
    }
}

void expect_found_places_seen_from_points_to_weigh_as_drawn(unsigned seed)
{
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    int above = 0;
    for (int i = 0; i < 300; ++i) {
        const SurfacePair s = plain::random_surface_pair(engine, i % 2 ? .55 : 0, i % 3 == 0);
        const InDouble x{s.light};
        const maths_double::EyePointLanes eye{{s.x.x, s.x.y, s.x.z}, {s.n.x, s.n.y, s.n.z}, {s.n.x, s.n.y, s.n.z}, {1, 1, 1}};
        const auto drawn = place_on_light_from_point(eye, x.light, uniform(engine));
        const auto found = find_on_light_from_point(eye, x.light, drawn.v);
        const glm::dvec3 d = s.light.p + drawn.v * s.light.b - s.x;
        const double w = glm::length(d), rise = glm::dot(s.n, d);
        if (!(drawn.weight > 0) || !(rise > 0)) continue;
        ++above;
        EXPECT_NEAR(found.weight / drawn.weight, 1, 1e-6) << "pair " << i;
        const double density = rise / (w * w * w * drawn.weight);
        const auto mixed = share_place(eye, x.light, drawn, other_density, other_share);
        EXPECT_NEAR(mixed.weight * w * w * w / rise * ((1 - other_share) * density + other_share * other_density), 1, 1e-6) << "pair " << i;
    }
    EXPECT_GT(above, 50);
}

/// What the stages ask of a light that is a line.
void expect_the_line_of_the_record(unsigned seed)
{
    std::mt19937 engine(seed);
    for (int i = 0; i < 10; ++i) {
        const Pair p = plain::as_float(plain::random_pair(engine, .55, i % 2 == 0));
        const auto light = light_of<maths_double::Light>(p);
        const auto o = light_origin(light), b = light_direction(light);
        EXPECT_EQ(glm::dvec3(o.x, o.y, o.z), p.p);
        EXPECT_EQ(glm::dvec3(b.x, b.y, b.z), p.b);
        EXPECT_EQ(light_length(light), static_cast<float>(p.light_length));
        EXPECT_EQ(light_is_even(light), p.is_short ? 1u : 0u);
        EXPECT_EQ(light_medium(light), 0u);
        EXPECT_EQ(light_depth(light), 0u);
    }
}

}  // namespace
}  // namespace tyndall
