#include "bench/variance_pairs.hpp"

#include <numbers>
#include <random>

namespace tyndall::bench {
namespace {

using maths_double::real3;

struct Numbers {
    std::mt19937 engine;
    double next() { return (engine() + .5) * 0x1p-32; }
    real3 point()
    {
        const double x = next(), y = next();
        return {x, y, next()};
    }
    real3 direction()
    {
        const double z = 2 * next() - 1, turn = 2 * std::numbers::pi * next(), across = std::sqrt(1 - z * z);
        return {across * std::cos(turn), across * std::sin(turn), z};
    }
};

}  // namespace

std::vector<VariancePair> variance_pairs(std::uint32_t seed, int count)
{
    std::vector<VariancePair> pairs;
    Numbers numbers{std::mt19937(seed)};
    for (int i = 0; i < count; ++i) {
        const real3 o = numbers.point(), a = numbers.direction(), p = numbers.point(), b = numbers.direction();
        const double eye_length = numbers.next();
        pairs.push_back({maths_double::sub3(p, o), a, b, eye_length, numbers.next()});
    }
    return pairs;
}

}  // namespace tyndall::bench
