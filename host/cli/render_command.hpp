#pragma once
/// `tyndall render`: what was asked for, and doing it.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "cli/live_view.hpp"
#include "cli/outputs.hpp"
#include "cli/progress_view.hpp"
#include "pipeline/render_state.hpp"
#include "scene/load_scene.hpp"
#include "scene/scene.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

struct RenderCommand {
    std::filesystem::path scene, output, report;  ///< empty output and report: named after the scene and the output
    LoadOptions load;
    RenderSettings settings;
    std::optional<std::pair<int, int>> resolution;
    std::optional<Crop> crop;
    std::optional<ProgressStyle> progress;  ///< none: a bar on a terminal, plain lines otherwise
    ImageWishes image;
    ShardNumber shard;                          ///< a part of the passes
    std::optional<double> checkpoint_seconds;   ///< between two of them, 0: none; nothing: by rule (cli/checkpoint.hpp)
    bool resume = false;                        ///< go on from the checkpoint, if there is one
    std::optional<ViewerAddress> viewer;        ///< where the image is shown while it is rendered
    bool strict_nan = false;                    ///< exit code 1 if a sample was not a finite number
    bool dry_run = false;                       ///< check everything and say what would be done
};

/// 16 passes where neither passes, a time nor a target error are given.
inline void give_default_budget(RenderSettings& settings)
{
    if (settings.passes == 0 && settings.seconds == 0 && settings.target_error == 0) settings.passes = 16;
}

/// Gives the camera another resolution and crop window. Without a new crop, the scene's own keeps its place in the picture: it is scaled
/// with the film and rounded outward to whole pixels. Throws UsageError for a crop window that does not lie in the film or a film that is
/// too large.
void override_film(Camera& camera, const std::optional<std::pair<int, int>>& resolution, const std::optional<Crop>& crop);

/// Loads, renders, writes. Returns the exit code; throws the errors of tyndall/error.hpp.
int run_render(RenderCommand command);

}  // namespace tyndall
