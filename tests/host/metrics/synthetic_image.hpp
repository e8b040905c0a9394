#pragma once
/// Small images out of arithmetic, the same to the last bit in any language with doubles and 64-bit integers.
#include <cstdint>
#include <vector>

#include "scene/vector.hpp"

namespace tyndall::test {

/// splitmix64's finaliser.
inline std::uint64_t mixed(std::uint64_t z)
{
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// Uniform in [-.5, .5).
inline double noise(std::uint64_t n) { return static_cast<double>(mixed(n) >> 11) * 0x1p-53 - .5; }

inline constexpr int image_width = 28, image_height = 20;  // not multiples of a block: four rows and columns are left out

/// A dark block at the top left, a ramp elsewhere.
inline double base(int x, int y, int c) { return x < 8 && y < 8 ? .001 : (1 + x * .125 + y * .0625) * (c + 1) * .25; }

template <class Value>
std::vector<Rgb> image_of(Value&& value)
{
    std::vector<Rgb> image(image_width * image_height);
    for (int y = 0; y < image_height; ++y)
        for (int x = 0; x < image_width; ++x)
            for (int c = 0; c < 3; ++c)
                image[static_cast<std::size_t>(y * image_width + x)][c] = value(x, y, c, static_cast<std::uint64_t>((y * image_width + x) * 3 + c));
    return image;
}

/// Pixel noise, and noise that all pixels share, as with shared virtual lights.
inline std::vector<Rgb> noisy_render(std::uint64_t run, double scale)
{
    return image_of([&](int x, int y, int c, std::uint64_t n) {
        return base(x, y, c) * (scale * (1 + .2 * noise(run * 1000000 + n) + .05 * noise(900000000 + run)));
    });
}

inline std::vector<Rgb> reference_image()
{
    return image_of([](int x, int y, int c, std::uint64_t n) { return base(x, y, c) * (1 + .01 * noise(500000000 + n)); });
}

}  // namespace tyndall::test
