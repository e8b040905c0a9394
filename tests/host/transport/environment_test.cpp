// Light from an environment map: where which radiance comes from, and directions in proportion to it.
#include "scene/environment_maps.hpp"

#include <random>

#include "built_scene.hpp"
#include "scene/transforms.hpp"
#include "statistics.hpp"
#include "transport/emitter.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

EnvironmentMap map_of(int width, int height, std::vector<float> texels)
{
    EnvironmentMap map{.name = "sky.exr", .width = width, .height = height, .texels = std::move(texels)};
    prepare_environment(map);
    return map;
}

/// Texels from 0 to 1, cubed, so that some are dark; one row is black and one texel 300.
EnvironmentMap rugged()
{
    constexpr int width = 7, height = 6;
    std::minstd_rand random(3);
    std::vector<float> texels;
    for (int i = 0; i < 3 * width * height; ++i) texels.push_back(i / (3 * width) == 1 ? 0.f : std::pow(static_cast<float>(random() % 1000) / 1000, 3.f));
    for (int c = 0; c < 3; ++c) texels[static_cast<std::size_t>(3 * (4 * width + 2) + c)] = 300;
    return map_of(width, height, texels);
}

/// As Mitsuba 3.9.1 evaluates the same map with scale 2 and a to_world that turns by 90 degrees around y.
TEST(Environment, RadianceIsWhereMitsubaHasIt)
{
    std::vector<float> texels;
    for (int i = 0; i < 36; ++i) texels.push_back(static_cast<float>(i) / 10 + .1f);
    BuiltScene built;
    built.scene.environment_maps.push_back(map_of(4, 3, texels));
    const Emitter emitter{.type = Emitter::Type::envmap, .value = Rgb(2), .map = 0, .map_to_world = Mat3(rotation({0, 1, 0}, 90))};
    const std::pair<Vec3, double> rows[] = {{{0, 0, 1}, 4.1}, {{0, 0, -1}, 2.9}, {{1, 0, 0}, 3.5}, {{-1, 0, 0}, 3.5}, {{.6, .48, .64}, 3.0473735}, {{-.6, .64, .48}, 3.2120802}, {{.36, -.48, -.8}, 3.8264625}};
    for (const auto& [direction, red] : rows) {
        const Rgb radiance = radiance_from_outside(built.scene, emitter, direction);
        EXPECT_NEAR(radiance.r, red, 2e-6) << direction.x << " " << direction.y;
        EXPECT_NEAR(radiance.g, red + .2, 2e-6);
        EXPECT_NEAR(radiance.b, red + .4, 2e-6);
    }
}

/// A cell of the map, by formulas of this test.
std::pair<int, int> cell_of(const EnvironmentMap& map, const Vec3& d)
{
    const double turn = std::atan2(d.x, -d.z) / (2 * pi) * map.width - .5;
    return {static_cast<int>(std::floor(std::acos(d.y) / pi * (map.height - 1))), static_cast<int>(std::floor(turn < 0 ? turn + map.width : turn))};
}

TEST(Environment, DirectionsFollowTheirDensityWhichIntegratesToOne)
{
    const EnvironmentMap map = rugged();
    constexpr int draws = 400000;
    const std::size_t cells = static_cast<std::size_t>(map.width * (map.height - 1));
    std::vector<double> observed(cells, 0), expected;
    RandomSequence random = numbers(1);
    for (int i = 0; i < draws; ++i) {
        const EnvironmentSample s = sample_environment(map, random.next2());
        ASSERT_NEAR(glm::length(s.towards), 1, 1e-12);
        ASSERT_NEAR(pdf_environment(map, s.towards) / s.pdf, 1, 1e-9);
        const auto [row, column] = cell_of(map, s.towards);
        ++observed[static_cast<std::size_t>(row * map.width + column)];
    }
    double total = 0;
    for (int y = 0; y + 1 < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            const double top = std::cos(pi * y / (map.height - 1)), bottom = std::cos(pi * (y + 1) / (map.height - 1)), c = .5 * (top + bottom), s = std::sqrt(1 - c * c);
            const double azimuth = 2 * pi * (x + 1.) / map.width, solid_angle = (top - bottom) * 2 * pi / map.width;
            expected.push_back(draws * solid_angle * pdf_environment(map, {s * std::sin(azimuth), c, -s * std::cos(azimuth)}));
            total += expected.back() / draws;
        }
    EXPECT_NEAR(total, 1, 1e-12);
    std::vector<double> seen{0}, awaited{0};  // those that expect few draws as one
    for (std::size_t i = 0; i < cells; ++i) {
        const bool rare = expected[i] < 8;
        if (!rare) seen.push_back(0), awaited.push_back(0);
        (rare ? seen.front() : seen.back()) += observed[i], (rare ? awaited.front() : awaited.back()) += expected[i];
    }
    if (awaited.front() <= 5) {
        seen[1] += seen.front(), awaited[1] += awaited.front();
        seen.erase(seen.begin()), awaited.erase(awaited.begin());
    }
    EXPECT_GT(chi_square_p(seen, awaited), 1e-6);
}

