/// Devices that fail at any call, have little memory, small groups, no clock: the same image, or an error that says what happened.
#include <gmock/gmock.h>

#include "../../support/faulty_opencl.hpp"
#include "../pipeline/whole_renderer.hpp"
#include "tyndall/error.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

const std::string view = sensor({.origin = {.3, .6, 3}, .pixels = 40});
const std::string clear_fog = medium("fog", Rgb(.5, 1, 2), Rgb(.9, .7, .5), .5) + container(Vec3(-.5), Vec3(.5), "fog") + point_light({.5, 1, .5}, Rgb(2)) + view;
const std::string shadowed_fog = clear_fog + horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75))) + sphere({.1, .1, .1}, .2, diffuse(Rgb(.5)));

struct FaultyScene {
    std::string name, body;
    Selection selection;
    std::size_t little;  ///< bytes of a buffer in which its lights, and with shadow segments the smallest tile, find room
};
void PrintTo(const FaultyScene& scene, std::ostream* out) { *out << scene.name; }

class Faults : public testing::TestWithParam<FaultyScene> {
protected:
    Faults() { opencl_faults().reset(); }
    ~Faults() override { opencl_faults().reset(); }

    const Scene scene = scene_of(GetParam().body);
    const RenderSettings settings{.passes = 2, .lights = 300, .selection = GetParam().selection, .selected_lights = 64, .selftest = false};
    RenderOutcome rendered() const { return render(scene, settings); }
    std::vector<Rgb> image() const { return rendered().film.beauty(); }
};

/// How a render under faults ended.
struct Ended {
    bool same = false, failed = false;
    std::string message;
};

template <class Render>
Ended ended(Render&& render, const std::vector<Rgb>& expected)
{
    try {
        return {.same = render() == expected};
    } catch (const DeviceError& error) {
        return {.failed = true, .message = error.what()};
    }
}

// One call in the middle fails once: a shortage is made up for by doing less at a time; nothing else is tried again. Whatever happens, no wrong image.
TEST_P(Faults, AnyCallMayFailOnce)
{
    const std::vector<Rgb> expected = image();
    const long calls = opencl_faults().calls;
    ASSERT_GT(calls, 50);
    int mended = 0, failed = 0;
    for (long n = 0; n < calls; n += std::max(calls / 16, 1l)) {
        opencl_faults().reset();
        opencl_faults().fail_at = n;
        const Ended e = ended([&] { return image(); }, expected);
        const std::string where = std::to_string(n) + ": " + opencl_faults().failed;
        EXPECT_TRUE(e.same || e.failed) << where;
        if (!e.failed) {
            ++mended;
            continue;
        }
        ++failed;
        EXPECT_THAT(e.message, testing::HasSubstr("CL_OUT_OF_RESOURCES (-5)")) << where;
        EXPECT_THAT(e.message, testing::HasSubstr(opencl_faults().failed == "clBuildProgram" ? "options" : "try")) << where;
    }
    EXPECT_GT(mended, failed) << "most calls belong to passes";
}

TEST_P(Faults, ADeviceThatIsGoneIsAnError)
{
    image();
    const long calls = opencl_faults().calls;
    for (const int error : {-36, -2, -5}) {  // invalid queue, not available, out of resources for ever
        opencl_faults().reset();
        opencl_faults().fail_at = calls / 2, opencl_faults().failures = 1 << 30, opencl_faults().error = error;
        EXPECT_THROW(rendered(), DeviceError) << error;
    }
}

TEST_P(Faults, LittleMemoryGivesTheSameImageInSmallerPieces)
{
    const std::vector<Rgb> expected = image();
    const std::size_t largest = opencl_faults().largest_asked;
    ASSERT_GT(largest, GetParam().little);
    for (const std::size_t limit : {largest - 1, GetParam().little}) {
        opencl_faults().reset();
        opencl_faults().largest_buffer = limit;
        const RenderOutcome r = rendered();
        EXPECT_EQ(r.film.beauty(), expected) << limit;
        EXPECT_LE(opencl_faults().largest_asked, largest);
        ASSERT_FALSE(r.report.warnings.empty()) << limit;
        EXPECT_THAT(r.report.warnings.back(), testing::HasSubstr("the image is not affected"));
    }
}

