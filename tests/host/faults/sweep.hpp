#pragma once
/// Every OpenCL call of a small render fails, one after the other: the same image, or an error that says what happened.
#include <gmock/gmock.h>

#include <vector>

#include "../../support/faulty_opencl.hpp"
#include "../pipeline/whole_renderer.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {

/// Out of resources, of memory, of host memory; an event that failed; queue, buffer, kernel arguments that are none; no device any more.
inline constexpr int sweep_codes[] = {-5, -4, -6, -14, -36, -38, -52, -2};

class Sweep {
public:
    explicit Sweep(Selection selection) : settings_{.passes = 1, .lights = 64, .selection = selection, .selected_lights = 16, .selftest = false} {}

    /// Calls that can fail, with or without those that only ask.
    long calls(bool queries)
    {
        queries_ = queries;
        opencl_faults().reset();
        opencl_faults().queries = queries;
        expected_ = image();
        return opencl_faults().calls;
    }

    /// Call `n` fails, or that one and all that follow.
    void fail(long n, int code, bool for_ever, bool late)
    {
        OpenClFaults& faults = opencl_faults();
        faults.reset();
        faults.queries = queries_, faults.fail_at = n, faults.error = code, faults.late = late;
        if (for_ever) faults.failures = 1 << 30;
        std::string error;
        std::vector<Rgb> got;
        try {
            got = image();
        } catch (const DeviceError& e) {
            error = e.what();
        } catch (const NoDeviceError& e) {
            error = e.what();
        }
        const std::string where = fmt::format("call {} ({}), {}, {}, {}", n, faults.failed, code, for_ever ? "and all after it" : "once", late ? "late" : "at once");
        if (error.empty()) EXPECT_EQ(got, expected_) << where;
        else EXPECT_GT(error.size(), 30u) << where;
        ++(error.empty() ? same_ : failed_);
    }

    int same() const { return same_; }
    int failed() const { return failed_; }

private:
    std::vector<Rgb> image() const { return render(scene_, settings_).film.beauty(); }

    const Scene scene_ = scene_of(medium("fog", Rgb(.5, 1, 2), Rgb(.9, .7, .5), .5) + container(Vec3(-.5), Vec3(.5), "fog") + point_light({.5, 1, .5}, Rgb(2)) +
                                  sensor({.origin = {.3, .6, 3}, .pixels = 8}) + horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75))) + sphere({.1, .1, .1}, .2, diffuse(Rgb(.5))));
    const RenderSettings settings_;
    std::vector<Rgb> expected_;
    bool queries_ = false;
    int same_ = 0, failed_ = 0;
};

}  // namespace tyndall::test
