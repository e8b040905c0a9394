#include "film/tone_map.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tyndall {
namespace {

constexpr double knee = .8;
constexpr double percentile = .95, percentile_value = .7;

double shoulder(double value) { return value <= knee ? value : knee + (1 - knee) * -std::expm1(-(value - knee) / (1 - knee)); }

double srgb(double linear) { return linear <= .0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - .055; }

double luminance(const Rgb& rgb) { return glm::dot(rgb, Rgb(.2126, .7152, .0722)); }

}  // namespace

double automatic_exposure(std::span<const Rgb> image)
{
    std::vector<double> lit;
    for (const auto& pixel : image)
        if (const double value = luminance(pixel); value > 0 && std::isfinite(value)) lit.push_back(value);
    if (lit.empty()) return 0;
    const auto nth = lit.begin() + static_cast<std::ptrdiff_t>(percentile * static_cast<double>(lit.size() - 1));
    std::nth_element(lit.begin(), nth, lit.end());
    return std::log2(percentile_value / *nth);
}

std::array<std::uint8_t, 3> tone_map(const Rgb& radiance, double exposure)
{
    const double scale = std::exp2(exposure);
    std::array<std::uint8_t, 3> pixel{};
    for (int c = 0; c < 3; ++c)
        if (const double value = scale * radiance[c]; value > 0)
            pixel[c] = static_cast<std::uint8_t>(std::lround(255 * srgb(shoulder(value))));
    return pixel;
}

}  // namespace tyndall
