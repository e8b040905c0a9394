/// A renderer with its own photons, camera, geometry and OpenCL queue that leaves only the connections to Tyndall: fog in the cube [-1, 1]^3 with a black ball in it, lit by a point.
/// It writes photons.pfm; `tyndall render photons.xml --layer media_to_media` is the same picture.      photons [FILE.pfm [SEED [PASSES]]]
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <tyndall/backend.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

using namespace tyndall::api;
using V = std::array<double, 3>;

static V operator+(V a, V b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
static V operator*(double s, V a) { return {s * a[0], s * a[1], s * a[2]}; }
static double dot(V a, V b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static V unit(V a) { return 1 / std::sqrt(dot(a, a)) * a; }
static V cross(V a, V b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
static Float3 f(V a) { return {float(a[0]), float(a[1]), float(a[2])}; }

static const double pi = std::acos(-1), sigma_t = 1.2, g = .4, radius = .45;
static const V albedo{.9, .8, .6}, ball{-.2, -.3, .1}, light{.5, .6, .3}, intensity{3, 4, 5}, camera{0, 0, 4};
static const int size = 32;

/// Distance to the ball along the ray, 1e30 if it is missed.
static double to_ball(V o, V d)
{
    const V from = o + -1. * ball;
    const double b = dot(from, d), root = b * b - dot(from, from) + radius * radius, t = root > 0 ? -b - std::sqrt(root) : -1;
    return t > 0 ? t : 1e30;
}

/// Where the ray is inside of the cube: from the first to the second.
static std::pair<double, double> in_cube(V o, V d)
{
    double enter = 0, leave = 1e30;
    for (int i = 0; i < 3; ++i) {
        enter = std::max(enter, (-std::copysign(1, d[i]) - o[i]) / d[i]);
        leave = std::min(leave, (std::copysign(1, d[i]) - o[i]) / d[i]);
    }
    return {enter, std::max(leave, enter)};
}

static std::mt19937_64 engine;
static double uniform() { return std::uniform_real_distribution<>()(engine); }

/// A direction at this cosine to `axis`, anywhere around it.
static V around(V axis, double cosine)
{
    const V u = unit(cross(std::abs(axis[0]) < .5 ? V{1, 0, 0} : V{0, 1, 0}, axis)), v = cross(axis, u);
    const double angle = 2 * pi * uniform(), sine = std::sqrt(std::max(1 - cosine * cosine, 0.));
    return unit(cosine * axis + sine * std::cos(angle) * u + sine * std::sin(angle) * v);
}

/// What the paths of `count` photons leave inside of the fog. Where one is scattered it loses what the fog absorbs; at the ball and outside of the cube it ends.
static std::vector<RayLight> trace_photons(int count)
{
    std::vector<RayLight> lights;
    for (int photon = 0; photon < count; ++photon) {
        V at = light, direction = around({0, 0, 1}, 2 * uniform() - 1), power = 4 * pi / count * intensity;
        while (true) {
            const double length = std::min(in_cube(at, direction).second, to_ball(at, direction)), flight = -std::log(1 - uniform()) / sigma_t;
            lights.push_back({.origin = f(at), .length = float(length), .direction = f(direction), .medium = 0, .flux = f(power)});
            if (flight >= length || uniform() > albedo[0]) break;
            for (int c = 0; c < 3; ++c) power[c] *= albedo[c] / albedo[0];
            const double s = (1 - g * g) / (1 - g + 2 * g * uniform());
            at = at + flight * direction, direction = around(direction, (1 + g * g - s * s) / (2 * g));
        }
    }
    return lights;
}

/// A ray through a random place of every pixel, where it is in the fog. Field of view: 30 degrees.
static std::vector<EyeSegment> trace_camera()
{
    std::vector<EyeSegment> eyes;
    const double half = std::tan(pi / 12);
    for (int i = 0; i < size * size; ++i) {
        const V d = unit({(2 * (i % size + uniform()) / size - 1) * half, (1 - 2 * (i / size + uniform()) / size) * half, -1});
        const auto [enter, leave] = in_cube(camera, d);
        eyes.push_back({.origin = f(camera + enter * d), .length = float(std::min(leave, to_ball(camera, d)) - enter), .direction = f(d), .medium = 0});
    }
    return eyes;
}

/// What a renderer has that computes on a device itself; the connections go through the same queue.
struct OwnQueue {
    cl_device_id device = nullptr;
    cl_context context = nullptr;
    cl_command_queue queue = nullptr;

    OwnQueue()
    {
        cl_platform_id platforms[16];
        cl_uint count = 0;
        clGetPlatformIDs(16, platforms, &count);
        for (cl_uint i = 0; i < std::min(count, 16u) && !device; ++i)
            if (clGetDeviceIDs(platforms[i], CL_DEVICE_TYPE_ALL, 1, &device, nullptr) != CL_SUCCESS) device = nullptr;
        if (device) context = clCreateContext(nullptr, 1, &device, nullptr, nullptr, nullptr);
        if (context) queue = clCreateCommandQueue(context, device, 0, nullptr);
        if (!queue) throw tyndall::NoDeviceError("no OpenCL device has a queue for us");
    }
    ~OwnQueue() { clReleaseCommandQueue(queue), clReleaseContext(context); }
};

static void behind_ball(std::span<const ShadowSegment> segments, std::span<std::uint8_t> blocked)
{
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const V d = segments[i].to + -1. * segments[i].from;
        blocked[i] = to_ball(segments[i].from, unit(d)) < std::sqrt(dot(d, d));
    }
}

int main(int argc, char** argv)
try {
    const int passes = argc > 3 ? std::atoi(argv[3]) : 16;
    engine.seed(argc > 2 ? std::atoi(argv[2]) : 1);
    const OwnQueue own;
    Backend backend({.media = {{.sigma_t = {sigma_t, sigma_t, sigma_t}, .albedo = albedo, .phase = {.type = Phase::Type::henyey_greenstein, .g = g}}},
                     .occluded = behind_ball,
                     .opencl = tyndall::OpenClHandles{.context = own.context, .device = own.device, .queue = own.queue}});
    std::vector<float> picture(3 * size * size);
    for (int pass = 0; pass < passes; ++pass) {
        const Estimates seen = backend.connect(trace_photons(300), trace_camera(), {.seed = engine(), .rounds = 1});
        for (std::size_t i = 0; i < picture.size(); ++i) picture[i] += seen.radiance[i] / float(passes);
    }
    std::ofstream file(argc > 1 ? argv[1] : "photons.pfm", std::ios::binary);
    file << "PF\n" << size << " " << size << "\n-1.0\n";
    for (int row = size - 1; row >= 0; --row) file.write(reinterpret_cast<const char*>(&picture[std::size_t(3 * size * row)]), 3 * size * sizeof(float));
    return file.flush() ? 0 : 1;
} catch (const tyndall::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
