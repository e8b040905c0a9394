#pragma once
/// Rows 1-9, 24, 28-30: the marginal over a light, and whole connections.
#include "tests/hard_cases/cases.hpp"

namespace tyndall::test {

/// How far, in epsilons, potential and v may be off.
struct RodBounds {
    Big potential = 6, v = 5;
    bool conditioned = false;  ///< add what the rounding of q x a and b x a does to a light that nearly meets the line
};

/// One rod case with its oracle. Conditioning: D is off by 2 epsilon (D0 + D1), which changes E = int dv / D by at most
/// 2 epsilon (D0 + D1) int dv / D^2 <= 2 epsilon (D0 + D1) / nearest * min(4 / s, L / nearest), and v by that times D.
template <class Real>
HardCase<Real> rod_case(std::string name, const Big3& q0, const Big3& a0, const Big3& b0, const Big& length0, Real xi, RodBounds bounds = {})
{
    const Rounded3<Real> q(q0), a(a0), b(b0);
    const Real length = static_cast<Real>(length0);
    const RodOracle oracle(q.big(), a.big(), b.big(), Big(length));
    HardCase<Real> c{std::move(name), SAMPLER_ROD};
    put(c.in, 0, q), put(c.in, 3, a), put(c.in, 6, b);
    c.in[9] = length, c.in[10] = xi;
    const Big e(epsilon<Real>), near = oracle.nearest(), x0 = oracle.s == 0 ? Big(0) : Big(4 / oracle.s), x1 = oracle.L / near;
    const Big reach = oracle.s == 0 || x1 < x0 ? x1 : x0;
    const Big shaken = bounds.conditioned ? Big(2 * e * (oracle.D0 + oracle.D1) / near * reach) : Big(0);
    c.expected[0] = Interval::around(oracle.potential, bounds.potential * e * oracle.potential + shaken);
    const Big v_shaken = shaken * (oracle.D0 + oracle.D1);
    c.expected[1] = Interval::around(oracle.position(Big(xi)), bounds.v * e * oracle.L + v_shaken);
    const Big v_error = bounds.v * e + v_shaken / oracle.L;
    if (near > Big(8) * e * (abs(q.big().x) + abs(q.big().y) + abs(q.big().z))) c.expected[2] = {Big(1), Big(1)};
    // Round trip: xi moves by the density times the error of v.
    const Big density = oracle.L / (near * oracle.potential);
    c.expected[3] = Interval::around(Big(xi), 16 * e + 2 * v_error * density + shaken / oracle.potential);
    return c;
}

/// A light at a distance of .5 ... 2 from the line, whose direction makes the angle theta with it (anti-parallel if sign is -1).
template <class Real>
HardRow<Real> nearly_parallel(unsigned seed, int sign)
{
    HardRow<Real> row;
    CaseRandom random(seed);
    for (const double theta : {1e-2, 1e-3, 3e-4, 1e-4, 1e-6, 1e-7, 0.0})
        for (int i = 0; i < 100; ++i) {
            const Big3 a = random.direction(), across = random.orthogonal(a);
            const Big3 b = unit(Big(sign * std::cos(theta)) * a + Big(std::sin(theta)) * across);
            const Big3 q = Big(random.uniform(.5, 2)) * random.orthogonal(a) + Big(random.uniform(-1, 1)) * a;
            row.cases.push_back(rod_case<Real>("theta " + std::to_string(theta), q, a, b, Big(random.uniform(.5, 1.5)), random.xi<Real>()));
        }
    return row;
}

template <class Real>
HardRow<Real> row01() { return nearly_parallel<Real>(101, 1); }

template <class Real>
HardRow<Real> row02()
{
    HardRow<Real> row = nearly_parallel<Real>(102, -1);
    for (const int ulps : {-1, 0, 1}) {  // cosine -1 and its neighbours
        const Real c = Real(-1) + Real(ulps) * epsilon<Real>;
        row.cases.push_back(rod_case<Real>("cosine -1 and " + std::to_string(ulps) + " ulp", {Big(.3), Big(.8), Big(.1)}, {Big(0), Big(0), Big(1)},
                                           {Big(0), Big(0), Big(c)}, Big(1), Real(.375)));
    }
    return row;
}

/// Mean over xi of the weight of a pair, at xi of the eye segment .5: sum of Gauss nodes over xi times `output` (0: the weight).
template <class Real>
HardIntegral<Real> mean_weight(std::string name, std::array<Real, 14> in, unsigned panels, Interval expected)
{
    HardIntegral<Real> integral{std::move(name), SAMPLER_PAIR, 0, {}, {}, expected, panels};
    const std::array<double, 4> node{.86113631159405257522, .33998104358485626480, -.33998104358485626480, -.86113631159405257522};
    const std::array<double, 4> weight{.34785484513745385737, .65214515486254614263, .65214515486254614263, .34785484513745385737};
    for (unsigned panel = 0; panel < panels; ++panel)
        for (std::size_t k = 0; k < 4; ++k) {
            in[11] = Real((panel + .5 + .5 * node[k]) / panels), in[12] = Real(.5);
            integral.in.push_back(in);
            integral.weight.push_back(Big(weight[k]) / (2 * panels));
        }
    return integral;
}

template <class Real>
std::array<Real, 14> pair_inputs(const Big3& q, const Big3& a, const Big3& b, const Big& light, const Big& eye)
{
    std::array<Real, 14> in{};
    put(in, 0, Rounded3<Real>(q)), put(in, 3, Rounded3<Real>(a)), put(in, 6, Rounded3<Real>(b));
    in[9] = static_cast<Real>(light), in[10] = static_cast<Real>(eye);
    in[11] = in[12] = Real(.5);
    return in;
}

template <class Real>
HardRow<Real> row03()
{
    HardRow<Real> row;
    CaseRandom random(103);
    for (const int sign : {1, -1})
        for (int i = 0; i < 50; ++i) {
            const Big3 a = Rounded3<Real>(random.direction()).big(), b = Big(sign) * a;
            const Big3 q = Big(random.uniform(.5, 2)) * random.orthogonal(a) + Big(random.uniform(-1, 1)) * a;
            row.cases.push_back(rod_case<Real>("parallel", q, a, b, Big(random.uniform(.5, 1.5)), random.xi<Real>()));
        }
    // Exact values of both segments on the axis z: light from z = .25 to 1.25 at the distance .5, eye from 0 to 2. 6 + 2 epsilon: E, Theta and
    // their product; the quadrature is exact to 1e-15 (Theta is analytic within .5 of the segment; 64 panels of 4 nodes).
    for (const int sign : {1, -1}) {
        const Big start = sign > 0 ? Big(.25) : Big(1.25);
        const auto in = pair_inputs<Real>({Big(.3), Big(.4), start}, {Big(0), Big(0), Big(1)}, {Big(0), Big(0), Big(sign)}, Big(1), Big(2));
        const Big h = sqrt(Big(in[0]) * Big(in[0]) + Big(in[1]) * Big(in[1]));
        const Big truth = parallel_integral(Big(0), Big(2), Big(.25), Big(1.25), h);
        row.integrals.push_back(mean_weight<Real>("parallel segments", in, 64, Interval::relative(truth, Big(1e-14) + 8 * Big(epsilon<Real>))));
    }
    return row;
}

/// A light that passes the eye line at the distance h, with the foot inside (before < length) or outside (before < 0) of the light.
inline Big3 passing_origin(const Big3& a, const Big3& b, const Big& h, const Big& along_eye, const Big& before)
{
    return along_eye * a + h * unit(cross(b, a)) - before * b;
}

template <class Real>
HardRow<Real> row04()
{
    HardRow<Real> row;
    CaseRandom random(104);
    for (const double h : {1e-2, 1e-4, 1e-6})
        for (int i = 0; i < 100; ++i) {
            const Big3 a = random.direction(), b = unit(Big(random.uniform(-1, 1)) * a + random.orthogonal(a));
            const Big3 q = passing_origin(a, b, Big(h), Big(random.uniform(.2, 1)), Big(random.uniform(.2, 1)));
            row.cases.push_back(rod_case<Real>("h " + std::to_string(h), q, a, b, Big(1.5), random.xi<Real>(), {12, 40, true}));
        }
    for (const double h : {1e-8, 1e-12, 1e-30, 0.0})  // at or under the floor of float: finite, within the light
        for (int i = 0; i < 100; ++i) {
            const Big3 a = random.direction(), b = unit(Big(random.uniform(-1, 1)) * a + random.orthogonal(a));
            const Big3 q = passing_origin(a, b, Big(h), Big(random.uniform(.2, 1)), Big(random.uniform(.2, 1)));
            HardCase<Real> c = rod_case<Real>("crossing", q, a, b, Big(1.5), random.xi<Real>());
            const Big s = length(cross(b, a)), e(epsilon<Real>);
            // E is at most that of the floor, epsilon |q| / 2, at both ends' distance <= 3: (1/s) 2 log(6 / (epsilon |q| / 2)), |q| >= .1.
            // Half of all xi fall within sqrt(h) of the foot, where v itself has few digits: the round trip says little.
            c.expected = {Interval{Big(0), Big(2 / s * log(Big(120 / e)))}, Interval{Big(0), Big(c.in[9])}, Interval{Big(1), Interval{}.high},
                          Interval{Big(0), Big(1)}};
            row.cases.push_back(c);
        }
    return row;
}

template <class Real>
HardRow<Real> row05()
{
    HardRow<Real> row;
    CaseRandom random(105);
    for (const double h : {1e-3, 1e-5, 1e-7, 1e-12, 0.0})
        for (int i = 0; i < 100; ++i) {
            const Big3 a = random.direction(), b = unit(Big(random.uniform(-1, 1)) * a + random.orthogonal(a));
            const bool behind = i % 2 == 0;
            const Big3 q = passing_origin(a, b, Big(h), Big(random.uniform(.2, 1)), behind ? Big(random.uniform(-1, -.1)) : Big(random.uniform(1.6, 2.5)));
            row.cases.push_back(rod_case<Real>("h " + std::to_string(h), q, a, b, Big(1.5), random.xi<Real>(), {8, 10, true}));
        }
    return row;
}

template <class Real>
HardRow<Real> row06()
{
    HardRow<Real> row;
    CaseRandom random(106);
    for (const double distance : {10., 100., 1000.})
        for (int i = 0; i < 100; ++i) {
            const Big3 a = random.direction(), b = unit(Big(random.uniform(-1, 1)) * a + random.orthogonal(a));
            const Big3 q = passing_origin(a, b, Big(random.uniform(.1, 1)), Big(random.uniform(-1, 1)), Big(i % 2 ? distance : -distance));
            row.cases.push_back(rod_case<Real>("foot " + std::to_string(distance) + " away", q, a, b, Big(.01), random.xi<Real>()));
        }
    return row;
}

template <class Real>
HardRow<Real> row07()
{
    HardRow<Real> row;
    CaseRandom random(107);
    for (const double length : {1e-4, 1e-7})
        for (int i = 0; i < 100; ++i) {
            const Big3 a = random.direction(), b = random.direction();
            const Big3 q = Big(random.uniform(.1, 2)) * random.orthogonal(a) + Big(random.uniform(-1, 1)) * a;
            row.cases.push_back(rod_case<Real>("length " + std::to_string(length), q, a, b, Big(length), random.xi<Real>()));
        }
    return row;
}

template <class Real>
HardRow<Real> row08()
{
    HardRow<Real> row;
    CaseRandom random(108);
    for (int i = 0; i < 100; ++i) {
        const Big3 a = random.direction(), b = unit(Big(random.uniform(-1, 1)) * a + random.orthogonal(a));
        const Big3 q = Big(random.uniform(.1, 2)) * random.orthogonal(a) + Big(random.uniform(-1, 1)) * a;
        // y = s E reaches log(2e7 / .1) = 19, so exp(y) and with it v is off by 19 epsilon more.
        row.cases.push_back(rod_case<Real>("length 1e7", q, a, b, Big(1e7), random.xi<Real>(), {8, 30, false}));
        // The conditioning term would be useless here (D1 = 1e7): a light far from the line needs none, one that passes close does.
        const RodOracle oracle(Rounded3<Real>(q).big(), Rounded3<Real>(a).big(), Rounded3<Real>(b).big(), Big(1e7));
        const Big e(epsilon<Real>), shaken = 4 * e / oracle.s * oracle.D0 / oracle.nearest();
        HardCase<Real>& c = row.cases.back();
        c.expected[0] = Interval::around(oracle.potential, 8 * e * oracle.potential + shaken);
        c.expected[3] = Interval::around(Big(c.in[10]), Big(1e-2));  // near the foot xi is spread over 1e-7 of the light: v has few digits of it
    }
    return row;
}

template <class Real>
HardRow<Real> row09()
{
    HardRow<Real> row;
    // On the axis z: eye [0, 1], light [1.5, 2.5], both ways. R is analytic within .5 of the light: 64 panels of 4 nodes are exact to 1e-15.
    for (const int sign : {1, -1}) {
        const auto in = pair_inputs<Real>({Big(0), Big(0), sign > 0 ? Big(1.5) : Big(2.5)}, {Big(0), Big(0), Big(1)}, {Big(0), Big(0), Big(sign)}, Big(1), Big(1));
        const Big truth = log(Big(Big(1.5) * Big(1.5) / (Big(.5) * Big(2.5))));
        row.integrals.push_back(mean_weight<Real>("collinear", in, 64, Interval::relative(truth, Big(1e-14) + 8 * Big(epsilon<Real>))));
    }
    return row;
}

}  // namespace tyndall::test
