#include "comparison/page_image.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "film/png.hpp"

namespace tyndall {
namespace {

int exponent_of(std::span<const Rgb> image)
{
    constexpr int wanted = 15;  // frexp's exponent of a value in [2^14, 2^15)
    double largest = 0;
    for (const Rgb& pixel : image)
        for (int c = 0; c < 3; ++c)
            if (std::isfinite(pixel[c])) largest = std::max(largest, std::abs(pixel[c]));
    int exponent = 0;
    std::frexp(largest, &exponent);
    return largest > 0 ? exponent - wanted : 0;
}

}  // namespace

std::uint16_t short_half(double value)
{
    constexpr int significant = 8, smallest_exponent = -13;  // frexp's, of the smallest normal number 2^-14
    if (!std::isfinite(value) || value == 0) return 0;
    const std::uint16_t sign = std::signbit(value) ? 0x8000 : 0;
    int exponent = 0;
    std::frexp(value, &exponent);
    const double step = std::ldexp(1., std::max(exponent - significant, smallest_exponent - 11));
    const double rounded = std::min(std::nearbyint(std::abs(value) / step) * step, 65504.);
    std::frexp(rounded, &exponent);
    if (exponent < smallest_exponent) return static_cast<std::uint16_t>(sign | static_cast<std::uint16_t>(std::ldexp(rounded, 24)));
    const auto mantissa = static_cast<std::uint16_t>(std::ldexp(rounded, 11 - exponent));  // 1024 to 2047
    return static_cast<std::uint16_t>(sign | ((exponent + 14) << 10) | (mantissa & 0x3ff));
}

std::string base64(std::string_view bytes)
{
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(bytes.size() - i, 3);
        std::uint32_t group = 0;
        for (std::size_t b = 0; b < 3; ++b) group = group << 8 | (b < count ? static_cast<unsigned char>(bytes[i + b]) : 0u);
        for (std::size_t d = 0; d < 4; ++d) text += d <= count ? digits[group >> (18 - 6 * d) & 63] : '=';
    }
    return text;
}

PageImage page_image(std::span<const Rgb> image, int width)
{
    assert(width > 0 && !image.empty() && image.size() % static_cast<std::size_t>(width) == 0);
    PageImage result{.exponent = exponent_of(image)};
    const double scale = std::ldexp(1., -result.exponent);
    std::vector<std::uint8_t> bytes(6 * image.size());
    for (std::size_t i = 0; i < image.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint16_t bits = short_half(scale * image[i][static_cast<int>(c)]);
            bytes[3 * i + c] = static_cast<std::uint8_t>(bits >> 8), bytes[3 * (image.size() + i) + c] = static_cast<std::uint8_t>(bits & 0xff);
        }
    const int height = static_cast<int>(image.size() / static_cast<std::size_t>(width));
    result.uri = "data:image/png;base64," + base64(encode_png(bytes, width, 2 * height, "page"));
    return result;
}

}  // namespace tyndall
