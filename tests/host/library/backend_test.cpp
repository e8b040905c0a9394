/// The connections alone, against plain quadrature in the caller's space: every kind of light and eye, shadows, containers, the caller's own transmittance.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <set>

#include "tyndall/backend.hpp"

using namespace tyndall;
using namespace tyndall::api;

namespace {

// The oracle: midpoint rule along the pieces, which lie well apart. Its own vectors and phase function.
using V = std::array<double, 3>;
V operator+(const V& a, const V& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
V operator-(const V& a, const V& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
V operator*(double s, const V& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
V normalized(const V& a) { return 1 / std::sqrt(dot(a, a)) * a; }
V of(const Float3& a) { return {a[0], a[1], a[2]}; }
Float3 f(const V& a) { return {float(a[0]), float(a[1]), float(a[2])}; }
double henyey_greenstein(double g, double mu) { return (1 - g * g) / (4 * M_PI * std::pow(1 + g * g - 2 * g * mu, 1.5)); }

constexpr double scale = 37;  ///< of the caller's units, which are neither those of render space nor a power of two of them
const V corner{1000, -2000, 500};
const V sigma_t{.5 / scale, 1 / scale, 2 / scale}, albedo{.9, .7, .5};
constexpr double g = .35;
V at(double x, double y, double z) { return corner + scale * V{x, y, z}; }

/// What passes between two places, per channel.
using Passed = std::function<V(const V& from, const V& to)>;
V through_everything(const V& from, const V& to)
{
    const double length = std::sqrt(dot(to - from, to - from));
    return {std::exp(-sigma_t[0] * length), std::exp(-sigma_t[1] * length), std::exp(-sigma_t[2] * length)};
}

constexpr int steps = 300;
const RayLight ray{.origin = f(at(-.6, -.5, .1)), .length = float(scale * .9), .direction = f(normalized({.9, .3, -.2})), .flux = {2000, 3000, 5000}};
const PointLight point{.position = f(at(.5, -.4, -.1)), .direction = f(normalized({1, 2, -1})), .power = {2000, 3000, 5000}};
const EyeSegment segment{.origin = f(at(-.7, .6, .4)), .length = float(scale * 1.2), .direction = f(normalized({1, -.2, -.3})), .throughput = {.5, .75, 1}};
const EyePoint surface{.position = f(at(.1, .8, 0)), .medium = 0, .normal = f(normalized({.2, -1, .1})), .facing = f({0, -1, 0}), .throughput = {.25, .5, .125}};

/// Radiance per channel that arrives along the eye from places on a light: visits (place, direction of the light there, weight per channel).
using Places = std::function<void(const std::function<void(const V&, const V&, const V&)>&)>;
const Places along_ray = [](const auto& visit) {
    const double length = ray.length, step = length / steps;
    for (int i = 0; i < steps; ++i) {
        const double v = (i + .5) * step;
        V power;
        for (std::size_t c = 0; c < 3; ++c) power[c] = ray.flux[c] * albedo[c] * sigma_t[c] * std::exp(-sigma_t[c] * v) * step;
        visit(of(ray.origin) + v * of(ray.direction), of(ray.direction), power);
    }
};
const Places at_point = [](const auto& visit) { visit(of(point.position), of(point.direction), of(point.power)); };

V to_segment(const Places& lights, const Passed& passed)
{
    V sum{};
    const double step = double(segment.length) / steps;
    for (int i = 0; i < steps; ++i) {
        const double u = (i + .5) * step;
        const V x = of(segment.origin) + u * of(segment.direction);
        lights([&](const V& y, const V& direction, const V& power) {
            const V d = x - y, w = normalized(d), t = passed(x, y);
            const double both = henyey_greenstein(g, dot(direction, w)) * henyey_greenstein(g, dot(w, -1. * of(segment.direction))) / dot(d, d);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += segment.throughput[c] * power[c] * t[c] * both * albedo[c] * sigma_t[c] * std::exp(-sigma_t[c] * u) * step;
        });
    }
    return sum;
}

V to_point(const Places& lights, const Passed& passed)
{
    V sum{};
    const V x = of(surface.position);
    lights([&](const V& y, const V& direction, const V& power) {
        const V d = x - y, w = normalized(d), t = passed(x, y);
        const double cosine = -dot(w, of(surface.normal));
        if (cosine <= 0 || -dot(w, of(surface.facing)) <= 0) return;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += surface.throughput[c] * power[c] * t[c] * henyey_greenstein(g, dot(direction, w)) * cosine / dot(d, d);
    });
    return sum;
}

BackendDescription fog()
{
    return {.media = {{.name = "fog", .sigma_t = sigma_t, .albedo = albedo, .phase = {.type = Phase::Type::henyey_greenstein, .g = g}}}, .low = at(-1, -1, -1), .high = at(1, 1, 1), .selftest = false};
}

/// The mean over an eye that is repeated is the quadrature, within four of its own standard errors and what the midpoint rule and floats leave.
void expect_near(const Estimates& got, const V& wanted, const char* what)
{
    const std::size_t eyes = got.radiance.size() / 3;
    for (std::size_t c = 0; c < 3; ++c) {
        double mean = 0, variance = 0;
        for (std::size_t i = 0; i < eyes; ++i) mean += got.radiance[3 * i + c] / double(eyes), variance += got.variance[3 * i + c] / double(eyes) / double(eyes);
        EXPECT_NEAR(mean, wanted[c], 4 * std::sqrt(variance) + 1e-4 * wanted[c]) << what << ", channel " << c;
        EXPECT_LT(std::sqrt(variance), .01 * wanted[c]) << what << ": too noisy to tell";
        EXPECT_GT(wanted[c], 0);
    }
    EXPECT_EQ(got.not_finite, 0u);
}

constexpr std::size_t repeated = 96;
const std::vector<EyeSegment> segments(repeated, segment);
const std::vector<EyePoint> points(repeated, surface);
const std::vector<RayLight> rays{ray};
const std::vector<PointLight> point_lights{point};
const ConnectOptions many{.rounds = 256};

void expect_all_near(Backend& backend, const Passed& passed)
{
    expect_near(backend.connect(rays, segments, many), to_segment(along_ray, passed), "ray to segment");
    expect_near(backend.connect(rays, points, many), to_point(along_ray, passed), "ray to point");
    expect_near(backend.connect(point_lights, segments, many), to_segment(at_point, passed), "point to segment");
    expect_near(backend.connect(point_lights, points, many), to_point(at_point, passed), "point to point");
}

TEST(Backend, MatchesQuadratureInTheCallersUnits)
{
    Backend backend(fog());
    expect_all_near(backend, through_everything);
}

TEST(Backend, LeavesShadowsToTheCaller)
{
    // A wall at x = 0 with a hole where z > .05.
    const auto stands_between = [](const V& from, const V& to) {
        const double a = (from[0] - corner[0]) / scale, b = (to[0] - corner[0]) / scale, t = a / (a - b);
        return a * b < 0 && (from[2] - corner[2] + t * (to[2] - from[2])) / scale < .05;
    };
    std::set<std::size_t> sizes;
    std::size_t asked = 0;
    BackendDescription description = fog();
    description.occluded = [&](std::span<const ShadowSegment> all, std::span<std::uint8_t> blocked) {
        sizes.insert(all.size()), asked += all.size();
        ASSERT_EQ(all.size(), blocked.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            ASSERT_EQ(all[i].medium, 0u);
            blocked[i] = stands_between(all[i].from, all[i].to);
        }
    };
    Backend backend(description);
    expect_all_near(backend, [&](const V& from, const V& to) { return stands_between(from, to) ? V{} : through_everything(from, to); });
    const std::size_t before = asked;
    const Estimates last = backend.connect(rays, segments, many);
    EXPECT_EQ(last.shadow_segments, asked - before);
    EXPECT_EQ(asked - before, repeated * std::size_t(many.rounds));
    EXPECT_GT(*sizes.rbegin(), 50u) << "segments come many at a time";
}

TEST(Backend, AsksAboutPlacesOnTheEyeAndOnTheLight)
{
    BackendDescription description = fog();
    double farthest = 0;
    description.occluded = [&](std::span<const ShadowSegment> all, std::span<std::uint8_t> blocked) {
        const auto off = [](const V& p, const V& origin, const V& direction) {
            const V d = p - origin, beside = d - dot(d, direction) * direction;
            return std::sqrt(dot(beside, beside));
        };
        for (const ShadowSegment& s : all)
            farthest = std::max({farthest, off(s.from, of(segment.origin), of(segment.direction)), off(s.to, of(ray.origin), of(ray.direction))});
        std::fill(blocked.begin(), blocked.end(), std::uint8_t(1));
    };
    Backend backend(description);
    const Estimates nothing = backend.connect(rays, segments, {});
    EXPECT_THAT(nothing.radiance, testing::Each(0.0f));
    EXPECT_GT(nothing.shadow_segments, 0u);
    EXPECT_LT(farthest, 1e-5 * scale);  // floats of render space, and the ends pulled in
}

TEST(Backend, TheCallersTransmittanceIsTheOwnOne)
{
    BackendDescription description = fog();
    description.transmittance = [](std::span<const ShadowSegment> all, std::span<Float3> passed) {
        for (std::size_t i = 0; i < all.size(); ++i) passed[i] = f(through_everything(all[i].from, all[i].to));
    };
    BackendDescription shadowed = fog();  // the same sampler as where somebody is asked
    shadowed.occluded = [](std::span<const ShadowSegment>, std::span<std::uint8_t> blocked) { std::fill(blocked.begin(), blocked.end(), std::uint8_t(0)); };
    Backend own(shadowed), callers(description);
    const Estimates a = own.connect(rays, segments), b = callers.connect(rays, segments);
    for (std::size_t i = 0; i < a.radiance.size(); ++i) EXPECT_NEAR(a.radiance[i], b.radiance[i], 2e-5 * a.radiance[i]);
    expect_all_near(callers, through_everything);
}

TEST(Backend, ContainersEndMedia)
{
    BackendDescription description = fog();
    description.high = at(1, 4, 1);
    const double top = at(0, .7, 0)[1];
    description.containers = {{.medium = 0, .planes = {{1, 0, 0, at(1, 0, 0)[0]}, {-2, 0, 0, -2 * at(-1, 0, 0)[0]}, {0, 1, 0, top}, {0, -1, 0, -at(0, -1, 0)[1]},
                                                       {0, 0, 1, at(0, 0, 1)[2]}, {0, 0, -1, -at(0, 0, -1)[2]}}}};
    Backend backend(description);
    std::vector<EyePoint> outside = points;
    for (EyePoint& p : outside) p.medium = no_medium;
    const auto below_top = [&](const V& from, const V& to) {  // from y above the top to y below it
        const double share = (top - to[1]) / (from[1] - to[1]), length = share * std::sqrt(dot(to - from, to - from));
        return V{std::exp(-sigma_t[0] * length), std::exp(-sigma_t[1] * length), std::exp(-sigma_t[2] * length)};
    };
    expect_near(backend.connect(rays, outside, many), to_point(along_ray, below_top), "from outside");
}

TEST(Backend, SomeLightsStandForAll)
{
    std::vector<RayLight> several;
    for (int i = 0; i < 200; ++i) {
        RayLight light = ray;
        light.origin = f(at(-.6 + .001 * i, -.5 - .002 * i, .3 * std::sin(i)));
        for (float& power : light.flux) power *= 1 + float(i % 7);
        several.push_back(light);
    }
    Backend backend(fog());
    const Estimates all = backend.connect(several, segments, {.rounds = 8}), some = backend.connect(several, segments, {.rounds = 256, .lights_per_eye = 16});
    double mean = 0, wanted = 0, variance = 0;
    for (std::size_t eye = 0; eye < repeated; ++eye) mean += some.radiance[3 * eye], wanted += all.radiance[3 * eye], variance += some.variance[3 * eye];
    // Sixteen eyes share their lights, so their errors may be the same ones: variances of a group add up as standard errors do.
    EXPECT_NEAR(mean, wanted, 4 * std::sqrt(16 * variance) + 1e-3 * wanted);
    EXPECT_LT(std::sqrt(16 * variance), .02 * wanted);
}

TEST(Backend, VarianceIsThatOfTheMean)
{
    Backend backend(fog());
    constexpr int repeats = 60;
    double sum = 0, squares = 0, claimed = 0;
    for (std::uint64_t seed = 1; seed <= repeats; ++seed) {
        const Estimates e = backend.connect(rays, segments, {.seed = seed, .rounds = 4});
        for (std::size_t i = 0; i < repeated; ++i) {
            const double x = e.radiance[3 * i + 1];
            sum += x, squares += x * x, claimed += e.variance[3 * i + 1];
        }
    }
    const double n = repeats * double(repeated), measured = (squares - sum * sum / n) / (n - 1);
    EXPECT_NEAR(claimed / n, measured, .15 * measured);  // 5760 values: the ratio's own standard error is 3 %
    EXPECT_THAT(backend.connect(rays, segments, {.rounds = 1}).variance, testing::Each(0.0f));
}

}  // namespace
