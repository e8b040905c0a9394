#pragma once
/// Rows 10-13 and 27: the conditional over the eye segment.
#include "tests/hard_cases/cases.hpp"

namespace tyndall::test {

/// Theta and R within 6 epsilon (cross product 2, adjacent side 2, quotient and arc tangent 2); u within 8 epsilon of the length.
template <class Real>
HardCase<Real> angle_case(std::string name, const Big3& p0, const Big3& a0, const Big& length0, Real xi)
{
    const Rounded3<Real> p(p0), a(a0);
    const Real length = static_cast<Real>(length0);
    const AngleOracle oracle(p.big(), a.big(), Big(length));
    HardCase<Real> c{std::move(name), SAMPLER_ANGLE};
    put(c.in, 0, p), put(c.in, 3, a);
    c.in[6] = length, c.in[7] = xi;
    const Big e(epsilon<Real>);
    c.expected[0] = Interval::around(clamp(oracle.position(Big(xi)), Big(0), oracle.S), 8 * e * oracle.S);
    c.expected[1] = Interval::relative(oracle.angle, 6 * e);
    c.expected[2] = Interval::relative(oracle.over_distance, 6 * e);
    c.expected[3] = Interval{Big(0), Big(1)};
    return c;
}

/// Point at the distance D from the line and `before` in front of the segment's start.
template <class Real>
HardRow<Real> angle_cases(unsigned seed, std::initializer_list<std::array<double, 3>> distance_before_length)
{
    HardRow<Real> row;
    CaseRandom random(seed);
    for (const auto& [D, before, length] : distance_before_length)
        for (int i = 0; i < 60; ++i) {
            // Axis-aligned: D keeps its digits however small it is (a rotated point cannot hold them).
            const int axis = i % 3;
            const double side = i % 2 ? 1 : -1, ahead = i % 4 < 2 || length > 1e10 ? -before : length + before;  // a point 1e15 away has no digits
            const std::array<double, 3> a{double(axis == 0), double(axis == 1), double(axis == 2)};
            std::array<double, 3> p{};
            p[axis] = ahead, p[(axis + 1) % 3] = side * D;
            row.cases.push_back(angle_case<Real>("D " + std::to_string(std::log10(D)) + " before " + std::to_string(before) + " length " + std::to_string(length),
                                                 {Big(p[0]), Big(p[1]), Big(p[2])}, {Big(a[0]), Big(a[1]), Big(a[2])}, Big(length), random.xi<Real>()));
        }
    return row;
}

template <class Real>
HardRow<Real> row10()
{
    HardRow<Real> row = angle_cases<Real>(110, {{1e-3, .5, 1}, {1e-5, .5, 1}, {1e-7, .5, 1}, {1e-3, .01, 1}, {1e-5, .1, 10}});
    HardRow<Real> tiny = angle_cases<Real>(1101, {{1e-20, .5, 1}, {0, .5, 1}});
    for (HardCase<Real>& c : tiny.cases) {
        // Under the guard epsilon^2 |p| only Theta / D means something; it and u must be those of D = 0. Theta is between 0 and that of the guard.
        if (Real guard = epsilon<Real> * epsilon<Real>; Real(1e-20) < guard || c.name.find("inf") != std::string::npos)
            c.expected[1] = Interval{Big(0), Big(8 * guard)};
        row.cases.push_back(c);
    }
    CaseRandom random(1102);
    for (int i = 0; i < 200; ++i) {  // any orientation, D from 1e-6 to 1
        const Big3 a = Rounded3<Real>(random.direction()).big();
        const Big3 p = Big(random.log_uniform(1e-6, 1)) * random.orthogonal(a) - Big(random.uniform(.1, 2)) * a;
        row.cases.push_back(angle_case<Real>("any orientation", p, a, Big(random.log_uniform(.01, 100)), random.xi<Real>()));
    }
    return row;
}

template <class Real>
HardRow<Real> row11()
{
    return angle_cases<Real>(111, {{1, 10, .01}, {1, 1e3, .01}, {1, 1e5, .01}, {.01, 10, .01}, {1e-3, 1e3, .01}, {.1, 1e5, 1e-4}, {1, .01, 100}, {1, .01, 1e4}});
}

template <class Real>
HardRow<Real> row12()
{
    HardRow<Real> row = angle_cases<Real>(112, {{1, -.5, 1e15}, {1, .5, 1e15}, {1e-3, .5, 1e15}, {1e4, -1e3, 1e19}});
    for (HardCase<Real>& c : row.cases) c.expected[0] = Interval{Big(0), Big(c.in[6])};  // u / length has no digits to compare; see below
    CaseRandom random(1121);
    for (const double length : {1e15, std::numeric_limits<double>::infinity()})
        for (int i = 0; i < 100; ++i) {
            const double D = random.log_uniform(.01, 1), t0 = random.uniform(-1, 1);
            const Real xi = random.xi<Real>() * Real(.5);
            HardCase<Real> c = angle_case<Real>("half-line", {Big(D), Big(0), Big(-t0)}, {Big(0), Big(0), Big(1)}, Big(1e15), xi);
            c.in[6] = static_cast<Real>(length);
            // xi <= 1/2: u = D tan(psi0 + psi) - t0, off by at most epsilon (6 |t0| + 16 r^2 / D) with r = |y - x(u)| (rounding of psi).
            const Big start(c.in[2]), distance(c.in[0]), angle = atan2(distance, Big(-start)), psi = Big(xi) * angle;
            const Big u = distance * tan(Big(psi + atan2(Big(-start), distance))) + start, r2 = distance * distance + (u - start) * (u - start);
            const Big e(epsilon<Real>);
            c.expected[0] = Interval::around(u, e * (6 * abs(start) + 16 * r2 / distance) + 1e-14 * abs(u));
            c.expected[1] = Interval::relative(angle, 6 * e + 1e-12), c.expected[2] = Interval::relative(angle / distance, 6 * e + 1e-12);
            row.cases.push_back(c);
        }
    return row;
}

template <class Real>
HardRow<Real> row13()
{
    HardRow<Real> row;
    const Real pi = static_cast<Real>(boost::math::constants::pi<Big>());
    for (const double D : {1e-3, 1e-6, 1e-20, 0.})
        for (const double xi : {0., .25, .5, .75, 1 - 0x1p-24}) {
            HardCase<Real> c{"foot inside, D " + std::to_string(D), SAMPLER_ANGLE, {}, {}};
            c.in[0] = Real(D), c.in[2] = Real(.25), c.in[5] = Real(1), c.in[6] = Real(1), c.in[7] = Real(xi);
            c.expected[0] = Interval{Big(0), Big(1)};
            c.expected[1] = Interval{Big(D < 1e-5 ? -Real(1e-5) + pi * (1 - 4 * epsilon<Real>) : Real(3.13)), Big(pi) * (1 + Big(epsilon<Real>))};
            c.expected[2] = Interval{Big(1), Interval{}.high};
            row.cases.push_back(c);
        }
    return row;
}

template <class Real>
HardRow<Real> row27()
{
    HardRow<Real> row;
    CaseRandom random(127);
    for (const Real xi : {Real(0), last_xi<Real>})
        for (int i = 0; i < 50; ++i) {
            const Big3 a = random.direction(), p = Big(random.uniform(.1, 2)) * random.direction();
            HardCase<Real> c = angle_case<Real>("end point", p, a, Big(random.uniform(.5, 2)), xi);
            // u may be off by its usual bound, but not beyond the end.
            if (xi == 0) c.expected[0] = Interval{Big(0), 8 * Big(epsilon<Real>)};
            else c.expected[0].high = Big(c.in[6]);
            row.cases.push_back(c);
        }
    return row;
}

}  // namespace tyndall::test
