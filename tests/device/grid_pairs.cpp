#include "tests/device/grid_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

namespace tyndall::testing {
namespace {

using glm::dvec3;

/// The layout of a virtual ray light, written down again.
struct PlainLight {
    float origin[3], length, direction[3];
    std::uint32_t medium;
    float flux[3];
    std::uint32_t depth;
    float channel[3];
    std::uint32_t is_short;
};
static_assert(sizeof(PlainLight) == 64);

struct Ray {
    dvec3 origin, direction;
    double length = 0;
    unsigned medium = 0;
};

dvec3 random_point(std::mt19937& engine)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double x = uniform(engine), y = uniform(engine);
    return {x, y, uniform(engine)};
}

/// A piece of a line inside one medium, in numbers that are floats.
Ray random_ray(std::mt19937& engine, const GridWishes& wishes)
{
    std::uniform_real_distribution<double> length(.3, .9);
    for (;;) {
        Ray r{dvec3(glm::vec3(.9 * random_point(engine))), glm::normalize(random_point(engine)), double(float(length(engine)))};
        const dvec3 end = r.origin + r.length * r.direction;
        const bool fits = glm::all(glm::lessThan(glm::abs(end), dvec3(.95)));
        if (!fits || (wishes.homogeneous_beside && (r.origin.x < 0) != (end.x < 0))) continue;
        r.medium = wishes.homogeneous_beside && r.origin.x < 0 ? 1 : 0;
        return r;
    }
}

double nearest(const Ray& a, const Ray& b)
{
    double least = 1e9;
    for (int i = 0; i <= 24; ++i)
        for (int j = 0; j <= 24; ++j) least = std::min(least, glm::distance(a.origin + a.length * i / 24. * a.direction, b.origin + b.length * j / 24. * b.direction));
    return least;
}

GridRecord add_grid(MediaTables& tables, std::mt19937& engine, unsigned channels, double low, double high, bool holes, bool half)
{
    std::uniform_real_distribution<float> uniform{float(low), float(high)};
    constexpr uint x = 7, y = 6, z = 5;
    // The box is [-1, 1]^3, or its half x > 0.
    const GridRecord grid{half ? 7.f : 3.5f, 0, 0, half ? 0.f : 3.5f, 0, 3, 0, 3, 0, 0, 2.5f, 2.5f, x, y, z, static_cast<uint>(tables.voxels.size())};
    for (uint i = 0; i < channels * x * y * z; ++i) {
        const float value = uniform(engine);
        tables.voxels.push_back(holes && i % (x * y * z) % 2 == 0 ? 0 : value);
    }
    tables.grids.push_back(grid);
    return grid;
}

void add_half(MediaTables& tables, unsigned medium, float from, float to)
{
    tables.containers.push_back({medium, static_cast<uint>(tables.planes.size()), 6, 0});
    tables.planes.insert(tables.planes.end(), {{-1, 0, 0, -from}, {1, 0, 0, to}, {0, -1, 0, 1}, {0, 1, 0, 1}, {0, 0, -1, 1}, {0, 0, 1, 1}});
}

MediaTables grid_tables(const GridWishes& wishes, std::mt19937& engine)
{
    MediaTables tables;
    const float e = static_cast<float>(wishes.extinction), tint = wishes.coloured ? .3f : 0, g = static_cast<float>(wishes.g);
    const unsigned channels = wishes.coloured ? 3 : 1;
    add_grid(tables, engine, channels, .2, 1.8, wishes.holes, wishes.homogeneous_beside);
    if (wishes.albedo) add_grid(tables, engine, channels, .3, .9, false, wishes.homogeneous_beside);
    const float albedo = wishes.albedo ? 1.f : .8f;
    tables.media.push_back({e, e * (1 + tint), e * (1 + 2 * tint), g, albedo * e, albedo * e * (1 + tint), albedo * e * (1 + 2 * tint), 0, 0, 0, wishes.albedo ? 1u : NO_GRID,
                            wishes.coloured ? DENSITY_GRID_COLOURED | (wishes.albedo ? ALBEDO_GRID_COLOURED : 0) : 0});
    if (!wishes.homogeneous_beside) return tables;
    tables.media.push_back({.9f, 1.1f, 1.3f, .5f * g, .7f, .6f, .5f, 0, 0, NO_GRID, NO_GRID, 0});
    add_half(tables, 0, 0, 1), add_half(tables, 1, -1, 0);
    return tables;
}

/// Trilinear between voxel centres, those of the outermost up to the faces: a weighted sum over the eight voxels around.
double value_of(const GridRecord& g, const std::vector<float>& voxels, unsigned channel, const dvec3& p)
{
    const std::array<double, 3> at{g.x_x * p.x + g.x_0, g.y_y * p.y + g.y_0, g.z_z * p.z + g.z_0};
    const std::array<int, 3> size{int(g.size_x), int(g.size_y), int(g.size_z)};
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double weight = 1;
        std::array<int, 3> index{};
        for (std::size_t k = 0; k < 3; ++k) {
            const double shifted = at[k] - .5, below = std::floor(shifted), share = shifted - below;
            const int step = corner >> k & 1;
            weight *= step ? share : 1 - share;
            index[k] = std::clamp(int(below) + step, 0, size[k] - 1);
        }
        sum += weight * voxels[g.first + std::size_t(((int(channel) * size[2] + index[2]) * size[1] + index[1]) * size[0] + index[0])];
    }
    return sum;
}

