#pragma once
/// What runs are measured against, with its own error bar.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "comparison/image_file.hpp"
#include "metrics/block_means.hpp"
#include "pipeline/render.hpp"

namespace tyndall {

struct Reference {
    std::string origin;  ///< where it comes from, a sentence
    int width = 0, height = 0;
    std::vector<Rgb> pixels;
    MeanEstimate whole;                ///< over pixels and channels
    std::vector<MeanEstimate> blocks;  ///< of 8 x 8 pixels (metrics/block_means.hpp)
    /// Expected relMSE of the reference itself. What is measured against it holds so much on top of its own; 0 if unknown.
    double floor = 0;
    bool error_known = false;
    std::map<std::string, std::vector<Rgb>> layers;  ///< by name, where known
    std::map<std::string, double> layer_floors;      ///< the same as `floor`, of layers, where known
    std::vector<std::string> warnings;
};

/// From a file. Where it holds variances they give the error bars: of path tracing noise is independent between pixels, of other and unknown methods the bars hold for noise that
/// all pixels of a block, or of the image, share. Warns of unknown errors and of a scene whose hash is not `scene_hash`.
Reference reference_from_file(const ImageFile& file, bool independent_pixels, const std::string& scene_hash);

/// Renders with settings, starting and counting as tyndall::render does.
using RenderFunction = std::function<RenderOutcome(const RenderSettings&, const ProgressCallback&)>;

struct MadeReference {
    Reference reference;
    RenderOutcome outcome;
};

/// Renders for so many seconds, or until `stop` says so; two passes at least, for the error bar. The error bars come from the spread of whole passes, so they hold however noise is
/// shared by pixels. Throws what `render` throws, and Error if it was stopped too early.
MadeReference make_reference(const RenderFunction& render, RenderSettings settings, double seconds, const std::function<bool()>& stop);

}  // namespace tyndall
