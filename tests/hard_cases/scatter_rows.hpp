#pragma once
/// Rows 14-18, 31 and 32: phase functions, transmittance, distances, linear pieces, balance.
#include "tests/hard_cases/cases.hpp"

namespace tyndall::test {

inline Big henyey_greenstein(const Big3& in, const Big3& out, const Big& g)
{
    const Big side = g < 0 ? -1 : 1, size = abs(g), gap = 1 - size;
    const Big3 d = in - side * out;  // |in| and |out| as rounded: the peak's shape is that of the difference
    const Big r2 = gap * gap + size * dot(d, d);
    return gap * (1 + size) / (4 * boost::math::constants::pi<Big>() * r2 * sqrt(r2));
}

template <class Real>
HardRow<Real> row14()
{
    HardRow<Real> row;
    CaseRandom random(114);
    for (const double g : {.5, .99, .999, .9999, .99999, -.5, -.99, -.999, -.9999})
        for (int i = 0; i < 60; ++i) {
            const Big3 w = random.direction(), side = random.orthogonal(w);
            const double theta = i % 3 == 0 ? 0 : random.log_uniform(1e-5, 3);
            const Rounded3<Real> in(w), out(unit(Big((g < 0 ? -1 : 1) * std::cos(theta)) * w + Big(std::sin(theta)) * side));
            HardCase<Real> c{"g " + std::to_string(g) + " theta " + std::to_string(theta), SAMPLER_PHASE};
            put(c.in, 0, in), put(c.in, 3, out);
            c.in[6] = Real(g);
            // gap 1/2 ulp relative to itself (exact), square, product, sum 2 each; to the power 3/2; root, product, quotient: 3 * 1.5 + 3 < 8 halves.
            c.expected[0] = Interval::relative(henyey_greenstein(in.big(), out.big(), Big(c.in[6])), 6 * Big(epsilon<Real>));
            row.cases.push_back(c);
        }
    return row;
}

template <class Real>
HardRow<Real> row15()
{
    HardRow<Real> row;
    CaseRandom random(115);
    const Big largest = 1 - Big(1) / 1048576;
    for (const double g0 : {1., -1., 1.5, .9999, .9, .1, 1e-3, 1e-5, 1e-10, 0., -1e-10, -1e-5, -1e-3, -.1, -.9, -.9999})
        for (int i = 0; i < 40; ++i) {
            HardCase<Real> c{"g " + std::to_string(g0), SAMPLER_SCATTER};
            c.in[0] = Real(g0), c.in[1] = i == 0 ? Real(0) : i == 1 ? last_xi<Real> : random.xi<Real>();
            const Big g = clamp(Big(c.in[0]), -largest, largest), xi(c.in[1]), e(epsilon<Real>);
            // 1 +- cos by the textbook's inverse, in digits enough for its cancellation.
            const Big k = (1 - g * g) / (1 - g + 2 * g * xi), cosine = g == 0 ? Big(2 * xi - 1) : Big((1 + g * g - k * k) / (2 * g));
            // 1 -+ cos: three sums, a quotient and its square, three products: 12 roundings of epsilon / 2 at most; the cosine adds one.
            c.expected[0] = Interval::around(cosine, 7 * e);
            c.expected[1] = Interval::relative(1 - cosine, 6 * e), c.expected[2] = Interval::relative(1 + cosine, 6 * e);
            c.expected[3] = Interval::around(xi, 12 * e);
            row.cases.push_back(c);
        }
    return row;
}

template <class Real>
HardRow<Real> row16()
{
    HardRow<Real> row;
    for (const double depth : {80., 87., 87.5, 95., 103., 104., 200., 1e4})
        for (const double reference : {0., 80., 100., 1e4}) {
            if (std::abs(reference - depth) > 80) continue;  // ratios that are themselves normal numbers
            HardCase<Real> c{"optical depth " + std::to_string(depth), SAMPLER_RATIO};
            c.in[0] = Real(depth), c.in[1] = Real(reference);
            c.expected[0] = Interval::relative(exp(Big(c.in[1]) - Big(c.in[0])), 3 * Big(epsilon<Real>));
            row.cases.push_back(c);
        }
    for (const double depth : {88., 104., 800., 1e30}) {  // alone it underflows: to 0 or to a denormal, never below 0, never NaN; t stays a sample
        HardCase<Real> c{"optical depth " + std::to_string(depth), SAMPLER_DISTANCE};
        c.in[0] = Real(depth), c.in[1] = Real(1), c.in[2] = Real(.625);
        c.expected[0] = Interval::relative(-log(Big(.375)) / Big(c.in[0]), 6 * Big(epsilon<Real>));
        c.expected[3] = Interval{Big(0), exp(Big(-87))};
        row.cases.push_back(c);
    }
    return row;
}

template <class Real>
HardCase<Real> distance_case(std::string name, double sigma, double length, Real xi)
{
    HardCase<Real> c{std::move(name), SAMPLER_DISTANCE};
    c.in[0] = Real(sigma), c.in[1] = Real(length), c.in[2] = xi;
    const Big s(c.in[0]), L(c.in[1]), x(xi), e(epsilon<Real>), depth = s * L;
    const Big absorbed = 1 - exp(Big(-depth)), t = s == 0 ? Big(x * L) : Big(-log(Big(1 - x * absorbed)) / s);
    // 1 - xi A loses what log1p can lose where A -> 1: epsilon / (1 - xi) absolute in sigma t.
    const Big spread = depth > .5 ? Big(4 * e * x / (1 - x + exp(Big(-depth))) / s) : Big(0);
    c.expected[0] = Interval::around(t, 8 * e * t + spread);
    c.expected[1] = Interval::relative(s == 0 ? Big(1 / L) : Big(s * exp(Big(-s * t)) / absorbed), 12 * e + s * (8 * e * t + spread) + 4 * e * s * t);
    c.expected[2] = Interval::around(x, 16 * e);
    c.expected[3] = Interval::relative(exp(Big(-depth)), 3 * e + e * depth);
    return c;
}

template <class Real>
HardRow<Real> row17()
{
    HardRow<Real> row;
    CaseRandom random(117);
    for (const double depth : {1e-30, 1e-12, 1e-7, 1e-5, 1e-3, .1, .9, 1., 1.1, 3., 20., 60.})
        for (int i = 0; i < 40; ++i)
            row.cases.push_back(distance_case<Real>("optical depth " + std::to_string(depth), depth / 2, 2, i == 0 ? Real(0) : i == 1 ? last_xi<Real> : random.xi<Real>()));
    return row;
}

template <class Real>
HardRow<Real> row18()
{
    HardRow<Real> row;
    for (const double xi : {0., .25, .5, .875})
        for (const double length : {1e-6, 1., 1e6}) row.cases.push_back(distance_case<Real>("sigma_t 0", 0, length, Real(xi)));
    return row;
}

template <class Real>
HardRow<Real> row31()
{
    HardRow<Real> row;
    CaseRandom random(131);
    const auto add = [&](double f0, double f1, Real xi) {
        HardCase<Real> c{"from " + std::to_string(f0) + " to " + std::to_string(f1), SAMPLER_LINEAR};
        c.in[0] = Real(f0), c.in[1] = Real(f1), c.in[2] = xi;
        const bool flat = !(std::max(Real(f0), Real(f1)) >= std::numeric_limits<Real>::min());  // empty piece: uniform
        const Big g0 = flat ? Big(1) : Big(c.in[0]), g1 = flat ? Big(1) : Big(c.in[1]), x(xi), e(epsilon<Real>);
        const Big root = sqrt(Big(x * g1 * g1 + (1 - x) * g0 * g0)), r = x == 0 ? Big(0) : Big(x * (g0 + g1) / (g0 + root));
        c.expected[0] = Interval::relative(r, 8 * e);
        c.expected[1] = Interval::around(2 * root / (g0 + g1), 16 * e);
        c.expected[2] = Interval::around(x, 32 * e);
        row.cases.push_back(c);
    };
    for (int i = 0; i < 200; ++i) add(random.log_uniform(1e-6, 1e6), random.log_uniform(1e-6, 1e6), random.xi<Real>());
    for (const Real xi : {Real(0), Real(.3), last_xi<Real>}) {
        for (const double f : {0., 1e-45, 1e-30, 1., 1e30}) add(f, f, xi), add(f, 0, xi), add(0, f, xi);
        add(1, 1 + 1e-7, xi), add(1 + 1e-7, 1, xi);
    }
    return row;
}

template <class Real>
HardRow<Real> row32()
{
    HardRow<Real> row;
    const Real infinite = std::numeric_limits<Real>::infinity(), big = std::numeric_limits<Real>::max(), small = std::numeric_limits<Real>::min();
    for (const Real p1 : {Real(0), small, Real(1), Real(3), big, infinite})
        for (const Real p2 : {Real(0), small, Real(1), Real(3), big, infinite}) {
            HardCase<Real> c{"p1 " + std::to_string(p1) + " p2 " + std::to_string(p2), SAMPLER_BALANCE};
            c.in[0] = p1, c.in[1] = p2;
            const Big share = p1 == p2 ? Big(.5) : p1 == infinite ? Big(1) : p2 == infinite ? Big(0) : Big(Big(p1) / (Big(p1) + Big(p2)));
            c.expected[0] = Interval::around(share, 2 * Big(epsilon<Real>)), c.expected[1] = Interval::around(1 - share, 2 * Big(epsilon<Real>));
            row.cases.push_back(c);
        }
    return row;
}

}  // namespace tyndall::test
