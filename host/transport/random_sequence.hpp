#pragma once
/// Random numbers as a pure function of (seed, pass, stream, index, dimension): no state survives a path, so threads and order do not matter.
#include <cstdint>

#include "scene/vector.hpp"

namespace tyndall {

/// Which part of the renderer draws; keeps their numbers independent.
enum class RandomStream : std::uint32_t { light_path = 1, camera = 2, path = 3, single = 4, pairs = 5, pilot = 6 };

class RandomSequence {
public:
    RandomSequence(std::uint64_t seed, std::uint64_t pass, RandomStream stream, std::uint64_t index);
    /// The next number, in [0, 1), 53 bits.
    double next();
    Vec2 next2() { const double x = next(); return {x, next()}; }

private:
    std::uint64_t key_, counter_ = 0;
};

/// 64 -> 64 bit finaliser (SplitMix64, [Steele et al. 2014]).
constexpr std::uint64_t mix_bits(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

inline RandomSequence::RandomSequence(std::uint64_t seed, std::uint64_t pass, RandomStream stream, std::uint64_t index)
    : key_(mix_bits(mix_bits(mix_bits(seed) ^ pass) + static_cast<std::uint64_t>(stream)) ^ index)
{
    key_ = mix_bits(key_);
}

inline double RandomSequence::next() { return static_cast<double>(mix_bits(key_ + 0x9e3779b97f4a7c15ull * ++counter_) >> 11) * 0x1p-53; }

}  // namespace tyndall
