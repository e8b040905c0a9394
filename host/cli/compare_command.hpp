#pragma once
/// `tyndall compare`: two images, or methods and settings for a scene at equal time.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparison/candidate.hpp"
#include "scene/load_scene.hpp"
#include "tyndall/settings.hpp"

namespace tyndall {

struct CompareCommand {
    std::vector<std::filesystem::path> inputs;  ///< image.exr reference.exr, or scene.xml
    std::string invocation;                     ///< the command line, quoted for a shell
    std::vector<std::string> layers;            ///< to compare, summed; empty: the image
    bool json = false;
    // two images
    std::optional<double> tolerance;            ///< on the error, the root of relMSE; none: any error is fine
    // a scene
    std::vector<Method> methods;                ///< empty: all that there are
    std::vector<Dial> dials;                    ///< settings with their values
    bool every_dial = false;                    ///< one setting at a time around the first method, instead of `dials`
    std::vector<double> times;                  ///< seconds; empty: 1, 6
    int repeats = 3;
    std::filesystem::path reference, output;    ///< empty: made here; folder named after the scene
    std::optional<double> reference_seconds;    ///< none: four times the longest time
    std::optional<Method> reference_method;     ///< none: path tracing; with every dial the first method, if it is unbiased
    RenderSettings settings;                    ///< what is the same for all
    LoadOptions load;
    std::optional<std::pair<int, int>> resolution;
    std::optional<Crop> crop;
};

/// Two images: prints how far the first is from the second; ExitCode::outside_tolerance beyond the tolerance. A scene: measures, writes the page (index.html), comparison.json and, where
/// it was made here, the reference, into the folder `output`; prints their names. Throws UsageError, SceneError, IoError, NoDeviceError, DeviceError.
int run_compare(CompareCommand command);

/// The second half of `run_compare`: one scene.
int compare_methods(CompareCommand& command);

}  // namespace tyndall
