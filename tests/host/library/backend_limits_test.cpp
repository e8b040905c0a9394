/// The backend's promises beside its numbers: memory, determinism, refusals, what callbacks throw, the caller's OpenCL objects.
#define CL_TARGET_OPENCL_VERSION 300
#include <CL/cl.h>
#include <gmock/gmock.h>

#include <limits>

#include "settled.hpp"
#include "tyndall/backend.hpp"

using namespace tyndall;
using namespace tyndall::api;

namespace {

const RayLight light{.origin = {-.5, -.5, 0}, .length = .8f, .direction = {1, 0, 0}, .flux = {1, 2, 3}};
const EyeSegment eye{.origin = {-.5, .3f, .25}, .length = 1, .direction = {1, 0, 0}};

BackendDescription fog()
{
    return {.media = {{.sigma_t = {.5, 1, 2}}}, .selftest = false};
}

/// Eyes that differ, lights that differ.
std::vector<EyeSegment> eyes(int count)
{
    std::vector<EyeSegment> all(static_cast<std::size_t>(count), eye);
    for (int i = 0; i < count; ++i) all[static_cast<std::size_t>(i)].origin[2] = .25f + .5f * float(i) / float(count);
    return all;
}
std::vector<RayLight> lights(int count)
{
    std::vector<RayLight> all(static_cast<std::size_t>(count), light);
    for (int i = 0; i < count; ++i) all[static_cast<std::size_t>(i)].origin[1] = -.5f - .4f * float(i) / float(count);
    return all;
}

TEST(BackendLimits, LessMemoryGivesTheSameBytes)
{
    const auto nothing_between = [](std::span<const ShadowSegment>, std::span<std::uint8_t> blocked) { std::fill(blocked.begin(), blocked.end(), std::uint8_t(0)); };
    for (const bool shadows : {false, true})
        for (const std::uint32_t chosen : {0u, 8u}) {
            BackendDescription wide = fog();
            if (shadows) wide.occluded = nothing_between;
            BackendDescription narrow = wide;
            narrow.max_bytes = shadows ? 5 << 20 : 100 << 10;
            const Estimates a = Backend(wide).connect(lights(50), eyes(5000), {.lights_per_eye = chosen}), b = Backend(narrow).connect(lights(50), eyes(5000), {.lights_per_eye = chosen});
            EXPECT_EQ(a.radiance, b.radiance) << shadows << chosen;
            EXPECT_EQ(a.variance, b.variance);
        }
}

TEST(BackendLimits, TooLittleMemoryIsRefused)
{
    BackendDescription description = fog();
    description.max_bytes = 4096;
    try {
        Backend(description).connect(lights(50), eyes(100));
        FAIL();
    } catch (const ResourceError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("4096"));
    }
}

TEST(BackendLimits, SeedsDecide)
{
    Backend backend(fog());
    const Estimates a = backend.connect(lights(10), eyes(100), {.seed = 7}), b = backend.connect(lights(10), eyes(100), {.seed = 7}), c = backend.connect(lights(10), eyes(100), {.seed = 8});
    EXPECT_EQ(a.radiance, b.radiance);
    EXPECT_NE(a.radiance, c.radiance);
}

TEST(BackendLimits, NothingIsBlack)
{
    Backend backend(fog());
    EXPECT_TRUE(backend.connect(lights(3), std::span<const EyeSegment>()).radiance.empty());
    const Estimates dark = backend.connect(std::span<const RayLight>(), eyes(3));
    EXPECT_EQ(dark.radiance, std::vector<float>(9, 0.f));
    std::vector<RayLight> unlit = lights(3);
    for (RayLight& l : unlit) l.flux = {0, 0, 0};
    EXPECT_EQ(backend.connect(unlit, eyes(3)).radiance, std::vector<float>(9, 0.f));
}

TEST(BackendLimits, WhatACallbackThrowsComesBackAndTheBackendLives)
{
    bool angry = true;
    BackendDescription description = fog();
    description.occluded = [&](std::span<const ShadowSegment>, std::span<std::uint8_t>) {
        if (angry) throw std::domain_error("mine");
    };
    Backend backend(description);
    EXPECT_THROW(backend.connect(lights(10), eyes(100)), std::domain_error);
    angry = false;
    EXPECT_EQ(backend.connect(lights(10), eyes(100)).radiance, Backend(description).connect(lights(10), eyes(100)).radiance);
}

TEST(BackendLimits, AFlagStopsIt)
{
    StopFlag stop;
    BackendDescription description = fog();
    description.stop = &stop;
    Backend backend(description);
    stop.raise();
    EXPECT_THROW(backend.connect(lights(10), eyes(100)), Stopped);
}

