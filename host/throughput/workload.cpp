#include "throughput/workload.hpp"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "kernels/shared/host_features.hpp"
// The kernels' macros come after everything that is not theirs.
// clang-format off
#include "kernels/dialect_host.hpp"
// clang-format on

namespace tyndall::maths_float {
#include "kernels/lights/virtual_ray_light.h"
}

namespace tyndall {
namespace {

glm::vec3 random_point(std::mt19937& engine)
{
    std::uniform_real_distribution<float> uniform(-1, 1);
    const float x = uniform(engine), y = uniform(engine);
    return {x, y, uniform(engine)};
}

glm::vec3 random_direction(std::mt19937& engine)
{
    glm::vec3 p;
    do p = random_point(engine);
    while (glm::dot(p, p) > 1 || glm::dot(p, p) < .01f);
    return glm::normalize(p);
}

glm::vec3 eye_direction(const WorkloadWishes& wishes, std::uint32_t i, std::mt19937& engine)
{
    constexpr std::uint32_t row = 64, middle = row / 2;
    if (wishes.camera) {
        const std::uint32_t column = i % row, line = i / row, lines = wishes.eyes / row;
        return glm::normalize(glm::vec3((float(column) + .5f - float(middle)) / row, (float(line) + .5f - float(lines) / 2) / row, .866f));
    }
    const glm::vec3 d = random_direction(engine);
    return glm::normalize(glm::vec3(d.x, d.y, std::abs(d.z) + 1));
}

constexpr float box_side = 1.5f;  ///< half of it

/// Where the ray is inside of the box: distances from `o`, in units of |d|; enter > leave: nowhere.
struct Inside {
    float enter, leave;
};
Inside inside_box(const glm::vec3& o, const glm::vec3& d, float half, float length)
{
    Inside inside{0, length};
    for (int k = 0; k < 3; ++k) {
        const float a = (-half - o[k]) / d[k], b = (half - o[k]) / d[k];
        inside.enter = std::max(inside.enter, std::min(a, b)), inside.leave = std::min(inside.leave, std::max(a, b));
    }
    return inside;
}

void cut_eyes(Workload& work, float half)
{
    for (EyeSegment& e : work.eyes) {
        const glm::vec3 o(e.origin_x, e.origin_y, e.origin_z), d(e.direction_x, e.direction_y, e.direction_z);
        const Inside in = inside_box(o, d, half, e.length);
        const glm::vec3 start = o + in.enter * d, end = o + in.leave * d;
        e.origin_x = start.x, e.origin_y = start.y, e.origin_z = start.z, e.length = std::max(in.leave - in.enter, 0.f);
        EyePoint& p = work.points[e.pixel];
        p.position_x = end.x, p.position_y = end.y, p.position_z = end.z;
    }
}

void add_grid(Workload& work, const WorkloadWishes& wishes, std::mt19937& engine)
{
    const uint n = wishes.grid;
    const float rows = float(n) / (2 * box_side * wishes.scale), middle = float(n) / 2;
    work.tables.grids.push_back({rows, 0, 0, middle, 0, rows, 0, middle, 0, 0, rows, middle, n, n, n, 0});
    work.tables.media[0].density_grid = 0;
    std::uniform_real_distribution<float> uniform(0, 1);
    glm::vec4 waves[8];
    for (glm::vec4& w : waves) w = glm::vec4(random_direction(engine) * 6.2832f / (1 + 3 * uniform(engine)), 6.2832f * uniform(engine));
    for (uint z = 0; z < n; ++z)
        for (uint y = 0; y < n; ++y)
            for (uint x = 0; x < n; ++x) {
                float value = 1;
                for (const glm::vec4& w : waves) value += .5f * std::cos(glm::dot(glm::vec3(w), (glm::vec3(x, y, z) + .5f) / rows) + w.w);
                work.tables.voxels.push_back(std::max(value, 0.f));
            }
}

}  // namespace

Workload make_workload(const WorkloadWishes& wishes)
{
    Workload work;
    std::mt19937 engine(wishes.seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    const glm::vec3 sigma_t = (wishes.coloured ? glm::vec3(.4f, .5f, .7f) : glm::vec3(.5f)) / wishes.scale, sigma_s = .8f * sigma_t;
    work.tables.media.push_back({sigma_t.x, sigma_t.y, sigma_t.z, static_cast<float>(wishes.g), sigma_s.x, sigma_s.y, sigma_s.z, 0, 0, NO_GRID, NO_GRID, 0});
    for (std::uint32_t i = 0; i < wishes.eyes; ++i) {
        const glm::vec3 d = eye_direction(wishes, i, engine);
        work.eyes.push_back(
            {0, 0, -3 * wishes.scale, 6 * wishes.scale, d.x, d.y, d.z, 0, 1, .9f, .8f, 0, i, static_cast<uint>(engine()), 0, 0});
        const glm::vec3 end = glm::vec3(0, 0, -3 * wishes.scale) + 6 * wishes.scale * d;
        work.points.push_back({end.x, end.y, end.z, 0, -d.x, -d.y, -d.z, 0, 1, .9f, .8f, i, -d.x, -d.y, -d.z, work.eyes.back().key});
    }
    if (wishes.in_box) cut_eyes(work, box_side * wishes.scale);
    std::vector<maths_float::VirtualRayLight> lights;
    for (std::uint32_t i = 0; i < wishes.lights; ++i) {
        const glm::vec3 o = wishes.scale * random_point(engine);
        float length = wishes.scale * (1 + .5f * uniform(engine));
        const glm::vec3 d = random_direction(engine);
        if (wishes.in_box) length = inside_box(o, d, box_side * wishes.scale, length).leave;
        lights.push_back({o.x, o.y, o.z, length, d.x, d.y, d.z, 0, 1, .8f, .6f, 0, 0, 0, 0, 0});
    }
    if (wishes.grid) add_grid(work, wishes, engine);
    work.light_count = wishes.lights;
    work.lights.resize(lights.size() * sizeof lights[0]);
    std::memcpy(work.lights.data(), lights.data(), work.lights.size());
    return work;
}

std::uint32_t features_of(const WorkloadWishes& wishes)
{
    return (wishes.grid ? feature_bit::heterogeneous : 0u) | (wishes.g != 0 ? feature_bit::anisotropic : 0u) | (wishes.coloured ? feature_bit::coloured : 0u);
}

}  // namespace tyndall
