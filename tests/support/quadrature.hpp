#pragma once
/// Adaptive quadrature that shares no code with kernels/: the judge of what the formulas there mean.
#include <array>
#include <cmath>

namespace tyndall::test {

/// The nodes in (0, 1) and weights of the Gauss rule with ten points.
struct GaussRule {
    static constexpr std::array<long double, 5> node{0.14887433898163121088482600112972L, 0.43339539412924719079926594316579L,
                                                     0.67940956829902440623432736511487L, 0.86506336668898451073209668842349L,
                                                     0.97390652851717172007796401208445L};
    static constexpr std::array<long double, 5> weight{0.29552422471475287017389299465132L, 0.26926671930999635509122692156947L,
                                                       0.21908636251598204399553493422816L, 0.14945134915058059314579415698769L,
                                                       0.06667134430868813759356880989333L};
};

/// Integral of f over [a, b] by one Gauss rule of ten points (exact for polynomials of degree 19).
template <class F>
long double gauss(F&& f, long double a, long double b)
{
    const long double middle = (a + b) / 2, half = (b - a) / 2;
    long double sum = 0;
    for (std::size_t i = 0; i < 5; ++i)
        sum += GaussRule::weight[i] * (f(middle - half * GaussRule::node[i]) + f(middle + half * GaussRule::node[i]));
    return half * sum;
}

/// Integral of f over [a, b]: bisects until halving a piece changes it by less than `tolerance` times the piece's share (depth at most 60).
template <class F>
long double integrate(F&& f, long double a, long double b, long double tolerance, int depth = 60)
{
    const long double middle = (a + b) / 2, whole = gauss(f, a, b), halves = gauss(f, a, middle) + gauss(f, middle, b);
    if (depth == 0 || !(std::fabs(whole - halves) > tolerance)) return halves;
    return integrate(f, a, middle, tolerance / 2, depth - 1) + integrate(f, middle, b, tolerance / 2, depth - 1);
}

}  // namespace tyndall::test