TEST(BackendLimits, RunsOnTheCallersQueue)
{
    cl_platform_id platform = nullptr;
    cl_device_id device = nullptr;
    ASSERT_EQ(clGetPlatformIDs(1, &platform, nullptr), CL_SUCCESS);
    ASSERT_EQ(clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 1, &device, nullptr), CL_SUCCESS);
    const cl_context context = clCreateContext(nullptr, 1, &device, nullptr, nullptr, nullptr);
    const cl_command_queue queue = clCreateCommandQueueWithProperties(context, device, nullptr, nullptr);
    const auto references = [&] {
        cl_uint count = 0;
        clGetCommandQueueInfo(queue, CL_QUEUE_REFERENCE_COUNT, sizeof count, &count, nullptr);
        return count;
    };
    BackendDescription description = fog();
    description.opencl = OpenClHandles{.context = context, .device = device, .queue = queue};
    {
        Backend backend(description);
        EXPECT_GT(references(), 1u);
        EXPECT_EQ(backend.connect(lights(10), eyes(100)).radiance, Backend(fog()).connect(lights(10), eyes(100)).radiance);
    }
    EXPECT_EQ(test::settled(references, 1), 1u);
    clReleaseCommandQueue(queue), clReleaseContext(context);
}

struct Fault {
    std::string name;
    void (*make)(BackendDescription&, RayLight&, EyeSegment&);
    std::string message;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }
class BackendFaults : public testing::TestWithParam<Fault> {};

TEST_P(BackendFaults, AreRefusedByName)
{
    BackendDescription description = fog();
    std::vector<RayLight> some(3, light);
    std::vector<EyeSegment> few(2, eye);
    GetParam().make(description, some[2], few[1]);
    try {
        Backend backend(description);
        backend.connect(some, few);
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().message));
    }
}

using D = BackendDescription;
using L = RayLight;
using E = EyeSegment;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
void no_answer(std::span<const ShadowSegment>, std::span<std::uint8_t>) {}
const Fault faults[] = {
    {"NoMedium", [](D& d, L&, E&) { d.media.clear(); }, "there is no medium"},
    {"Medium", [](D& d, L&, E&) { d.media[0].albedo[1] = 2; }, "medium 0"},
    {"Box", [](D& d, L&, E&) { d.low[0] = 2; }, "the box"},
    {"FlatBox", [](D& d, L&, E&) { d.low = d.high; }, "no extent"},
    {"Lanes", [](D& d, L&, E&) { d.lanes = 3; }, "lanes = 3"},
    {"Device", [](D& d, L&, E&) { d.device = "no such device"; }, "no such device"},
    {"TwoAnswers", [](D& d, L&, E&) { d.occluded = no_answer, d.transmittance = [](auto, auto) {}; }, "exclude each other"},
    {"Container", [](D& d, L&, E&) { d.containers = {{.medium = 0, .planes = {{1, 0, 0, 1}}}}; }, "container 0: 1 planes"},
    {"Plane", [](D& d, L&, E&) { d.containers = {{.medium = 0, .planes = std::vector<std::array<double, 4>>(4, {0, 0, 0, 1})}}; }, "no length"},
    {"Transmittance", [](D& d, L&, E&) { d.transmittance = [](std::span<const ShadowSegment>, std::span<Float3> t) { for (Float3& x : t) x = {-1, 0, 0}; }; }, "negative or not finite"},
    {"LightPlace", [](D&, L& l, E&) { l.origin[0] = nan; }, "ray light 2: "},
    {"LightOutside", [](D&, L& l, E&) { l.origin[0] = 5; }, "ray light 2: (5, "},
    {"LightEnd", [](D&, L& l, E&) { l.length = 50; }, "ray light 2: its end"},
    {"LightDirection", [](D&, L& l, E&) { l.direction[0] = 2; }, "ray light 2: the direction"},
    {"LightFlux", [](D&, L& l, E&) { l.flux[1] = -1; }, "ray light 2: (1, -1, 3)"},
    {"LightMedium", [](D&, L& l, E&) { l.medium = 1; }, "ray light 2: medium 1 of 1"},
    {"EyeMedium", [](D&, L&, E& e) { e.medium = no_medium; }, "eye segment 1: medium"},
    {"EyeLength", [](D&, L&, E& e) { e.length = -1; }, "eye segment 1: the length"},
    {"EyeThroughput", [](D&, L&, E& e) { e.throughput[0] = nan; }, "eye segment 1: "},
};
INSTANTIATE_TEST_SUITE_P(Every, BackendFaults, testing::ValuesIn(faults), [](const auto& info) { return info.param.name; });

TEST(BackendLimits, RoundsAreAtLeastOne)
{
    Backend backend(fog());
    EXPECT_THROW(backend.connect(lights(1), eyes(1), {.rounds = 0}), UsageError);
}

}  // namespace
