#pragma once
/// Sobol points in nine dimensions, scrambled: numbers that fill the first draws of many paths more evenly than independent ones.
#include <array>
#include <cstdint>

#include "transport/random_sequence.hpp"

namespace tyndall {

inline constexpr std::size_t sobol_dimensions = 9;

namespace sobol_detail {

/// Degree, inner coefficients and first direction numbers of the primitive polynomials of dimensions 2 ... 9 [Joe and Kuo 2008, table new-joe-kuo-6].
struct Polynomial {
    unsigned degree, coefficients;
    std::array<std::uint32_t, 5> first;
};
inline constexpr std::array<Polynomial, sobol_dimensions - 1> polynomials{{{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}, {3, 2, {1, 1, 1}}, {4, 1, {1, 1, 3, 3}}, {4, 4, {1, 3, 5, 13}},
                                                                            {5, 2, {1, 1, 5, 5, 17}}, {5, 4, {1, 1, 5, 5, 5}}}};

using Matrix = std::array<std::uint32_t, 32>;

constexpr Matrix directions(const Polynomial& p)
{
    Matrix v{};
    for (unsigned i = 0; i < 32; ++i) {
        if (i < p.degree) {
            v[i] = p.first[i] << (31 - i);
            continue;
        }
        v[i] = v[i - p.degree] ^ (v[i - p.degree] >> p.degree);
        for (unsigned k = 1; k < p.degree; ++k)
            if (p.coefficients >> (p.degree - 1 - k) & 1) v[i] ^= v[i - k];
    }
    return v;
}

constexpr std::array<Matrix, sobol_dimensions> all_directions()
{
    std::array<Matrix, sobol_dimensions> all{};
    for (unsigned i = 0; i < 32; ++i) all[0][i] = 1u << (31 - i);
    for (std::size_t d = 1; d < sobol_dimensions; ++d) all[d] = directions(polynomials[d - 1]);
    return all;
}
inline constexpr auto matrices = all_directions();

constexpr std::uint32_t reversed(std::uint32_t x)
{
    x = (x >> 16) | (x << 16);
    x = (x & 0x00ff00ffu) << 8 | (x & 0xff00ff00u) >> 8;
    x = (x & 0x0f0f0f0fu) << 4 | (x & 0xf0f0f0f0u) >> 4;
    x = (x & 0x33333333u) << 2 | (x & 0xccccccccu) >> 2;
    return (x & 0x55555555u) << 1 | (x & 0xaaaaaaaau) >> 1;
}

}  // namespace sobol_detail

/// Coordinate `dimension` < sobol_dimensions of point `index`, as a fraction of 2^32.
constexpr std::uint32_t sobol(std::uint32_t index, std::size_t dimension)
{
    std::uint32_t x = 0;
    for (unsigned bit = 0; index != 0; index >>= 1, ++bit)
        if (index & 1) x ^= sobol_detail::matrices[dimension][bit];
    return x;
}

/// Nested uniform scrambling [Owen 1995] by a hash whose every bit depends on the lower ones only, applied to the bits in reverse [Laine and Karras 2011; Burley 2020,
/// listing 2]. For a random key the result is uniform whatever x is, because the key is added first and the rest is a bijection.
constexpr std::uint32_t scrambled(std::uint32_t x, std::uint32_t key)
{
    x = sobol_detail::reversed(x) + key;
    for (const std::uint32_t factor : {0x6c50b47cu, 0xb82f1e52u, 0xc7afe638u, 0x8d22f6e6u}) x ^= x * factor;
    return sobol_detail::reversed(x);
}

/// The numbers of one of many paths: the first nine from the scrambled Sobol point of its index, the others independent. Every number is uniform by itself, so every
/// path's expected value is that of a RandomSequence; numbers of different (seed, pass, stream) are independent.
class EvenSequence {
public:
    EvenSequence(std::uint64_t seed, std::uint64_t pass, RandomStream stream, std::uint64_t index, bool even)
        : independent_(seed, pass, stream, index), key_(mix_bits(mix_bits(mix_bits(seed) ^ pass) + static_cast<std::uint64_t>(stream))), index_(static_cast<std::uint32_t>(index)), even_(even)
    {
    }

    /// In [0, 1), 53 bits.
    double next()
    {
        const double own = independent_.next();
        if (!even_ || dimension_ == sobol_dimensions) return own;
        const auto key = static_cast<std::uint32_t>(mix_bits(key_ + dimension_ + 1) >> 32);
        return (scrambled(sobol(index_, dimension_++), key) + own) * 0x1p-32;
    }
    Vec2 next2() { const double x = next(); return {x, next()}; }

private:
    RandomSequence independent_;
    std::uint64_t key_;
    std::uint32_t index_;
    bool even_;
    std::size_t dimension_ = 0;
};

}  // namespace tyndall
