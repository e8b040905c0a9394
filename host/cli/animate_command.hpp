#pragma once
/// `tyndall animate`: a render for every frame of a scene whose <default> values change with time.
#include <string>
#include <vector>

#include "cli/render_command.hpp"

namespace tyndall {

/// Value of a <default> in frame f: start + f step. It does not depend on which frames are rendered.
struct VaryingValue {
    std::string name;
    double start = 0, step = 1;
};

struct AnimateCommand {
    RenderCommand render;             ///< of every frame; output: the folder, the scene's name with "_frames" if empty
    int first = 0, end = 0;           ///< frames first, first + 1, ..., end - 1
    bool varying_seed = true;         ///< frame f is rendered with the seed's number plus f
    std::vector<VaryingValue> vary;   ///< empty: `frame` is the number of the frame
    std::string options;              ///< what was asked for that images depend on, as text: of a frame that is done it must be the same
};

/// frame_0007.exr in the folder; PNG and report lie beside it.
std::filesystem::path frame_file(const std::filesystem::path& folder, int frame);

/// Renders every frame that is not done; a frame goes on from its checkpoint. Returns the exit code: that of the first frame that was stopped, or 7 if one missed its target error.
/// Throws the errors of tyndall/error.hpp.
int run_animate(AnimateCommand command);

}  // namespace tyndall
