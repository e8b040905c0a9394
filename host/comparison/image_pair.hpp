#pragma once
/// Two images of the same thing: how far apart they are, and how much of that their noise explains.
#include <optional>
#include <string>
#include <vector>

#include "comparison/image_file.hpp"
#include "metrics/image_error.hpp"

namespace tyndall {

/// The block of 8 x 8 pixels, among those of the reference that are brighter than 2 % of its mean, whose mean differs most in relation to the reference's.
struct BlockDifference {
    int x = 0, y = 0;     ///< its top left pixel
    double relative = 0;  ///< image / reference - 1; 0 if there is no such block
};

struct ImagePair {
    ImageError error;
    double bias = 0;  ///< mean / mean of the reference - 1; 0 for a black reference
    BlockDifference block;
    double blocks_relative_mse = 0;  ///< metrics/block_means.hpp; not a number without a whole block
    int worst_x = 0, worst_y = 0;  ///< pixel that holds the largest term of relMSE
    /// Expected relMSE from the variances in the files; none unless both have them.
    std::optional<double> noise_relative_mse;
    /// Bounds on the standard error of `bias`, from the same: noise independent from pixel to pixel, and noise that all pixels share. Many-light noise lies between.
    double bias_error_low = 0, bias_error_high = 0;
    std::vector<std::string> warnings;
};

/// `image` against `reference`. Throws SceneError if they differ in size.
ImagePair compare_image_files(const ImageFile& image, const ImageFile& reference);

/// Some fifteen lines for people, warnings left out.
std::string to_table(const ImagePair& pair, const ImageFile& image, const ImageFile& reference);

/// "schema": "tyndall-image-comparison/1"; unknown numbers are null.
std::string to_json(const ImagePair& pair, const ImageFile& image, const ImageFile& reference);

}  // namespace tyndall
