#include "cli/compare_command.hpp"

#include <cmath>

#include "cli/exit_code.hpp"
#include "cli/say.hpp"
#include "comparison/image_pair.hpp"
#include "report/readable.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

int compare_images(const CompareCommand& command)
{
    const ImageFile image = load_image_file(command.inputs[0], command.layers), reference = load_image_file(command.inputs[1], command.layers);
    const ImagePair pair = compare_image_files(image, reference);
    for (const auto& warning : pair.warnings) say(stderr, "warning: {}\n", terminal_safe(warning));
    say("{}", command.json ? to_json(pair, image, reference) : to_table(pair, image, reference));
    const double error = std::sqrt(pair.error.relative_mse);
    if (!command.tolerance || error <= *command.tolerance) return static_cast<int>(ExitCode::ok);
    say(stderr, "the error of {} is above the tolerance of {}\n", readable_percent(error), readable_percent(*command.tolerance));
    return static_cast<int>(ExitCode::outside_tolerance);
}

}  // namespace

int run_compare(CompareCommand command)
{
    const bool images = command.inputs.front().extension() == ".exr";
    if (command.inputs.size() == 2 && images) return compare_images(command);
    if (command.inputs.size() == 1 && !images) {
        if (command.tolerance) throw UsageError("--tolerance is for two images: `tyndall compare image.exr reference.exr --tolerance 1%`");
        return compare_methods(command);
    }
    throw UsageError("compare takes two images, `tyndall compare image.exr reference.exr`, or one scene, `tyndall compare scene.xml`");
}

}  // namespace tyndall
