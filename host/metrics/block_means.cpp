#include "metrics/block_means.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace tyndall {

std::vector<double> block_means(std::span<const Rgb> image, int width)
{
    assert(width > 0 && image.size() % static_cast<std::size_t>(width) == 0);
    const int height = static_cast<int>(image.size() / static_cast<std::size_t>(width)), columns = width / block_side, rows = height / block_side;
    std::vector<double> means(static_cast<std::size_t>(columns) * rows, 0.);
    for (int y = 0; y < rows * block_side; ++y)
        for (int x = 0; x < columns * block_side; ++x)
            means[static_cast<std::size_t>(y / block_side) * columns + x / block_side] += sum(image[static_cast<std::size_t>(y) * width + x]);
    for (double& mean : means) mean /= 3 * block_side * block_side;
    return means;
}

double blocks_relative_mse(std::span<const Rgb> image, std::span<const Rgb> reference, int width)
{
    const std::vector<double> means = block_means(image, width), expected = block_means(reference, width);
    if (means.empty()) return std::numeric_limits<double>::quiet_NaN();
    double mean = 0, error = 0;
    for (const double block : expected) mean += block / static_cast<double>(expected.size());
    const double floor = .05 * mean * .05 * mean;
    for (std::size_t b = 0; b < means.size(); ++b) {
        const double difference = means[b] - expected[b], scale = expected[b] * expected[b] + floor;
        error += difference == 0 ? 0 : difference * difference / scale / static_cast<double>(means.size());
    }
    return error;
}

void BlockStatistics::add(std::span<const Rgb> image, int width)
{
    const std::vector<double> means = block_means(image, width);
    blocks_.resize(means.size());
    for (std::size_t b = 0; b < means.size(); ++b) blocks_[b].add(means[b]);
    double total = 0;
    for (const Rgb& pixel : image) total += sum(pixel);
    whole_.add(total / (3. * static_cast<double>(image.size())));
}

void BlockStatistics::merge(const BlockStatistics& other)
{
    blocks_.resize(std::max(blocks_.size(), other.blocks_.size()));
    for (std::size_t b = 0; b < other.blocks_.size(); ++b) blocks_[b].merge(other.blocks_[b]);
    whole_.merge(other.whole_);
}

BlockBias block_bias(const BlockStatistics& image, std::span<const MeanEstimate> reference)
{
    constexpr double lit_share = .02, largest_counted = 30;
    assert(image.blocks().size() == reference.size());
    double mean = 0;
    for (const MeanEstimate& block : reference) mean += block.value / static_cast<double>(reference.size());
    BlockBias result;
    result.z.assign(reference.size(), std::numeric_limits<double>::quiet_NaN());
    double squares = 0, beyond = 0;
    for (std::size_t b = 0; b < reference.size(); ++b) {
        if (!(reference[b].value > lit_share * mean)) continue;
        const Bias bias = bias_of(image.blocks()[b].estimate(), reference[b]);
        const double counted = std::min(std::abs(bias.z), largest_counted);
        result.z[b] = bias.z;
        ++result.lit_blocks, squares += counted * counted, beyond += bias.significant();
        if (std::abs(bias.z) > std::abs(result.largest_z)) result.largest_z = bias.z, result.largest_relative = bias.relative, result.largest_block = static_cast<int>(b);
    }
    if (result.lit_blocks) result.chi_squared = squares / result.lit_blocks, result.beyond_three = beyond / result.lit_blocks;
    return result;
}

}  // namespace tyndall
