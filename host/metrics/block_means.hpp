#pragma once
/// Means over blocks of 8 x 8 pixels: large enough that noise averages out, small enough that a bias in a corner is seen.
#include <span>
#include <vector>

#include "metrics/mean_estimate.hpp"
#include "scene/vector.hpp"

namespace tyndall {

inline constexpr int block_side = 8;  ///< pixels

/// Means over pixels and channels of the whole blocks, row by row from the top left; pixels beyond the last whole block are left out. Channels share their light paths:
/// they count as one measurement.
std::vector<double> block_means(std::span<const Rgb> image, int width);

/// relMSE of the blocks' means, with epsilon = (.05 x their mean)^2 of the reference: the error at low frequencies, where errors that neighbouring pixels share do
/// not average out. Not a number for images without a whole block.
double blocks_relative_mse(std::span<const Rgb> image, std::span<const Rgb> reference, int width);

/// Mean and spread of every block, and of the whole image, over independent images of one size.
class BlockStatistics {
public:
    void add(std::span<const Rgb> image, int width);
    /// As if the other's images had been added; either may be empty, otherwise both hold images of one size.
    void merge(const BlockStatistics& other);
    std::size_t images() const { return whole_.count(); }
    /// Of the image, over pixels and channels.
    MeanEstimate whole() const { return whole_.estimate(); }
    const std::vector<RunningMean>& blocks() const { return blocks_; }

private:
    RunningMean whole_;
    std::vector<RunningMean> blocks_;
};

struct BlockBias {
    int lit_blocks = 0;       ///< brighter than 2 % of the mean block of the reference; the others have no meaningful relative bias
    double chi_squared = 0;   ///< mean of z^2 over lit blocks, each |z| capped at 30: 1 without bias
    double beyond_three = 0;  ///< share of lit blocks with |z| > 3: .0027 without bias
    double largest_z = 0;     ///< with its sign
    double largest_relative = 0;  ///< value / reference - 1 of that block
    int largest_block = 0;        ///< its number
    std::vector<double> z;        ///< of every block, row by row; NaN of those that are not lit
};

/// Block by block; the reference's blocks with their variances (exact: variance 0, infinite degrees), as many as the image has.
BlockBias block_bias(const BlockStatistics& image, std::span<const MeanEstimate> reference);

}  // namespace tyndall