/// Nearly every direction leads there, and radiance over density varies little.
TEST(Environment, TheSunIsFound)
{
    const EnvironmentMap map = rugged();
    RandomSequence random = numbers(2);
    Mean weight;
    for (int i = 0; i < 20000; ++i) {
        const EnvironmentSample s = sample_environment(map, random.next2());
        weight.add(radiance_from(map, s.towards).g / s.pdf);
    }
    EXPECT_LT(weight.error() * std::sqrt(20000.), weight.value()) << "spread of one sample";
}

/// Radiance over all directions, by the trapezoid rule over the texels themselves, in one dimension at a time.
TEST(Environment, PowerIsTheMeanEmissionAndAgreesWithQuadrature)
{
    BuiltScene built;
    built.square({0, 0, 0}, {0, 1, 0}, .5, built.diffuse(Rgb(.5)));
    built.scene.environment_maps.push_back(rugged());
    built.emitter({.type = Emitter::Type::envmap, .value = Rgb(.5), .map = 0, .map_to_world = Mat3(rotation({1, 2, 3}, 50))});
    const EnvironmentMap& map = built.scene.environment_maps[0];
    const EmitterSampler emitters(built.scene);
    // over a column's azimuth linear interpolation integrates to the mean of the row; over the angle: linear times sine
    double integral = 0;
    const auto row_mean = [&](int y) {
        double sum = 0;
        for (int x = 0; x < map.width; ++x) sum += map.texels[static_cast<std::size_t>(3 * (y * map.width + x) + 1)];
        return sum / map.width;
    };
    for (int y = 0; y + 1 < map.height; ++y) {
        const double a = pi * y / (map.height - 1), b = pi * (y + 1) / (map.height - 1), above = row_mean(y), below = row_mean(y + 1);
        integral += 2 * pi * double(integrate([&](long double t) { return (above + (below - above) * (t - a) / (b - a)) * std::sin(t); }, a, b, 1e-12L));
    }
    RandomSequence random = numbers(3);
    Mean sent;
    for (int i = 0; i < 200000; ++i) {
        const Vec2 where = random.next2();
        sent.add(sample_emission(emitters, 0, where, random.next2()).weight.g);
    }
    const double expected = .5 * integral * pi * emitters.scene_radius() * emitters.scene_radius();
    EXPECT_LT(sent.error(), .01 * expected) << "the test is too weak";
    expect_mean(sent, expected, "power");
}

TEST(Environment, ABlackMapGivesNoLightAndStaysFinite)
{
    BuiltScene built;
    built.scene.environment_maps.push_back(map_of(4, 3, std::vector<float>(36, 0.f)));
    built.emitter({.type = Emitter::Type::envmap, .map = 0});
    const EmitterSampler emitters(built.scene);
    EXPECT_TRUE(emitters.empty());
    const DirectSample sample = sample_direct(emitters, 0, Vec3(0), {.3, .6});
    EXPECT_EQ(sample.weight, Rgb(0));
    EXPECT_NEAR(glm::length(sample.direction), 1, 1e-12);
    EXPECT_GT(sample.pdf, 0);
}

}  // namespace
