#include "tests/device/random_pairs.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstring>
#include <random>
namespace tyndall {
static int host_sampler = SAMPLER_PAPER_ISOTROPIC;  // the device's build option as a variable
}
#undef SAMPLER
#define SAMPLER host_sampler
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall {
namespace maths_float {
#include "kernels/lights/virtual_ray_light.h"
}
#undef VIRTUAL_RAY_LIGHT_H
namespace maths_double {
#include "kernels/lights/virtual_ray_light.h"
}
}  // namespace tyndall

namespace tyndall::testing {
namespace {

glm::vec3 random_direction(std::mt19937& engine)
{
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(engine), normal(engine), normal(engine)));
}

std::vector<maths_float::VirtualRayLight> lights_of(const RandomPairs& pairs)
{
    std::vector<maths_float::VirtualRayLight> lights(pairs.light_count);
    std::memcpy(lights.data(), pairs.lights.data(), lights.size() * sizeof lights[0]);
    return lights;
}

void add_container(MediaTables& tables)
{
    tables.containers.push_back({0, 0, 6, 0});
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0f, 1.0f}) tables.planes.push_back({axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0, 1.0f});
}

void add_lobes(MediaTables& tables)
{
    tables.lobes = {{PHASE_LOBE_HENYEY_GREENSTEIN, .4f, .7f, 0, 0, 0, 0, 0}, {PHASE_LOBE_HENYEY_GREENSTEIN, .1f, -.5f, 0, 0, 0, 0, 0}, {PHASE_LOBE_RAYLEIGH, .2f, 0, 0, 0, 0, 0, 0},
                    {PHASE_LOBE_TABLE, .3f, .2f, 3, 4, 0, 0, 0}};
    tables.phase_values = {9, 9, 9, .05f, .02f, .1f, .2f, 9};  // what is not the table's must not be read
    tables.media[0].lobe_count = 4, tables.media[0].g = .29f;
}

maths_double::real3 wide(float x, float y, float z) { return {x, y, z}; }

}  // namespace