TEST_P(Faults, TooLittleMemoryForAnythingIsAnError)
{
    opencl_faults().memory = 2000;
    EXPECT_THROW(rendered(), DeviceError);
}

TEST_P(Faults, SmallWorkGroupsGiveTheSameImage)
{
    const std::vector<Rgb> expected = image();
    opencl_faults().largest_group = 4;
    EXPECT_EQ(image(), expected);
}

TEST_P(Faults, ADeviceWithoutAClockGivesTheSameImageTimedByTheWall)
{
    const std::vector<Rgb> expected = image();
    opencl_faults().no_profiling = true;
    const RenderOutcome r = rendered();
    EXPECT_EQ(r.film.beauty(), expected);
    EXPECT_TRUE(r.report.wall_clock);
}

// ---- several devices ----

TEST_P(Faults, SeveralDevicesGiveTheBytesOfOne)
{
    const std::vector<Rgb> expected = image();
    for (const char* devices : {"0,0", "0,0,0"}) {
        RenderSettings several = settings;
        several.device = devices;
        const RenderOutcome r = render(scene, several);
        EXPECT_EQ(r.film.beauty(), expected) << devices;
        EXPECT_EQ(r.report.pairs, rendered().report.pairs);
        EXPECT_TRUE(r.report.warnings.empty()) << r.report.warnings.back();
        EXPECT_THAT(r.report.device, testing::HasSubstr("; ")) << "both are named";
    }
}

// The device whose call fails takes no further part, the other does its piece; when both fail, it is an error.
TEST_P(Faults, TheOtherDeviceDoesWhatAFailedOneLeaves)
{
    RenderSettings two = settings;
    two.device = "0,0";
    const std::vector<Rgb> expected = render(scene, two).film.beauty();
    const long calls = opencl_faults().calls;
    int mended = 0;
    for (long n = calls / 2; n < calls; n += std::max(calls / 10, 1l)) {
        opencl_faults().reset();
        opencl_faults().fail_at = n, opencl_faults().error = -36;  // the queue is no longer valid
        try {
            const RenderOutcome r = render(scene, two);
            EXPECT_EQ(r.film.beauty(), expected) << n;
            mended += !r.report.warnings.empty() && r.report.warnings.back().find("the others did its work") != std::string::npos;
        } catch (const DeviceError& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("CL_INVALID_COMMAND_QUEUE (-36)")) << n;
        }
    }
    EXPECT_GT(mended, 2);
    opencl_faults().reset();
    opencl_faults().fail_at = calls / 2, opencl_faults().failures = 1 << 30, opencl_faults().error = -36;
    EXPECT_THROW(render(scene, two), DeviceError);
}

INSTANTIATE_TEST_SUITE_P(Of, Faults,
                         testing::Values(FaultyScene{"ClearFog", clear_fog, Selection::all, 1u << 15}, FaultyScene{"ShadowedFog", shadowed_fog, Selection::all, 1u << 18},
                                         FaultyScene{"ChosenLights", shadowed_fog, Selection::tile, 1u << 18}),
                         [](const auto& info) { return info.param.name; });

TEST(SeveralDevices, EachMustBeThere)
{
    opencl_faults().reset();
    EXPECT_THROW(render(scene_of(clear_fog), {.passes = 1, .device = "0,no such device"}), NoDeviceError);
    EXPECT_THROW(render(scene_of(clear_fog), {.passes = 1, .device = "0,99"}), NoDeviceError);
    EXPECT_GT(render(scene_of(clear_fog), {.passes = 1, .lights = 64, .device = "all"}).report.pairs, 0u);
}

TEST(NoDevices, PlatformsWithoutDevicesAndNoPlatformsAreNamed)
{
    opencl_faults().reset();
    opencl_faults().no_devices = true;
    EXPECT_THROW(render(scene_of(clear_fog), {.passes = 1}), NoDeviceError);
    opencl_faults().reset();
    opencl_faults().no_platforms = true;
    EXPECT_THROW(render(scene_of(clear_fog), {.passes = 1}), NoDeviceError);
    opencl_faults().reset();
}

}  // namespace
