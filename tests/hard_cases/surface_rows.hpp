#pragma once
/// Rows 38 and 39: a light that shines on a surface.
#include "tests/hard_cases/cases.hpp"

namespace tyndall::test {

/// Visible part, integral and inverse of one light, in 50 digits.
struct SurfaceOracle {
    Big3 p, b, n;
    Big start, end, total;

    SurfaceOracle(const Big3& p_, const Big3& b_, const Big& length, const Big3& n_) : p(p_), b(unit(b_)), n(n_), start(0), end(length)
    {
        const Big height = dot(n, p), slope = dot(n, b);
        if (slope > 0) start = clamp(-height / slope, Big(0), length);
        if (slope < 0) end = clamp(-height / slope, Big(0), length);
        total = end > start && height + (start + end) / 2 * slope > 0 ? Big(primitive(end) - primitive(start)) : Big(0);
    }
    Big primitive(const Big& v) const { return surface_primitive(p, b, n, v); }
    /// By bisection: it knows nothing of the closed inverse.
    Big position(const Big& xi) const
    {
        Big low = start, high = end, zero = primitive(start);
        for (int i = 0; i < 120; ++i) {
            const Big middle = (low + high) / 2;
            (primitive(middle) - zero < xi * total ? low : high) = middle;
        }
        return low;
    }
};

template <class Real>
HardCase<Real> surface_case(std::string name, const Big3& p0, const Big3& b0, double length0, const Big3& n0, Real xi, const Big& slack = 1)
{
    const Rounded3<Real> p(p0), b(b0), n(n0);
    HardCase<Real> c{std::move(name), SAMPLER_SURFACE};
    put(c.in, 0, p), put(c.in, 3, b), put(c.in, 7, n);
    c.in[6] = Real(length0), c.in[10] = xi;
    const SurfaceOracle oracle(p.big(), b.big(), Big(c.in[6]), n.big());
    const Big e(epsilon<Real>), L(c.in[6]);
    if (oracle.total == 0) {
        c.expected = {Interval{Big(0), L}, Interval{Big(0), Big(0)}, Interval{Big(0), Big(0)}, Interval{Big(0), Big(1)}};
        return c;
    }
    c.expected[0] = Interval::around(oracle.position(Big(xi)), 6 * e * slack * L);
    c.expected[1] = Interval::relative(oracle.total, 8 * e * slack);
    c.expected[3] = Interval{Big(0), Big(1)};
    return c;
}

template <class Real>
HardRow<Real> row38()
{
    HardRow<Real> row;
    CaseRandom random(138);
    for (int i = 0; i < 300; ++i) {  // the light crosses the horizon: n . p and n . b of opposite signs
        const Big3 n = random.direction(), side = random.orthogonal(n);
        const int sign = i % 2 ? 1 : -1;
        const Big height(sign * random.uniform(.2, 1)), slope(-sign * random.uniform(.3, .9));
        const Big3 p = height * n + Big(random.uniform(.2, 1)) * random.orthogonal(n);
        const Big3 b = slope * n + sqrt(Big(1 - slope * slope)) * side;
        // The horizon is at -height / slope: both rounded to epsilon |p|, so the visible length is off by 4 epsilon |p| / |slope|; |p| < 1.5.
        row.cases.push_back(surface_case<Real>("crosses the horizon", p, b, 4, n, random.xi<Real>(), Big(16)));
    }
    for (int i = 0; i < 50; ++i) {  // wholly below: weight exactly 0
        const Big3 n = random.direction(), side = random.orthogonal(n);
        row.cases.push_back(surface_case<Real>("below the horizon", Big(random.uniform(-1, -.1)) * n + side, side, 1.5, n, random.xi<Real>()));
    }
    for (int i = 0; i < 100; ++i) {  // grazing: the whole light within 1e-3 rad above the horizon
        const Big3 n = random.direction(), side = random.orthogonal(n);
        row.cases.push_back(surface_case<Real>("grazing", Big(1e-3) * n + Big(random.uniform(.5, 1)) * side, unit(cross(n, side) + Big(1e-4) * n), 1.5, n,
                                               random.xi<Real>(), Big(1e3)));  // cosine 1e-3 is off by epsilon |p|
    }
    return row;
}

template <class Real>
HardRow<Real> row39()
{
    HardRow<Real> row;
    CaseRandom random(139);
    for (const auto& [length, distance] : {std::pair{.01, 10.}, {1e-3, 100.}, {1e-4, 1e3}, {1., 1.}, {10., .1}})
        for (int i = 0; i < 60; ++i) {
            const Big3 n = random.direction(), towards = unit(n + Big(random.uniform(0, 1)) * random.orthogonal(n));
            const Big3 b = random.direction();
            // Lights that stay well above the horizon, so that the cosines are not differences of rounded numbers.
            if (distance < 2 * length && dot(n, b) < 0) continue;
            row.cases.push_back(surface_case<Real>("length " + std::to_string(length) + " at " + std::to_string(distance), Big(distance) * towards, b, length, n,
                                                   random.xi<Real>(), Big(2)));
        }
    for (const double D : {1e-2, 1e-4, 1e-6, 1e-12, 0.})
        for (int i = 0; i < 40; ++i) {  // seen nearly end on: D -> 0 with the foot outside, both ways
            const double away = random.uniform(.2, 1);
            const bool towards = i % 2;
            const Big3 p{Big(D), Big(0), Big(towards ? away + 1.5 : away)}, b{Big(0), Big(0), Big(towards ? -1 : 1)};
            row.cases.push_back(surface_case<Real>("end on, D " + std::to_string(D), p, b, 1.5, {Big(0), Big(.6), Big(.8)}, random.xi<Real>(), Big(2)));
        }
    return row;
}

}  // namespace tyndall::test
