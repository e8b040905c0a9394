#include "image_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <stdexcept>

#include "film/error_estimate.hpp"

namespace tyndall::test {
namespace {

constexpr double tiny = 1e-300;
/// A block darker than this share of the reference's mean has no meaningful relative error.
constexpr double lit_share = .02;

/// Means over whole blocks and the channels; pixels beyond the last whole block are left out. Channels share their light paths: they count
/// as one measurement.
template <class Value>
std::vector<double> block_means(const ImageRgb& image, int size, Value&& value)
{
    std::vector<double> means;
    for (int y0 = 0; y0 + size <= image.height; y0 += size)
        for (int x0 = 0; x0 + size <= image.width; x0 += size) {
            double sum = 0;
            for (int y = y0; y < y0 + size; ++y)
                for (int x = x0; x < x0 + size; ++x)
                    for (int c = 0; c < 3; ++c) sum += value(image.at(x, y)[c]);
            means.push_back(sum / (3 * size * size));
        }
    return means;
}

double mean_of(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double mean_of(const ImageRgb& image)
{
    double sum = 0;
    for (const auto& pixel : image.pixels) sum += pixel.x + pixel.y + pixel.z;
    return sum / (3. * static_cast<double>(image.pixels.size()));
}

/// Unbiased variance of the mean of independent values.
double variance_of_mean(const std::vector<double>& values)
{
    const double mean = mean_of(values), n = static_cast<double>(values.size());
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return sum / (n - 1) / n;
}

double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : .5 * (values[middle - 1] + values[middle]);
}

/// The normal deviate that is as improbable as `t` with so many degrees of freedom.
double normal_deviate(double t, double degrees)
{
    const boost::math::students_t student(degrees);
    const double tail = std::clamp(boost::math::cdf(boost::math::complement(student, std::abs(t))), tiny, .5);
    const double z = boost::math::quantile(boost::math::complement(boost::math::normal(), tail));
    return std::copysign(z, t);
}

/// Counts and zeroes what is not finite; counts what is negative.
std::vector<ImageRgb> cleaned(std::span<const ImageRgb> runs, ImageComparison& result)
{
    std::vector<ImageRgb> clean(runs.begin(), runs.end());
    for (auto& run : clean)
        for (auto& pixel : run.pixels)
            for (int c = 0; c < 3; ++c) {
                if (!std::isfinite(pixel[c])) ++result.not_finite, pixel[c] = 0;
                if (pixel[c] < 0) ++result.negative;
            }
    return clean;
}

ImageRgb mean_image(const std::vector<ImageRgb>& runs)
{
    ImageRgb mean = runs.front();
    for (std::size_t r = 1; r < runs.size(); ++r)
        for (std::size_t i = 0; i < mean.pixels.size(); ++i) mean.pixels[i] += runs[r].pixels[i];
    for (auto& pixel : mean.pixels) pixel /= static_cast<double>(runs.size());
    return mean;
}

double mean_square(const ImageRgb& error)
{
    double sum = 0;
    for (const auto& pixel : error.pixels) sum += glm::dot(pixel, pixel);
    return error.pixels.empty() ? 0 : sum / (3. * static_cast<double>(error.pixels.size()));
}

void judge_mean(const std::vector<ImageRgb>& runs, const ImageRgb& reference, const ImageRgb& reference_error, ImageComparison& result)
{
    std::vector<double> means;
    for (const auto& run : runs) means.push_back(mean_of(run));
    result.mean = mean_of(means), result.reference_mean = mean_of(reference);
    if (result.reference_mean <= 0) return;
    const double variance = variance_of_mean(means) + mean_square(reference_error) / static_cast<double>(reference.pixels.size());
    const boost::math::students_t student(static_cast<double>(runs.size() - 1));
    result.bias = result.mean / result.reference_mean - 1;
    result.bias_half_width = boost::math::quantile(student, .975) * std::sqrt(variance) / result.reference_mean;
}

/// The blocks of every run and of the reference, with the reference's variances.
struct BlockData {
    std::vector<std::vector<double>> runs;
    std::vector<double> reference, reference_variance;
};

BlockData block_data(const std::vector<ImageRgb>& runs, const ImageRgb& reference, const ImageRgb& reference_error, int size)
{
    const auto itself = [](double value) { return value; };
    BlockData data;
    for (const auto& run : runs) data.runs.push_back(block_means(run, size, itself));
    data.reference = block_means(reference, size, itself);
    if (reference_error.pixels.empty())
        data.reference_variance.assign(data.reference.size(), 0);
    else
        data.reference_variance = block_means(reference_error, size, [&](double error) { return error * error / (size * size); });
    return data;
}

void summarise_deviates(const std::vector<double>& deviates, double limit, ImageComparison& result)
{
    result.lit_blocks = static_cast<int>(deviates.size());
    result.z_mean = mean_of(deviates);
    double squares = 0, capped_squares = 0, beyond = 0;
    for (const double z : deviates) {
        squares += (z - result.z_mean) * (z - result.z_mean);
        capped_squares += std::min(std::abs(z), 30.) * std::min(std::abs(z), 30.);
        beyond += std::abs(z) > limit;
        result.largest_z = std::max(result.largest_z, std::abs(z));
    }
    const double n = std::max<double>(1, static_cast<double>(deviates.size()));
    result.z_deviation = std::sqrt(squares / n), result.chi_squared = capped_squares / n, result.z_share = beyond / n;
}

void judge_blocks(const BlockData& data, const ComparisonLimits& limits, ImageComparison& result)
{
    const double threshold = lit_share * mean_of(data.reference);
    std::vector<double> deviates, errors, reference_errors;
    for (std::size_t b = 0; b < data.reference.size(); ++b) {
        std::vector<double> values;
        for (const auto& run : data.runs) values.push_back(run[b]);
        const double difference = mean_of(values) - data.reference[b], variance = variance_of_mean(values);
        if (!(data.reference[b] > threshold)) {
            result.dark_difference = std::max(result.dark_difference, std::abs(difference) / result.reference_mean);
            continue;
        }
        const double slack = limits.systematic * data.reference[b];
        const double t = difference / std::max(std::sqrt(variance + data.reference_variance[b] + slack * slack), tiny);
        deviates.push_back(normal_deviate(t, static_cast<double>(values.size() - 1)));
        errors.push_back(std::sqrt(variance) / data.reference[b]);
        reference_errors.push_back(std::sqrt(data.reference_variance[b]) / data.reference[b]);
    }
    summarise_deviates(deviates, limits.z, result);
    result.block_error = median(errors), result.reference_block_error = median(reference_errors);
}

void list_failures(const ComparisonLimits& limits, ImageComparison& result)
{
    const auto demand = [&](const char* what, double value, double limit) {
        if (!(value <= limit)) result.failures.push_back(fmt::format("{} is {:.4g}, limit {:.4g}", what, value, limit));
    };
    demand("number of values that are not finite", result.not_finite, 0);
    demand("number of negative values", result.negative, 0);
    demand("significant relative bias", std::abs(result.bias) - result.bias_half_width, limits.significant_bias);
    demand("relative bias or its 95 % half width", std::max(std::abs(result.bias), result.bias_half_width), limits.bias);
    demand("reduced chi^2 of block z", result.chi_squared, limits.chi_squared);
    demand("share of blocks with large |z|", result.z_share, limits.z_share);
    demand("largest |z|", result.largest_z, limits.largest_z);
    demand("difference of dark blocks", result.dark_difference, limits.dark);
    if (result.lit_blocks == 0) result.failures.emplace_back("no block is lit: there is nothing to compare");
}

void check_sizes(std::span<const ImageRgb> runs, const ImageRgb& reference, const ImageRgb& reference_error)
{
    const auto same = [&](const ImageRgb& image) { return image.width == reference.width && image.height == reference.height; };
    if (runs.size() < 3) throw std::invalid_argument("comparing images needs at least three independent runs");
    if (!std::ranges::all_of(runs, same) || !(reference_error.pixels.empty() || same(reference_error)))
        throw std::invalid_argument("compared images differ in size");
}

}  // namespace

ImageComparison compare_images(std::span<const ImageRgb> runs, const ImageRgb& reference, const ImageRgb& reference_error,
                               const ComparisonLimits& limits)
{
    check_sizes(runs, reference, reference_error);
    ImageComparison result;
    const auto clean = cleaned(runs, result);
    result.relative_mse = relative_mse(mean_image(clean).pixels, reference.pixels);
    judge_mean(clean, reference, reference_error, result);
    judge_blocks(block_data(clean, reference, reference_error, limits.block), limits, result);
    list_failures(limits, result);
    return result;
}

std::string to_string(const ImageComparison& c)
{
    std::string text = fmt::format("mean {:.6g}, reference {:.6g}: bias {:+.3f} % +- {:.3f} % (95 %)\n", c.mean, c.reference_mean,
                                   100 * c.bias, 100 * c.bias_half_width);
    text += fmt::format("relMSE {:.4g}; median block error {:.3f} %, of the reference {:.3f} %\n", c.relative_mse, 100 * c.block_error,
                        100 * c.reference_block_error);
    text +=
        fmt::format("{} lit blocks: z mean {:+.3f}, deviation {:.3f}, reduced chi^2 {:.3f}, beyond limit {:.2f} %, largest |z| {:.2f}\n",
                    c.lit_blocks, c.z_mean, c.z_deviation, c.chi_squared, 100 * c.z_share, c.largest_z);
    text += fmt::format("dark blocks differ by {:.3f} % of the mean; {} values not finite, {} negative\n", 100 * c.dark_difference,
                        c.not_finite, c.negative);
    for (const auto& failure : c.failures) text += "FAILED: " + failure + "\n";
    return text + (c.passed() ? "PASSED\n" : "");
}

}  // namespace tyndall::test
