/// Every kernel of the covering set at small odd sizes. What it checks itself is that nothing comes out that is not a number; what it is for is to run under Oclgrind (tests/oclgrind.sh), which sees
/// every access outside a buffer, every value that was never written and every race.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/shared/host_features.hpp"
#include "lights/light_technique.hpp"
#include "tests/device/grid_pairs.hpp"
#include "tests/support/kernel_variants.hpp"

namespace tyndall::test {
namespace {

using testing::RandomPairs;

constexpr std::uint32_t light_count = 7, slots = 5;  ///< neither is a multiple of a batch

/// Lights of any kind, as the pipeline makes them.
std::vector<std::byte> lights_of(std::string_view name)
{
    std::vector<std::byte> records;
    for (const LightTechnique& technique : light_techniques())
        for (std::uint32_t i = 0; technique.name == name && i < light_count; ++i) {
            const double t = .3 * i;
            const Vec3 direction = glm::normalize(Vec3(std::cos(t), std::sin(t), .4));
            if (technique.arrive) technique.arrive({.position = Vec3(0), .direction = direction, .facing = -direction, .flux = Rgb(1, .5, .25), .depth = static_cast<int>(i % 3), .radius = 5, .off_surface = .5 * Vec3(std::sin(3 * t), std::cos(5 * t), std::sin(7 * t)),
                                                    .normal = -direction, .reflected = Rgb(.5, .25, .125), .medium = static_cast<int>(i % 2)}, records);
            else technique.deposit({.origin = .5 * Vec3(std::sin(3 * t), std::cos(5 * t), std::sin(7 * t)), .direction = direction, .length = .3 + .02 * i, .medium = 0, .flux = Rgb(1, .5, .25),
                               .depth = static_cast<int>(i % 3), .is_short = i % 2 == 1, .channel = Rgb(.5, .3, .2), .collision = .1, .radius = .05, .scattered = Rgb(.4)}, records);
        }
    return records;
}

/// Eyes, and tables with everything in them: containers, lobes, grids of as many channels as the program reads.
RandomPairs everything(const PairProgram& program)
{
    RandomPairs pairs = testing::grid_pairs({.g = .4, .coloured = (program.features & feature_bit::coloured_grids) != 0, .albedo = true, .homogeneous_beside = true});
    if (!(program.features & feature_bit::heterogeneous))
        for (MediumRecord& medium : pairs.tables.media) medium.density_grid = medium.albedo_grid = NO_GRID;
    const RandomPairs lobes = testing::random_pairs({.eyes = 16, .lights = 1, .lobes = true});
    if (program.features & feature_bit::phase_lobes) {
        pairs.tables.lobes = lobes.tables.lobes, pairs.tables.phase_values = lobes.tables.phase_values;
        pairs.tables.media[0].first_lobe = 0, pairs.tables.media[0].lobe_count = 4;
    }
    const auto segments = pairs.segments;
    const auto points = pairs.points;
    for (int copy = 1; copy < 3; ++copy) {  // three groups of 16
        pairs.segments.insert(pairs.segments.end(), segments.begin(), segments.begin() + 16);
        pairs.points.insert(pairs.points.end(), points.begin(), points.begin() + 16);
    }
    pairs.lights = lights_of(program.light), pairs.light_count = light_count;
    return pairs;
}

std::span<const std::byte> eyes_of(const RandomPairs& pairs, EyeKind kind)
{
    return kind == EyeKind::segments ? std::as_bytes(std::span(pairs.segments)) : std::as_bytes(std::span(pairs.points));
}

void select_lights(PairStage& stage, const RandomPairs& pairs, EyeKind kind)
{
    const std::vector<EyeBlock> blocks{{0, 2, 77, 0, 0, 1, 0, 0}, {2, 1, 78, 1, 0, 1, 0, 0}};
    stage.select({.standing = eyes_of(pairs, kind).first(16 * (kind == EyeKind::segments ? sizeof(EyeSegment) : sizeof(EyePoint))), .standing_count = 16, .blocks = blocks, .slots = slots});
}

/// Every light is near.
void gather_all(PairStage& stage)
{
    std::vector<std::uint32_t> starts{0}, near;
    for (std::uint32_t group = 0; group < 3; ++group) {
        for (std::uint32_t i = 0; i < light_count; ++i) near.push_back(i);
        starts.push_back(static_cast<std::uint32_t>(near.size()));
    }
    stage.gather_near(starts, near);
}

void run_all_pairs(PairStage& stage, const PairProgram& program)
{
    const std::uint32_t lights = program.selection ? slots : light_count;
    for (std::uint32_t first = 0, groups = 16u / static_cast<std::uint32_t>(program.lanes); first < stage.groups(); first += groups) {
        const PairTile tile{first, groups, 0, lights};
        if (!(program.features & feature_bit::occluders)) stage.gather(tile);
        else stage.sample(0, tile), stage.sampled(0), stage.accumulate(0);
    }
}

class EveryVariant : public ::testing::TestWithParam<Choices> {};

TEST_P(EveryVariant, RunsAtOddSizes)
{
    static Device device;
    const PairProgram program = program_of(GetParam());
    if (program.precision == 64 && !device.info().fp64) GTEST_SKIP() << "no 64-bit numbers here";
    const RandomPairs pairs = everything(program);
    PairStage stage(device, program, pairs.tables);
    stage.begin(eyes_of(pairs, program.eyes), static_cast<std::uint32_t>(pairs.segments.size()), pairs.lights, 4);
    if (program.selection) select_lights(stage, pairs, program.eyes);
    if (program.gathers) gather_all(stage);
    else run_all_pairs(stage, program);
    const std::vector<double> sums = stage.sums();
    ASSERT_EQ(sums.size(), pairs.segments.size() * 3 * program.sums_of_eye());
    for (const double sum : sums) ASSERT_TRUE(std::isfinite(sum));
    EXPECT_EQ(stage.ledger().not_finite, 0u);
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryVariant, ::testing::ValuesIn(covering_choices()), [](const auto& info) { return name_of(info.param); });

}  // namespace
}  // namespace tyndall::test
