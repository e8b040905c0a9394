#pragma once
/// The error of an image, defined once: bench, report, progress, documentation and compare use these functions.
///
///   relMSE = mean over pixels and channels of (x - ref)^2 / (ref^2 + e),   e = (.05 mean of ref)^2
///
/// and "the error" is its square root: .01 reads as one percent. Where there is no reference, the expectation of (x - ref)^2 is the
/// variance of the mean and the image's own values stand for ref. This holds however the noise is correlated between pixels.
#include <functional>
#include <span>
#include <vector>

#include "film/film.hpp"

namespace tyndall {

/// relMSE of `image` against `reference` (same size, not empty). Two black images have error 0; light where the whole reference is black
/// gives infinity.
double relative_mse(std::span<const Rgb> image, std::span<const Rgb> reference);

/// Its terms (x - ref)^2 / (ref^2 + e), red, green and blue of each pixel in turn: their mean is `relative_mse` up to rounding.
std::vector<double> relative_squared_errors(std::span<const Rgb> image, std::span<const Rgb> reference);

/// The same from squared errors and reference as functions of the pixel; a term 0 / 0, nothing expected and nothing there, is 0.
double mean_of_relative_terms(std::size_t pixels, const std::function<Rgb(std::size_t)>& squared_error, const std::function<Rgb(std::size_t)>& reference);

/// Expected relMSE of an image whose pixels have these variances, with its own values for the reference.
double expected_relative_mse(std::span<const Rgb> image, std::span<const Rgb> variance_of_mean);

/// sqrt(expected relMSE) of the film's beauty; negative below two passes: unknown.
double estimated_error(const Film& film);

/// The same of one layer, from the deviations of its passes (film/layer_deviation.hpp), relative to the layer itself.
double estimated_error(const Film& film, Layer layer);

/// What the error is below with a confidence of 95 % (one-sided): estimated_error x exp(t s / 2), s the relative standard error of relMSE between passes, t
/// Student's quantile; on a logarithmic scale, because estimates of variance are skewed. Infinity below `pilot_passes`: fewer say too little of their own spread.
double error_upper_bound(const Film& film);

/// Passes before a target error may stop a render, so that luck does not.
inline constexpr int pilot_passes = 8;

}  // namespace tyndall