struct World {
    const MediaTables& tables;

    unsigned medium_at(const dvec3& p) const { return tables.media.size() > 1 && p.x < 0 ? 1 : 0; }
    dvec3 grid_at(uint grid, bool coloured, const dvec3& p) const
    {
        dvec3 v(value_of(tables.grids[grid], tables.voxels, 0, p));
        for (unsigned c = 1; coloured && c < 3; ++c) v[int(c)] = value_of(tables.grids[grid], tables.voxels, c, p);
        return v;
    }
    dvec3 extinction(const dvec3& p) const
    {
        const MediumRecord& m = tables.media[medium_at(p)];
        const dvec3 sigma(m.sigma_t_r, m.sigma_t_g, m.sigma_t_b);
        return m.density_grid == NO_GRID ? sigma : sigma * grid_at(m.density_grid, m.grid_colours & DENSITY_GRID_COLOURED, p);
    }
    dvec3 scattering(const dvec3& p) const
    {
        const MediumRecord& m = tables.media[medium_at(p)];
        dvec3 sigma(m.sigma_s_r, m.sigma_s_g, m.sigma_s_b);
        if (m.density_grid != NO_GRID) sigma *= grid_at(m.density_grid, m.grid_colours & DENSITY_GRID_COLOURED, p);
        return m.albedo_grid == NO_GRID ? sigma : sigma * grid_at(m.albedo_grid, m.grid_colours & ALBEDO_GRID_COLOURED, p);
    }
    /// Optical depth of a segment by the midpoint rule.
    dvec3 depth(const dvec3& from, const dvec3& to) const
    {
        const double length = glm::distance(from, to);
        const int steps = 4 + int(60 * length);
        dvec3 sum(0);
        for (int i = 0; i < steps; ++i) sum += extinction(glm::mix(from, to, (i + .5) / steps));
        return sum * (length / steps);
    }
};

double phase(double mu, double g) { return (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * mu, 1.5)); }

/// Points of a ray with weights of 2-point Gauss in equal panels, and what has been passed up to there.
struct Node {
    dvec3 position, depth;
    double weight = 0;
};
std::vector<Node> nodes_of(const World& world, const Ray& ray)
{
    constexpr int panels = 24;
    std::vector<Node> nodes;
    dvec3 depth(0), last = ray.origin;
    for (int i = 0; i < panels; ++i)
        for (const double off : {-.28867513459481287, .28867513459481287}) {
            const dvec3 p = ray.origin + ray.length * (i + .5 + off) / panels * ray.direction;
            depth += world.depth(last, p), last = p;
            nodes.push_back({p, depth, .5 * ray.length / panels});
        }
    return nodes;
}

dvec3 along_light(const PlainLight& light, const dvec3& depth)
{
    const dvec3 t = glm::exp(-depth);
    return light.is_short ? t / glm::dot(dvec3(light.channel[0], light.channel[1], light.channel[2]), t) : t;
}

Ray ray_of(const PlainLight& l) { return {{l.origin[0], l.origin[1], l.origin[2]}, {l.direction[0], l.direction[1], l.direction[2]}, l.length, l.medium}; }

