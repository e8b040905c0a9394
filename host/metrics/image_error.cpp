#include "metrics/image_error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numeric>

#include "film/error_estimate.hpp"

namespace tyndall {
namespace {

double mean_of_values(std::span<const Rgb> image)
{
    double total = 0;
    for (const Rgb& pixel : image) total += sum(pixel);
    return total / (3. * static_cast<double>(image.size()));
}

double root_mean_square(std::span<const Rgb> image, std::span<const Rgb> reference)
{
    double total = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const Rgb difference = image[i] - reference[i];
        total += glm::dot(difference, difference);
    }
    return std::sqrt(total / (3. * static_cast<double>(image.size())));
}

}  // namespace

ImageError image_error(std::span<const Rgb> image, std::span<const Rgb> reference)
{
    assert(image.size() == reference.size() && !image.empty());
    ImageError error{.rmse = root_mean_square(image, reference), .mean = mean_of_values(image), .reference_mean = mean_of_values(reference)};
    error.relative_mse = relative_mse(image, reference);
    std::vector<double> terms = relative_squared_errors(image, reference);
    const auto worst = static_cast<std::size_t>(std::ranges::max_element(terms) - terms.begin());
    error.worst_pixel = worst / 3;
    error.worst_difference = image[worst / 3][static_cast<int>(worst % 3)] - reference[worst / 3][static_cast<int>(worst % 3)];
    const std::size_t thousandth = terms.size() / 1000, largest = std::max<std::size_t>(thousandth, 1);
    std::ranges::nth_element(terms, terms.begin() + static_cast<std::ptrdiff_t>(largest), std::greater<>());
    const auto rest = terms.begin() + static_cast<std::ptrdiff_t>(largest);
    const double of_largest = std::accumulate(terms.begin(), rest, 0.), of_rest = std::accumulate(rest, terms.end(), 0.);
    const double kept = thousandth ? of_rest : of_rest + of_largest;
    error.trimmed_relative_mse = kept / static_cast<double>(terms.size() - thousandth);
    error.share_of_largest = of_largest + of_rest > 0 ? of_largest / (of_largest + of_rest) : 0;
    return error;
}

}  // namespace tyndall