RandomPairs random_pairs(const PairWishes& wishes, bool container)
{
    RandomPairs pairs;
    std::mt19937 engine(wishes.seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const float tint = wishes.coloured ? .5f : 0;
    pairs.tables.media.push_back({1, 1 + tint, 1 + 2 * tint, static_cast<float>(wishes.g), .8f, .7f, .6f, 0, 0, NO_GRID, NO_GRID, 0});
    if (wishes.lobes) add_lobes(pairs.tables);
    if (wishes.two_media) pairs.tables.media.push_back({1.5f, 1.2f, 1, .35f, .9f, .8f, .7f, 0, 0, NO_GRID, NO_GRID, 0});
    if (container) add_container(pairs.tables);
    for (std::uint32_t i = 0; i < wishes.eyes; ++i) {
        const glm::vec3 d = random_direction(engine), o = .45f * glm::vec3(uniform(engine), uniform(engine), uniform(engine)), n = random_direction(engine);
        pairs.segments.push_back({o.x, o.y, o.z, .3f + .2f * uniform(engine), d.x, d.y, d.z, wishes.two_media ? i / 2 % 2 : 0, 1, .9f, .8f, i % 3, i, static_cast<uint>(engine()), 0, 0});
        pairs.points.push_back({o.x, o.y, o.z, 0, n.x, n.y, n.z, i % 3, 1, .9f, .8f, i, n.x, n.y, n.z, static_cast<uint>(engine())});
    }
    std::vector<maths_float::VirtualRayLight> lights;
    for (std::uint32_t i = 0; i < wishes.lights; ++i) {
        const glm::vec3 d = random_direction(engine), o = .6f * glm::vec3(uniform(engine), uniform(engine), uniform(engine));
        lights.push_back({o.x, o.y, o.z, .2f + .15f * uniform(engine), d.x, d.y, d.z, wishes.two_media ? i % 2 : 0, 1 + .5f * uniform(engine), 1, 1, i % 4, .5f, .3f, .2f, wishes.short_lights ? 1u : 0u});
    }
    pairs.light_count = wishes.lights;
    pairs.lights.resize(lights.size() * sizeof lights[0]);
    std::memcpy(pairs.lights.data(), lights.data(), pairs.lights.size());
    return pairs;
}

void set_flux(RandomPairs& pairs, std::uint32_t light, float red)
{
    std::memcpy(pairs.lights.data() + light * sizeof(maths_float::VirtualRayLight) + offsetof(maths_float::VirtualRayLight, flux_r), &red, sizeof red);
}

void lay_light_across(RandomPairs& pairs, std::uint32_t light)
{
    EyeSegment& eye = pairs.segments.front();
    eye.origin_x = eye.origin_y = eye.origin_z = 0, eye.length = .5f, eye.direction_x = 1, eye.direction_y = eye.direction_z = 0;
    auto all = lights_of(pairs);
    maths_float::VirtualRayLight& l = all[light];
    l.origin_x = .25f, l.origin_y = -.25f, l.origin_z = 0, l.length = .5f, l.direction_x = l.direction_z = 0, l.direction_y = 1;
    std::memcpy(pairs.lights.data(), all.data(), pairs.lights.size());
}

void degenerate(RandomPairs& pairs)
{
    auto all = lights_of(pairs);
    for (std::size_t i = 0; i < all.size(); ++i) {
        maths_float::VirtualRayLight& l = all[i];
        const EyeSegment& eye = pairs.segments[i % pairs.segments.size()];
        const float wiggle = std::pow(10.f, -float(i / 8 % 8)), along = .3f * eye.length;
        if (i % 8 < 4) l.direction_x = eye.direction_x, l.direction_y = eye.direction_y, l.direction_z = eye.direction_z;                              // parallel
        if (i % 8 < 2) l.origin_x = eye.origin_x + wiggle * l.direction_y, l.origin_y = eye.origin_y - wiggle * l.direction_x, l.origin_z = eye.origin_z;  // and close
        if (i % 8 == 2) l.origin_x = eye.origin_x + along * l.direction_x, l.origin_y = eye.origin_y + along * l.direction_y, l.origin_z = eye.origin_z + along * l.direction_z;
        if (i % 8 == 4) l.origin_x = eye.origin_x, l.origin_y = eye.origin_y, l.origin_z = eye.origin_z;
        if (i % 8 == 5)
            l.origin_x = eye.origin_x + along * eye.direction_x - .1f * l.direction_x, l.origin_y = eye.origin_y + along * eye.direction_y - .1f * l.direction_y,
            l.origin_z = eye.origin_z + along * eye.direction_z - .1f * l.direction_z;
        if (i % 8 == 6) l.length = 0;
    }
    std::memcpy(pairs.lights.data(), all.data(), pairs.lights.size());
}

std::vector<double> host_sums(const RandomPairs& pairs, EyeKind kind, int sampler, int sequence)
{
    using namespace maths_double;
    host_sampler = sampler;
    const auto lights = lights_of(pairs);
    const PhaseTables tables{pairs.tables.lobes.data(), pairs.tables.phase_values.data()};
    std::vector<double> sums;
    for (std::size_t i = 0; i < pairs.segments.size(); ++i) {
        glm::dvec3 sum(0);
        const EyeSegment& s = pairs.segments[i];
        const EyePoint& p = pairs.points[i];
        const MediumRecord m = pairs.tables.media[s.medium];
        const MediumLanes eye_medium{wide(m.sigma_t_r, m.sigma_t_g, m.sigma_t_b), wide(m.sigma_s_r, m.sigma_s_g, m.sigma_s_b), m.g, {1, m.lobe_count > 0, 0, {phase_range(m)}}};
        for (uint k = 0; k < pairs.light_count; ++k) {
            maths_double::VirtualRayLight light;
            std::memcpy(&light, &lights[k], sizeof light);
            const MediumRecord medium = pairs.tables.media[light.medium];
            const uint key = kind == EyeKind::segments ? s.key : p.key;
            const auto xi = sequence == SEQUENCE_SOBOL ? maths_float::scrambled_sobol2(key, k) : maths_float::random2(key, k);
            const Connection c = kind == EyeKind::segments
                                     ? connect_segment({wide(s.origin_x, s.origin_y, s.origin_z), wide(s.direction_x, s.direction_y, s.direction_z),
                                                        wide(s.throughput_r, s.throughput_g, s.throughput_b), s.length},
                                                       eye_medium, light, medium, tables, {xi.first, xi.second})
                                     : connect_point({wide(p.position_x, p.position_y, p.position_z), wide(p.normal_x, p.normal_y, p.normal_z),
                                                      wide(p.facing_x, p.facing_y, p.facing_z), wide(p.throughput_r, p.throughput_g, p.throughput_b)},
                                                     light, medium, tables, {xi.first, xi.second});
            sum += glm::dvec3(c.radiance.x, c.radiance.y, c.radiance.z) * glm::exp(-glm::dvec3(medium.sigma_t_r, medium.sigma_t_g, medium.sigma_t_b) * c.length);
        }
        sums.insert(sums.end(), {sum.x, sum.y, sum.z});
    }
    return sums;
}

namespace {
void begin(PairStage& stage, const RandomPairs& pairs, EyeKind kind, std::uint32_t vertex_limit)
{
    const auto bytes = kind == EyeKind::segments ? std::as_bytes(std::span(pairs.segments)) : std::as_bytes(std::span(pairs.points));
    stage.begin(bytes, static_cast<std::uint32_t>(pairs.segments.size()), pairs.lights, vertex_limit);
}
}  // namespace

std::vector<double> gathered(PairStage& stage, const RandomPairs& pairs, EyeKind kind, std::uint32_t tile_groups, std::uint32_t tile_lights, std::uint32_t vertex_limit)
{
    begin(stage, pairs, kind, vertex_limit);
    for (std::uint32_t light = 0; light < pairs.light_count; light += tile_lights)
        for (std::uint32_t group = 0; group < stage.groups(); group += tile_groups)
            stage.gather({group, std::min(tile_groups, stage.groups() - group), light, std::min(tile_lights, pairs.light_count - light)});
    return stage.sums();
}

std::vector<double> sampled_and_accumulated(PairStage& stage, const RandomPairs& pairs, EyeKind kind, std::uint32_t tile_groups)
{
    begin(stage, pairs, kind, 0xffffffffu);
    int slot = 0;
    for (std::uint32_t light = 0; light < pairs.light_count; light += light_block)
        for (std::uint32_t group = 0; group < stage.groups(); group += tile_groups, slot = 1 - slot) {
            stage.sample(slot, {group, std::min(tile_groups, stage.groups() - group), light, std::min(light_block, pairs.light_count - light)});
            stage.sampled(slot);
            stage.accumulate(slot);
        }
    return stage.sums();
}

}  // namespace tyndall::testing
