#pragma once
/// How far an image is from a reference, as numbers. Noise and bias are told apart in metrics/mean_estimate.hpp.
#include <cstddef>
#include <span>

#include "scene/vector.hpp"

namespace tyndall {

struct ImageError {
    double relative_mse = 0;          ///< the error as it is defined once (film/error_estimate.hpp); its root is "the error"
    double trimmed_relative_mse = 0;  ///< the same without the largest thousandth of its terms, rounded down: without rare outliers
    double rmse = 0;                  ///< root of the mean of (x - ref)^2 over pixels and channels, radiance
    double mean = 0, reference_mean = 0;  ///< over pixels and channels, radiance
    /// Share of all squared relative error that the largest thousandth of the terms (at least one) holds.
    double share_of_largest = 0;
    std::size_t worst_pixel = 0;  ///< that holds the largest term
    double worst_difference = 0;  ///< x - ref there, in the channel of that term

    /// Do a few values hold what should be spread? Normal noise of one strength leaves 1.3 % to the largest thousandth of its squares (3.3 % with
    /// strengths that differ by up to a factor of ten over the image); the limit of a fifth is far from both, and a single stray value that spoils an image is beyond it.
    bool has_outliers() const { return relative_mse > 0 && share_of_largest > .2; }
};

/// Same size, not empty, all finite.
ImageError image_error(std::span<const Rgb> image, std::span<const Rgb> reference);

}  // namespace tyndall
