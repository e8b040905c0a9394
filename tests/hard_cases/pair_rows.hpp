#pragma once
/// Rows 24 and 28-30: whole connections, scale, and lights that start at or point at the camera.
#include "tests/hard_cases/rod_rows.hpp"
#include "tests/support/quadrature.hpp"

namespace tyndall::test {

template <class Real>
HardRow<Real> row24()
{
    HardRow<Real> row;
    CaseRandom random(124);
    for (const double scale : {1e-18, 1e-15, 1e15, 1e18})
        for (int i = 0; i < 50; ++i) {
            const Big3 a = random.direction(), b = unit(Big(random.uniform(-1, 1)) * a + random.orthogonal(a));
            const Big3 q = Big(scale) * (Big(random.uniform(.5, 2)) * random.orthogonal(a) + Big(random.uniform(-1, 1)) * a);
            row.cases.push_back(rod_case<Real>("scale " + std::to_string(std::log10(scale)), q, a, b, Big(scale * random.uniform(.5, 1.5)), random.xi<Real>(), {8, 10, true}));
        }
    return row;
}

/// Anything finite and non-negative, with v and u on their segments: what a degenerate pair must at least be.
template <class Real>
HardCase<Real> finite_pair(std::string name, const std::array<Real, 14>& in)
{
    HardCase<Real> c{std::move(name), SAMPLER_PAIR, in, {}};
    c.expected = {Interval{Big(0), Interval{}.high}, Interval{Big(0), Big(in[9])}, Interval{Big(0), Big(in[10])}, Interval{Big(1), Interval{}.high}};
    return c;
}

template <class Real>
HardRow<Real> row28()
{
    HardRow<Real> row;
    const Big3 a{Big(0), Big(0), Big(1)};
    for (const int sign : {1, -1})  // the light lies on the eye segment
        for (const double xi : {0., .25, .5, .999}) {
            auto in = pair_inputs<Real>({Big(0), Big(0), sign > 0 ? Big(0) : Big(1)}, a, Big(sign) * a, Big(1), Big(1));
            in[11] = Real(xi), in[12] = Real(1 - xi);
            row.cases.push_back(finite_pair<Real>("light on the eye segment", in));
        }
    for (const double xi : {0., .5}) {  // no length, no distance
        auto in = pair_inputs<Real>({Big(0), Big(0), Big(0)}, a, a, Big(0), Big(0));
        in[11] = in[12] = Real(xi);
        row.cases.push_back(finite_pair<Real>("two points that coincide", in));
        in[9] = Real(1);
        row.cases.push_back(finite_pair<Real>("eye segment without length", in));
        in[9] = Real(0), in[10] = Real(1);
        row.cases.push_back(finite_pair<Real>("light without length", in));
    }
    return row;
}

template <class Real>
HardRow<Real> row29()
{
    HardRow<Real> row;
    CaseRandom random(129);
    for (int i = 0; i < 100; ++i) {  // the light starts at the camera: E diverges, the floor cuts it at epsilon^2 length
        const Big3 a = random.direction(), b = unit(Big(random.uniform(-1, 1)) * a + random.orthogonal(a));
        auto in = pair_inputs<Real>({Big(0), Big(0), Big(0)}, a, b, Big(1.5), Big(2));
        in[11] = random.xi<Real>(), in[12] = random.xi<Real>();
        row.cases.push_back(finite_pair<Real>("light starts at the camera", in));
    }
    for (const double offset : {1e-2, 1e-4, 1e-6})  // q = offset along the light: h = 0, D0 = s offset
        for (int i = 0; i < 50; ++i) {
            const Big3 a = random.direction(), b = unit(Big(random.uniform(-1, 1)) * a + random.orthogonal(a));
            HardCase<Real> c = rod_case<Real>("light starts near the camera", Big(offset) * b, a, b, Big(1.5), random.xi<Real>(), {10, 30, false});
            row.cases.push_back(c);
        }
    return row;
}

template <class Real>
HardRow<Real> row30()
{
    HardRow<Real> row;
    CaseRandom random(130);
    for (const double theta : {1e-3, 1e-5, 1e-7})
        for (int i = 0; i < 50; ++i) {  // the light travels towards the camera, past it at the distance theta, at the angle theta
            const Big3 a = random.direction(), side = random.orthogonal(a);
            const Big3 b = unit(Big(theta) * side - a), q = Big(3) * a - Big(2 * theta) * side + Big(theta) * cross(a, side);
            auto in = pair_inputs<Real>(q, a, b, Big(2.5), Big(4));
            in[11] = random.xi<Real>(), in[12] = random.xi<Real>();
            row.cases.push_back(finite_pair<Real>("light points at the camera", in));
        }
    // Mean weight against the two-dimensional integral (inner one in closed form by long double atan2, outer by adaptive quadrature).
    for (const double theta : {.3, 1e-1, 1e-2}) {
        const auto in = pair_inputs<Real>({Big(-2 * theta), Big(theta), Big(3)}, {Big(0), Big(0), Big(1)},
                                          unit({Big(theta), Big(0), Big(-1)}), Big(2.5), Big(4));
        const auto inner = [&](long double v) {
            const long double x = in[0] + v * in[6], y = in[1] + v * in[7], z = in[2] + v * in[8], D = std::hypot(x, y);
            return std::atan2(D * in[10], D * D - z * (in[10] - z)) / D;
        };
        const long double truth = integrate(inner, 0, in[9], 1e-16L);
        // float: 8 epsilon for E Theta, and h = theta is off by 2 epsilon |q| = 6 epsilon, which moves E by 2 / s * 6 epsilon / theta.
        const Big shaken = 6 * Big(epsilon<Real>) / theta;
        row.integrals.push_back(mean_weight<Real>("light points at the camera", in, 64, Interval::relative(Big(truth), Big(1e-12) + 8 * Big(epsilon<Real>) + shaken)));
    }
    return row;
}

}  // namespace tyndall::test