dvec3 to_segment(const World& world, const EyeSegment& eye, const PlainLight& light)
{
    const Ray a{{eye.origin_x, eye.origin_y, eye.origin_z}, {eye.direction_x, eye.direction_y, eye.direction_z}, eye.length, eye.medium}, b = ray_of(light);
    const double g_eye = world.tables.media[eye.medium].g, g_light = world.tables.media[light.medium].g;
    const auto on_eye = nodes_of(world, a), on_light = nodes_of(world, b);
    dvec3 sum(0);
    for (const Node& x : on_eye)
        for (const Node& y : on_light) {
            const dvec3 d = x.position - y.position;  // from the light to the eye
            const double w = glm::length(d), phases = phase(glm::dot(b.direction, d / w), g_light) * phase(glm::dot(d / w, -a.direction), g_eye);
            sum += x.weight * y.weight * phases / (w * w) * world.scattering(x.position) * world.scattering(y.position) * along_light(light, y.depth) *
                   glm::exp(-x.depth - world.depth(x.position, y.position));
        }
    return sum * dvec3(light.flux[0], light.flux[1], light.flux[2]) * dvec3(eye.throughput_r, eye.throughput_g, eye.throughput_b);
}

dvec3 to_point(const World& world, const EyePoint& eye, const PlainLight& light)
{
    const Ray b = ray_of(light);
    const dvec3 x(eye.position_x, eye.position_y, eye.position_z), n(eye.normal_x, eye.normal_y, eye.normal_z);
    dvec3 sum(0);
    for (const Node& y : nodes_of(world, b)) {
        const dvec3 d = x - y.position;
        const double w = glm::length(d), cosine = std::max(glm::dot(n, -d / w), 0.);
        sum += y.weight * cosine * phase(glm::dot(b.direction, d / w), world.tables.media[light.medium].g) / (w * w) * world.scattering(y.position) * along_light(light, y.depth) *
               glm::exp(-world.depth(x, y.position));
    }
    return sum * dvec3(light.flux[0], light.flux[1], light.flux[2]) * dvec3(eye.throughput_r, eye.throughput_g, eye.throughput_b);
}

std::vector<PlainLight> lights_of(const RandomPairs& pairs)
{
    std::vector<PlainLight> lights(pairs.light_count);
    std::memcpy(lights.data(), pairs.lights.data(), lights.size() * sizeof lights[0]);
    return lights;
}

}  // namespace

RandomPairs grid_pairs(const GridWishes& wishes)
{
    RandomPairs pairs;
    std::mt19937 engine(wishes.seed);
    pairs.tables = grid_tables(wishes, engine);
    std::vector<Ray> eyes;
    for (std::uint32_t i = 0; i < 16; ++i) {
        const Ray r = random_ray(engine, wishes);
        const auto o = glm::vec3(r.origin), d = glm::vec3(r.direction);
        eyes.push_back(r);
        pairs.segments.push_back({o.x, o.y, o.z, float(r.length), d.x, d.y, d.z, r.medium, 1, .9f, .8f, 0, i, static_cast<uint>(engine()), 0, 0});
        pairs.points.push_back({o.x, o.y, o.z, r.medium, d.x, d.y, d.z, 0, 1, .9f, .8f, i, d.x, d.y, d.z, static_cast<uint>(engine())});
    }
    std::vector<PlainLight> lights;
    while (lights.size() < 6) {
        const Ray r = random_ray(engine, wishes);
        double least = 1e9;
        for (const Ray& eye : eyes) least = std::min(least, nearest(eye, r));
        if (least < .12) continue;
        const auto o = glm::vec3(r.origin), d = glm::vec3(r.direction);
        lights.push_back({{o.x, o.y, o.z}, float(r.length), {d.x, d.y, d.z}, r.medium, {1, .8f, 1.2f}, 0, {.5f, .3f, .2f}, wishes.short_lights ? 1u : 0u});
    }
    pairs.light_count = static_cast<std::uint32_t>(lights.size());
    pairs.lights.resize(lights.size() * sizeof lights[0]);
    std::memcpy(pairs.lights.data(), lights.data(), pairs.lights.size());
    return pairs;
}

std::vector<double> grid_oracle(const RandomPairs& pairs, EyeKind kind)
{
    const World world{pairs.tables};
    std::vector<double> sums;
    for (std::size_t i = 0; i < pairs.segments.size(); ++i) {
        dvec3 sum(0);
        for (const PlainLight& light : lights_of(pairs)) sum += kind == EyeKind::segments ? to_segment(world, pairs.segments[i], light) : to_point(world, pairs.points[i], light);
        sums.insert(sums.end(), {sum.x, sum.y, sum.z});
    }
    return sums;
}

}  // namespace tyndall::testing
