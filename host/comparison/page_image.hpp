#pragma once
/// Images inside a page: small, exact enough for maps of differences, readable by any browser without a network.
#include <span>
#include <string>

#include "scene/vector.hpp"

namespace tyndall {

/// A PNG of 8-bit RGB, as a data URI. Its upper half holds the high bytes, its lower half the low bytes of 16-bit floats (IEEE binary16, rounded to 8 significant bits: within .2 %,
/// because the rest is noise that no compression takes away). A value is 2^exponent times its float; smaller than 2^-24 of that is 0, larger than 65504 is 65504.
struct PageImage {
    std::string uri;
    int exponent = 0;  ///< chosen so that the largest value is between 2^14 and 2^15 in the floats
};

/// `image`: row-major, top row first, not empty; values that are not finite become 0.
PageImage page_image(std::span<const Rgb> image, int width);

/// binary16 nearest to `value` among those of 8 significant bits, as its bits; subnormal numbers keep the bits that they have.
std::uint16_t short_half(double value);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace tyndall
