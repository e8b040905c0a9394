#pragma once
/// What a row of hard cases is: inputs rounded to the precision under test, and the interval that each output must lie in.
#include <array>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "selftest/evaluate.hpp"
#include "tests/hard_cases/oracle.hpp"

namespace tyndall::test {

/// low <= output <= high, which NaN is not. Everything finite by default.
struct Interval {
    Big low = -Big(std::numeric_limits<double>::max()), high = Big(std::numeric_limits<double>::max());
    std::optional<Big> value{};  ///< what the output would be without any rounding, where one value is right

    static Interval around(const Big& value, const Big& tolerance) { return {value - tolerance, value + tolerance, value}; }
    static Interval relative(const Big& value, const Big& tolerance) { return around(value, abs(value) * tolerance); }
    bool holds(const Big& x) const { return low <= x && x <= high; }
};

template <class Real>
struct HardCase {
    std::string name;
    unsigned sampler = 0;
    std::array<Real, 14> in{};
    std::array<Interval, 4> expected{};
};

/// sum of weight[i] * output `output` of the inputs in[i]: a quadrature over xi.
template <class Real>
struct HardIntegral {
    std::string name;
    unsigned sampler = 0, output = 0;
    std::vector<std::array<Real, 14>> in;
    std::vector<Big> weight;
    Interval expected{};
    unsigned panels = 0;  ///< nodes: as in host/selftest/golden.hpp
};

template <class Real>
struct HardRow {
    std::vector<HardCase<Real>> cases;
    std::vector<HardIntegral<Real>> integrals;
};

template <class Real>
constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

/// Largest xi that a generator returns: the same 24 bits in both precisions.
template <class Real>
constexpr Real last_xi = Real(0x1.fffffep-1);

/// Inputs, with rounding to Real and back to what the oracle sees.
template <class Real>
struct Rounded3 {
    Real x, y, z;
    Rounded3(const Big3& a) : x(static_cast<Real>(a.x)), y(static_cast<Real>(a.y)), z(static_cast<Real>(a.z)) {}
    Big3 big() const { return {Big(x), Big(y), Big(z)}; }
};

template <class Real>
void put(std::array<Real, 14>& in, std::size_t first, const Rounded3<Real>& a)
{
    in[first] = a.x, in[first + 1] = a.y, in[first + 2] = a.z;
}

/// Fixed seed: a row is the same table in every run.
struct CaseRandom {
    std::mt19937_64 engine;
    explicit CaseRandom(unsigned seed) : engine(seed) {}
    double uniform(double a, double b) { return a + (b - a) * double(engine() >> 11) * 0x1p-53; }
    double log_uniform(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }
    template <class Real>
    Real xi() { return Real(double(engine() >> 40) * 0x1p-24); }
    Big3 direction()
    {
        for (;;) {
            const Big3 d{Big(uniform(-1, 1)), Big(uniform(-1, 1)), Big(uniform(-1, 1))};
            if (const Big n = dot(d, d); n < 1 && n > .01) return unit(d);
        }
    }
    /// Unit vector orthogonal to the unit vector a.
    Big3 orthogonal(const Big3& a)
    {
        for (;;) {
            const Big3 d = direction(), e = d - dot(d, a) * a;
            if (dot(e, e) > .01) return unit(e);
        }
    }
};

}  // namespace tyndall::test
