#include "film/error_estimate.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <cassert>
#include <cmath>
#include <limits>

namespace tyndall {
namespace {

/// Share of the mean of the reference below which errors count as absolute, so that dark pixels do not rule the measure.
constexpr double dark_share = .05;

double epsilon_of(const Rgb& sum_of_reference, std::size_t pixels)
{
    const double mean = (sum_of_reference.x + sum_of_reference.y + sum_of_reference.z) / (3. * static_cast<double>(pixels));
    return dark_share * mean * (dark_share * mean);
}

/// One pixel's terms; 0 / 0 (nothing expected, nothing there) is 0.
Rgb terms(const Rgb& squared_error, const Rgb& reference, double epsilon)
{
    Rgb terms(0);
    for (int c = 0; c < 3; ++c)
        if (squared_error[c] != 0) terms[c] = squared_error[c] / (reference[c] * reference[c] + epsilon);
    return terms;
}

/// `squared_error(i)`, `reference(i)`: the two images, pixel by pixel.
template <class SquaredError, class Reference>
double mean_of_terms(std::size_t pixels, SquaredError&& squared_error, Reference&& reference)
{
    Rgb sum_of_reference(0);
    for (std::size_t i = 0; i < pixels; ++i) sum_of_reference += reference(i);
    const double epsilon = epsilon_of(sum_of_reference, pixels);
    double sum = 0;
    for (std::size_t i = 0; i < pixels; ++i) sum += tyndall::sum(terms(squared_error(i), reference(i), epsilon));
    return sum / (3. * static_cast<double>(pixels));
}

}  // namespace

double mean_of_relative_terms(std::size_t pixels, const std::function<Rgb(std::size_t)>& squared_error, const std::function<Rgb(std::size_t)>& reference)
{
    return mean_of_terms(pixels, squared_error, reference);
}

double relative_mse(std::span<const Rgb> image, std::span<const Rgb> reference)
{
    assert(image.size() == reference.size() && !image.empty());
    const auto squared_error = [&](std::size_t i) { return (image[i] - reference[i]) * (image[i] - reference[i]); };
    return mean_of_terms(image.size(), squared_error, [&](std::size_t i) { return reference[i]; });
}

std::vector<double> relative_squared_errors(std::span<const Rgb> image, std::span<const Rgb> reference)
{
    assert(image.size() == reference.size() && !image.empty());
    Rgb sum_of_reference(0);
    for (const Rgb& pixel : reference) sum_of_reference += pixel;
    const double epsilon = epsilon_of(sum_of_reference, reference.size());
    std::vector<double> all;
    all.reserve(3 * image.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb difference = image[i] - reference[i], pixel = terms(difference * difference, reference[i], epsilon);
        all.insert(all.end(), {pixel.x, pixel.y, pixel.z});
    }
    return all;
}

double expected_relative_mse(std::span<const Rgb> image, std::span<const Rgb> variance_of_mean)
{
    assert(image.size() == variance_of_mean.size() && !image.empty());
    return mean_of_terms(
        image.size(), [&](std::size_t i) { return variance_of_mean[i]; }, [&](std::size_t i) { return image[i]; });
}

double estimated_error(const Film& film)
{
    if (film.passes() < 2) return -1;
    const auto variance = [&](std::size_t i) { return film.variance_of_mean(i); };
    return std::sqrt(mean_of_terms(film.pixels(), variance, [&](std::size_t i) { return film.beauty(i); }));
}

double estimated_error(const Film& film, Layer layer)
{
    const double square = film.relative_mse(layer);
    return square < 0 ? -1 : std::sqrt(square);
}

double error_upper_bound(const Film& film)
{
    const double error = estimated_error(film), spread = film.spread().relative_standard_error();
    if (film.passes() < pilot_passes || spread < 0) return std::numeric_limits<double>::infinity();
    const boost::math::students_t student(static_cast<double>(film.spread().terms() - 1));
    return error * std::exp(.5 * boost::math::quantile(student, .95) * spread);
}

}  // namespace tyndall
