#pragma once
/// From linear radiance to a picture for the eye.
///
///   v = 2^exposure * radiance                                            linear, per channel
///   s = v                                       for v <= k = .8
///   s = k + (1 - k) (1 - exp(-(v - k)/(1 - k)))  for v > k                 a soft shoulder: same value and slope at k, 1 for bright light
///   p = round(255 * sRGB(s)),  sRGB(s) = 12.92 s below .0031308, else 1.055 s^(1/2.4) - .055
///
/// The shoulder works per channel, so bright coloured light bleaches towards white. Negative values and NaN show as black.
#include <array>
#include <cstdint>
#include <span>

#include "scene/vector.hpp"

namespace tyndall {

/// The exposure, in stops, that brings the 95th percentile of the luminance (Rec. 709) of all pixels that are not black to .7;
/// 0 for a black image.
double automatic_exposure(std::span<const Rgb> image);

/// The 8-bit sRGB pixel of a radiance.
std::array<std::uint8_t, 3> tone_map(const Rgb& radiance, double exposure);

}  // namespace tyndall
