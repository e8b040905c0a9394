#pragma once
/// From a scene to a film: the whole renderer behind one function.
#include <functional>

#include "film/film.hpp"
#include "report/report.hpp"
#include "scene/scene.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

struct Progress {
    int passes_done = 0, passes_wanted = 0;  ///< wanted 0: until the time is up
    double seconds = 0, seconds_left = 0;    ///< left: estimated to the end of the budget
    double error = 0;                        ///< estimated sqrt(relMSE) now; negative: unknown yet
    double error_aimed_at = .01;             ///< the target error, or 1 % without one
    double seconds_to_error = -1;            ///< from now until it is reached, as variance falls with 1 / passes; negative: unknown yet
    double pairs_per_second = 0, shadow_segments_per_second = 0;
};

struct RenderOutcome {
    Film film;
    Report report;
};

/// Called after every pass, on the thread that called `render`; return false to stop (the film so far is returned, stopped_by "interrupt").
using ProgressCallback = std::function<bool(const Progress&, const Film&)>;

/// Renders with the settings. Throws UsageError, NoDeviceError, DeviceError. `--method path` needs no OpenCL device.
RenderOutcome render(const Scene& scene, const RenderSettings& settings, const ProgressCallback& progress = {});

}  // namespace tyndall
