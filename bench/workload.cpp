#include "bench/workload.hpp"

#include <glm/glm.hpp>

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

namespace tyndall::bench {
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
    constexpr std::uint32_t row = 64;
    if (wishes.camera)
        return glm::normalize(
            glm::vec3((float(i % row) + .5f - row / 2) / row, (float(i / row) + .5f - float(wishes.eyes / row) / 2) / row, .866f));
    const glm::vec3 d = random_direction(engine);
    return glm::normalize(glm::vec3(d.x, d.y, std::abs(d.z) + 1));
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
    std::vector<maths_float::VirtualRayLight> lights;
    for (std::uint32_t i = 0; i < wishes.lights; ++i) {
        const glm::vec3 o = wishes.scale * random_point(engine);
        const float length = wishes.scale * (1 + .5f * uniform(engine));
        const glm::vec3 d = random_direction(engine);
        lights.push_back({o.x, o.y, o.z, length, d.x, d.y, d.z, 0, 1, .8f, .6f, 0, 0, 0, 0, 0});
    }
    work.light_count = wishes.lights;
    work.lights.resize(lights.size() * sizeof lights[0]);
    std::memcpy(work.lights.data(), lights.data(), work.lights.size());
    return work;
}

std::uint32_t features_of(const WorkloadWishes& wishes)
{
    return (wishes.g != 0 ? feature_bit::anisotropic : 0u) | (wishes.coloured ? feature_bit::coloured : 0u);
}

}  // namespace tyndall::bench
