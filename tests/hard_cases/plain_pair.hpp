#pragma once
/// A light and an eye segment in long double, from the float inputs of a pair, and what is true of them: oracles without the kernels' code.
#include <array>
#include <cmath>

#include "tests/support/quadrature.hpp"

namespace tyndall::test {

struct PlainPair {
    using Vector = std::array<long double, 3>;
    Vector q, a, b;
    long double light, eye;

    explicit PlainPair(const std::array<float, 14>& in) : q{in[0], in[1], in[2]}, a{in[3], in[4], in[5]}, b{in[6], in[7], in[8]}, light(in[9]), eye(in[10]) {}

    Vector at(long double v) const { return {q[0] + v * b[0], q[1] + v * b[1], q[2] + v * b[2]}; }
    static long double dot(const Vector& x, const Vector& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
    static Vector cross(const Vector& x, const Vector& y) { return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]}; }
    /// Of the point v of the light to the infinite eye line.
    long double distance(long double v) const
    {
        const Vector m = cross(at(v), a);
        return std::sqrt(dot(m, m));
    }
    /// Integral of du / w^2 over the eye segment, seen from v.
    long double from(long double v) const
    {
        const long double D = distance(v), t0 = -dot(at(v), a);
        return std::atan2(D * eye, D * D + t0 * (eye + t0)) / D;
    }
    /// Integral of dv du / w^2.
    long double transport() const { return integrate([&](long double v) { return from(v); }, 0, light, 1e-12L); }
    /// Integral of dv / D(v).
    long double potential() const { return integrate([&](long double v) { return 1 / distance(v); }, 0, light, 1e-12L); }
};

}  // namespace tyndall::test
