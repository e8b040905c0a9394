#pragma once
/// From a scene to a film: the whole renderer behind one function.
#include <functional>
#include <optional>

#include "film/film.hpp"
#include "pipeline/render_state.hpp"
#include "report/report.hpp"
#include "scene/scene.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

struct Progress {
    int passes_done = 0, passes_wanted = 0;  ///< wanted 0: until the time is up
    double seconds = 0, seconds_left = 0;    ///< left: estimated to the end of the budget
    double error = 0;                        ///< estimated sqrt(relMSE) now; negative: unknown yet, or a shard
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

/// What a render can do beyond that.
struct RenderControl {
    std::string program;                ///< version of the program: states of another one are refused
    ShardNumber shard;                  ///< a part of the passes, which must be given as a number
    std::optional<RenderState> earlier; ///< to go on from
    std::string earlier_name = "the checkpoint";  ///< for messages
    /// Called after every pass, like `ProgressCallback`; `state` is complete but for the errors in its report.
    std::function<bool(const Progress&, const RenderState& state)> progress;
};

/// Renders a whole image, or a shard of it, from the beginning or from an earlier state. Byte-equal, whatever was interrupted. Throws what `render` throws, and SceneError, which says what
/// differs, if the earlier state is one of another render.
RenderState render_state(const Scene& scene, const RenderSettings& settings, RenderControl control);

/// Fills in what a report says of the film: its size, passes and errors.
void describe_film(Report& report, const Film& film);

}  // namespace tyndall
