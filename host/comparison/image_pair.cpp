#include "comparison/image_pair.hpp"

#include <fmt/format.h>

#include <cmath>

#include "film/error_estimate.hpp"
#include "metrics/block_means.hpp"

namespace tyndall {
namespace {

BlockDifference worst_block(const ImageFile& image, const ImageFile& reference)
{
    constexpr double lit_share = .02;
    const auto means = block_means(image.pixels, image.width), expected = block_means(reference.pixels, reference.width);
    double mean = 0;
    for (const double block : expected) mean += block / static_cast<double>(expected.size());
    BlockDifference worst;
    const int columns = image.width / block_side;
    for (std::size_t b = 0; b < means.size(); ++b) {
        if (!(expected[b] > lit_share * mean)) continue;
        const double relative = means[b] / expected[b] - 1;
        const int index = static_cast<int>(b);
        if (std::abs(relative) > std::abs(worst.relative)) worst = {index % columns * block_side, index / columns * block_side, relative};
    }
    return worst;
}

/// Expected relMSE and the bounds on the error of the bias, from the variances of both.
void add_noise(ImagePair& pair, const ImageFile& image, const ImageFile& reference)
{
    if (image.variance.empty() || reference.variance.empty()) return;
    std::vector<Rgb> variance(image.variance);
    double squares = 0, roots = 0;
    for (std::size_t i = 0; i < variance.size(); ++i) {
        variance[i] += reference.variance[i];
        squares += sum(variance[i]), roots += sum(glm::sqrt(variance[i]));
    }
    pair.noise_relative_mse = expected_relative_mse(reference.pixels, variance);
    const double values = 3. * static_cast<double>(variance.size());
    if (pair.error.reference_mean > 0) {
        constexpr double channels = 3;  // of a pixel share their paths: counted as one measurement
        pair.bias_error_low = std::sqrt(channels * squares) / values / pair.error.reference_mean;
        pair.bias_error_high = roots / values / pair.error.reference_mean;
    }
}

void add_warnings(ImagePair& pair, const ImageFile& image, const ImageFile& reference)
{
    if (!image.scene_hash.empty() && !reference.scene_hash.empty() && image.scene_hash != reference.scene_hash)
        pair.warnings.push_back(fmt::format("{} and {} were rendered from scenes that differ (hash {} and {}): part of the difference may be the scenes'", image.file.string(),
                                            reference.file.string(), image.scene_hash, reference.scene_hash));
    if (pair.error.has_outliers())
        pair.warnings.push_back(fmt::format("a thousandth of the values, the largest at pixel ({}, {}), holds {:.0f} % of the squared error: outliers rule this number", pair.worst_x,
                                            pair.worst_y, 100 * pair.error.share_of_largest));
    if (!(pair.error.reference_mean > 0))
        pair.warnings.push_back(reference.file.string() + ": the reference is black, so nothing can be said in relation to it");
}

}  // namespace

ImagePair compare_image_files(const ImageFile& image, const ImageFile& reference)
{
    require_same_window(image, reference);
    ImagePair pair{.error = image_error(image.pixels, reference.pixels), .block = worst_block(image, reference), .blocks_relative_mse = blocks_relative_mse(image.pixels, reference.pixels, image.width)};
    if (pair.error.reference_mean > 0) pair.bias = pair.error.mean / pair.error.reference_mean - 1;
    const auto width = static_cast<std::size_t>(image.width);
    pair.worst_x = static_cast<int>(pair.error.worst_pixel % width), pair.worst_y = static_cast<int>(pair.error.worst_pixel / width);
    add_noise(pair, image, reference);
    add_warnings(pair, image, reference);
    return pair;
}

}  // namespace tyndall
