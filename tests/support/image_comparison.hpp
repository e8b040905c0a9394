#pragma once
/// Is the mean of several independent renders the reference, as far as the noise of both can tell?
///
/// Noise of many-light methods is correlated between pixels, so pixel scatter says nothing about the error. The test therefore takes
/// renders with independent seeds, averages pixels and channels over blocks of 8 x 8, and judges each block's difference by the scatter
/// between renders (Student's t with runs - 1 degrees of freedom, turned into a normal z) and the reference's standard error.
///
/// False alarms: with eight runs whose mean has a median block error <= .6 %, the limit on chi^2 fails fewer than 1 % of correct images,
/// because the systematic slack of 1 % then outweighs the correlated noise.
#include <span>
#include <string>
#include <vector>

#include "image_rgb.hpp"

namespace tyndall::test {

struct ComparisonLimits {
    int block = 8;                   ///< pixels
    double significant_bias = .005;  ///< |relative bias of the mean| - its 95 % half width
    double bias = .02;               ///< |relative bias| and half width: the test must be able to see
    double systematic = .01;         ///< relative slack per block, added to the variance
    double z = 3, z_share = .03;     ///< at most this share of lit blocks beyond z
    double chi_squared = 1.6;        ///< reduced, of the blocks' z
    double largest_z = 8;
    double dark = .02;  ///< |difference| of blocks darker than 2 % of the mean, over the mean
};

struct ImageComparison {
    int not_finite = 0, negative = 0;  ///< values of the renders
    double relative_mse = 0;           ///< of the mean of the renders (film/error_estimate.hpp)
    double mean = 0, reference_mean = 0;
    double bias = 0, bias_half_width = 0;  ///< relative; 95 % confidence
    int lit_blocks = 0;
    double z_mean = 0, z_deviation = 0, chi_squared = 0, z_share = 0, largest_z = 0;
    double block_error = 0, reference_block_error = 0;  ///< median relative standard error of a lit block
    double dark_difference = 0;                         ///< 0 if there is no dark block
    std::vector<std::string> failures;                  ///< one sentence per criterion that is not met
    bool passed() const { return failures.empty(); }
};

/// All images have one size; at least three runs. `reference_error` is the reference's standard error per pixel and channel; it may be
/// empty: exact.
ImageComparison compare_images(std::span<const ImageRgb> runs, const ImageRgb& reference, const ImageRgb& reference_error,
                               const ComparisonLimits& limits = {});

/// All numbers and the failures, a line each, for test output.
std::string to_string(const ImageComparison& comparison);

}  // namespace tyndall::test
