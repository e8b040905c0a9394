#pragma once
/// Row 37, phase functions with lobes, and the densities that follow the light (samplers paper, paper-6 and the tables): what they draw must be what they divide by,
/// so that the mean of (value / density) is the integral of the value, found here by quadrature over the eye segment.
#include "kernels/selftest/case_tables.hpp"
#include "tests/hard_cases/cases.hpp"
#include "tests/support/quadrature.hpp"

namespace tyndall::test {

using Wide = long double;

/// Nodes over xi as host/selftest/golden.hpp lays them.
template <class Real>
HardIntegral<Real> mean_over_xi(std::string name, unsigned sampler, std::array<Real, 14> in, unsigned panels, Interval expected)
{
    HardIntegral<Real> integral{std::move(name), sampler, 0, {}, {}, expected, panels};
    const std::array<double, 4> node{.86113631159405257522, .33998104358485626480, -.33998104358485626480, -.86113631159405257522};
    const std::array<double, 4> weight{.34785484513745385737, .65214515486254614263, .65214515486254614263, .34785484513745385737};
    for (unsigned panel = 0; panel < panels; ++panel)
        for (std::size_t k = 0; k < 4; ++k) {
            in[11] = Real((panel + .5 + .5 * node[k]) / panels);
            integral.in.push_back(in);
            integral.weight.push_back(Big(weight[k]) / (2 * panels));
        }
    return integral;
}

inline Wide wide_henyey_greenstein(Wide g, Wide mu)
{
    const Wide r2 = 1 + g * g - 2 * g * mu;
    return (1 - g * g) / (4 * std::acos(Wide(-1)) * r2 * std::sqrt(r2));
}

/// Values between equally spaced cosines.
inline Wide wide_table(std::uint32_t first, std::uint32_t count, Wide mu)
{
    const Wide at = (mu + 1) / 2 * Wide(count - 1), low = std::min(std::floor(std::max(at, Wide(0))), Wide(count - 2)), f = std::min(std::max(at - low, Wide(0)), Wide(1));
    const float* v = case_tables::values.data() + first + std::size_t(low);
    return (1 - f) * Wide(v[0]) + f * Wide(v[1]);
}

/// The phase functions of the case tables, once more.
inline Wide wide_phase(unsigned number, Wide mu)
{
    const Wide rayleigh = 3 / (16 * std::acos(Wide(-1))) * (1 + mu * mu);
    if (number == 0) return rayleigh;
    if (number == 1) return wide_table(case_tables::first_phase, 10, mu);
    if (number == 2) return (wide_henyey_greenstein(Wide(.99f), mu) + wide_henyey_greenstein(Wide(-.99f), mu)) / 2;
    if (number == 3) return (rayleigh + wide_table(case_tables::first_phase, 10, mu)) / 4 + wide_henyey_greenstein(.75L, mu) / 2;
    return wide_table(case_tables::first_spike, case_tables::spike_values, mu);
}

template <class Real>
struct WideArc {
    std::array<Wide, 3> p, a, b;
    Wide length;
    explicit WideArc(const std::array<Real, 14>& in) : length(in[9])
    {
        for (std::size_t k = 0; k < 3; ++k) p[k] = in[k], a[k] = in[3 + k], b[k] = in[6 + k];
    }
    /// Integral over the fraction of the angle of value(cosine at the light, cosine at the eye, way): of value D / (Theta w^2) over the segment.
    template <class F>
    Wide mean(F&& value) const
    {
        const Wide foot = p[0] * a[0] + p[1] * a[1] + p[2] * a[2];
        Wide distance2 = 0;
        for (std::size_t k = 0; k < 3; ++k) distance2 += (p[k] - foot * a[k]) * (p[k] - foot * a[k]);
        const Wide D = std::sqrt(distance2), from = std::atan2(-foot, D), to = std::atan2(length - foot, D);
        const auto at = [&](Wide angle) {  // from the foot, seen from the point
            const Wide u = foot + D * std::tan(angle), w = D / std::cos(angle);
            Wide light = 0, eye = 0;
            for (std::size_t k = 0; k < 3; ++k) light += b[k] * (u * a[k] - p[k]) / w, eye -= a[k] * (u * a[k] - p[k]) / w;
            return value(light, eye, u + w);
        };
        // Gauss's rule in 2000 pieces: the narrowest lobe is ten of them wide, and a kink inside one is a millionth of the whole.
        constexpr int pieces = 2000;
        Wide sum = 0;
        for (int i = 0; i < pieces; ++i) sum += gauss(at, from + (to - from) * i / pieces, from + (to - from) * (i + 1) / pieces);
        return sum / (to - from);
    }
};

template <class Real>
std::array<Real, 14> any_arc(CaseRandom& random)
{
    std::array<Real, 14> in{};
    const Big3 a = random.direction();
    put(in, 0, Rounded3<Real>(Big(random.uniform(.3, 1.5)) * random.orthogonal(a) + Big(random.uniform(-.5, 1.5)) * a));
    put(in, 3, Rounded3<Real>(a)), put(in, 6, Rounded3<Real>(random.direction()));
    in[9] = Real(random.uniform(.5, 2));
    return in;
}

/// Single draws: x on the arc, density at least the even share, at most `steepest` times the even one; the product over it at most `largest`.
template <class Real>
HardCase<Real> drawn(std::string name, unsigned sampler, const std::array<Real, 14>& in, Wide largest)
{
    HardCase<Real> c{std::move(name), sampler, in, {}};
    const Big e(epsilon<Real>);
    c.expected = {Interval{Big(0), 10 * Big(largest) * (1 + 32 * e)}, Interval{Big(0), Big(1)}, Interval{Big(.1) * (1 - 32 * e), Interval{}.high}, Interval{Big(0), Big(0)}};
    return c;
}

/// A mean has the error of its nodes, which straddle the kinks of x(xi): `nodes`, relative, measured in double with four times as many; and float's, 64 epsilon.
template <class Real>
Interval near_mean(Wide truth, double nodes) { return Interval::relative(Big(truth), Big(nodes) + 64 * Big(epsilon<Real>)); }

template <class Real>
HardRow<Real> guided_arcs()
{
    HardRow<Real> row;
    CaseRandom random(140);
    for (const unsigned sampler : {SAMPLER_WARP_10, SAMPLER_WARP_10T, SAMPLER_WARP_6T, SAMPLER_WARP_4T})
        for (const double g : {.55, .9, -.7}) {
            auto in = any_arc<Real>(random);
            in[10] = Real(g), in[12] = Real(random.uniform(.2, 2));
            const Wide sigma = in[12], asymmetry = in[10];
            const auto value = [&](Wide light, Wide eye, Wide way) { return wide_henyey_greenstein(asymmetry, light) * wide_henyey_greenstein(asymmetry, eye) * std::exp(-sigma * way); };
            const std::string name = "g " + std::to_string(g);
            row.integrals.push_back(mean_over_xi<Real>(name, sampler, in, 256, near_mean<Real>(WideArc<Real>(in).mean(value), 2e-4)));
            const Wide peak = wide_henyey_greenstein(std::abs(asymmetry), 1);
            for (int i = 0; i < 8; ++i) in[11] = i == 0 ? Real(0) : i == 1 ? last_xi<Real> : random.xi<Real>(), row.cases.push_back(drawn<Real>(name, sampler, in, peak * peak));
        }
    return row;
}

template <class Real>
HardRow<Real> guided_lights()
{
    HardRow<Real> row;
    CaseRandom random(141);
    for (const unsigned sampler : {SAMPLER_MARGINAL_8X6, SAMPLER_MARGINAL_4X4, SAMPLER_MARGINAL_3X2})
        for (const double g : {0., .55, .9, -.7}) {
            const Big3 a = random.direction(), b = random.direction();
            auto in = pair_inputs<Real>(Big(random.uniform(.2, 1)) * random.orthogonal(a) + Big(random.uniform(-.5, 1)) * a, a, b, Big(random.uniform(.5, 2)), Big(random.uniform(.5, 2)));
            in[12] = Real(g), in[13] = Real(random.uniform(.2, 2));
            const std::string name = "g " + std::to_string(g);
            row.integrals.push_back(mean_over_xi<Real>(name, sampler, in, 256, near_mean<Real>(Wide(in[9]), 2e-4)));
            for (int i = 0; i < 8; ++i) {
                in[11] = i == 0 ? Real(0) : i == 1 ? last_xi<Real> : random.xi<Real>();
                HardCase<Real> c{name, sampler, in, {}};
                // Even share .1, so no piece of the table is steeper than ten times the mean over a third of it: the round trip multiplies v's 16 epsilon by no more than 64.
                c.expected = {Interval{Big(0), Interval{}.high}, Interval{Big(0), Big(in[9])}, Interval{Big(1), Big(1)}, Interval::around(Big(in[11]), 1024 * Big(epsilon<Real>))};
                row.cases.push_back(c);
            }
        }
    return row;
}

template <class Real>
HardRow<Real> lobe_values()
{
    HardRow<Real> row;
    CaseRandom random(142);
    for (unsigned number = 0; number < CASE_PHASES; ++number)
        for (int i = 0; i < 16; ++i) {
            const Big3 w = random.direction(), side = random.orthogonal(w);
            const double theta = i == 0 ? 0 : i == 1 ? 3.1415926 : random.uniform(0, 3.1);
            const Rounded3<Real> in(w), out(unit(Big(std::cos(theta)) * w + Big(std::sin(theta)) * side));
            HardCase<Real> c{"phase function " + std::to_string(number), SAMPLER_PHASE_OF + number};
            put(c.in, 0, in), put(c.in, 3, out);
            const Wide mu = static_cast<Wide>(clamp(dot(in.big(), out.big()), Big(-1), Big(1))), value = wide_phase(number, mu);
            // The cosine is off by 3 epsilon, and the value by that times its slope; a kink of a table may lie between: the steeper side of the two.
            const Wide e = 3 * Wide(epsilon<Real>), reach = std::max(std::abs(wide_phase(number, std::min(mu + e, Wide(1))) - value), std::abs(wide_phase(number, std::max(mu - e, Wide(-1))) - value));
            c.expected[0] = Interval::around(Big(value), 2 * Big(reach) + 16 * Big(epsilon<Real>) * Big(value) + Big(epsilon<Real>) * Big(.02));
            for (const std::size_t k : {1, 2, 3}) c.expected[k] = {Big(0), Big(0)};
            row.cases.push_back(c);
        }
    return row;
}

template <class Real>
HardRow<Real> row37()
{
    HardRow<Real> row;
    CaseRandom random(137);
    for (unsigned number = 0; number < CASE_PHASES; ++number)
        for (int arc = 0; arc < 3; ++arc) {
            auto in = any_arc<Real>(random);
            const auto value = [&](Wide light, Wide eye, Wide) { return wide_phase(number, light) * wide_phase(number, eye); };
            const std::string name = "phase function " + std::to_string(number);
            row.integrals.push_back(mean_over_xi<Real>(name, SAMPLER_LOBE_WARP + number, in, 1024, near_mean<Real>(WideArc<Real>(in).mean(value), 5e-4)));
            Wide peak = 0;
            for (int i = 0; i <= 1000; ++i) peak = std::max(peak, wide_phase(number, Wide(i) / 500 - 1));
            for (int i = 0; i < 3; ++i) in[11] = i == 0 ? Real(0) : i == 1 ? last_xi<Real> : random.xi<Real>(), row.cases.push_back(drawn<Real>(name, SAMPLER_LOBE_WARP + number, in, peak * peak));
        }
    return row;
}

}  // namespace tyndall::test
