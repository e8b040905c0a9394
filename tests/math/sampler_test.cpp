// Every sampler: draws follow its density (chi^2), the density integrates to 1 and is the one it should be (adaptive quadrature of a formula that shares
// no code with the kernels), invert undoes sample, and float agrees with double of the same source.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "kernels/dialect_host.hpp"
#include "tests/support/chi_square.hpp"
#include "tests/support/quadrature.hpp"

namespace tyndall::test {
namespace {

namespace single = maths_float;
namespace twice = maths_double;

/// One density on [low, high]: what the kernels say, and what it should be up to a factor.
struct Density {
    std::string name;
    double low, high;
    std::function<double(double)> sample, pdf, invert;
    std::function<float(float)> sample_in_float, pdf_in_float;
    std::function<long double(long double)> shape;
};

void PrintTo(const Density& d, std::ostream* out) { *out << d.name; }

/// Unit to double's rounding; float rounds it once more.
using Three = std::array<double, 3>;
twice::real3 in_double(const Three& a) { return {a[0], a[1], a[2]}; }
single::real3 in_float(const Three& a) { return {float(a[0]), float(a[1]), float(a[2])}; }

Three unit(Three a)
{
    const double n = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    return {a[0] / n, a[1] / n, a[2] / n};
}

/// Squared distance of o + t d, and its products with other vectors, in long double.
struct Ray {
    long double o[3], d[3];
    Ray(const Three& origin, const Three& direction) : o{origin[0], origin[1], origin[2]}, d{direction[0], direction[1], direction[2]} {}
    std::array<long double, 3> at(long double t) const { return {o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]}; }
};
long double dot(const std::array<long double, 3>& a, const Three& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
long double square(const std::array<long double, 3>& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; }

Density rod(std::string name, Three q, Three a, Three b, float length)
{
    const Ray light(q, b);
    return {std::move(name), 0, length,
            [=](double xi) { return twice::sample_rod(in_double(q), in_double(a), in_double(b), length, xi).v; },
            [=](double v) { return twice::pdf_rod(in_double(q), in_double(a), in_double(b), length, v); },
            [=](double v) { return twice::invert_rod(in_double(q), in_double(a), in_double(b), length, v); },
            [=](float xi) { return single::sample_rod(in_float(q), in_float(a), in_float(b), length, xi).v; },
            [=](float v) { return single::pdf_rod(in_float(q), in_float(a), in_float(b), length, v); },
            [=](long double v) { const auto y = light.at(v); const long double along = dot(y, a); return 1 / std::sqrt(square(y) - along * along); }};
}

Density equiangular(std::string name, Three p, Three a, float length)
{
    const Ray segment({-p[0], -p[1], -p[2]}, a);
    return {std::move(name), 0, length,
            [=](double xi) { return twice::sample_equiangular(in_double(p), in_double(a), length, xi).u; },
            [=](double u) { return twice::pdf_equiangular(in_double(p), in_double(a), length, u); },
            [=](double u) { return twice::invert_equiangular(in_double(p), in_double(a), length, u); },
            [=](float xi) { return single::sample_equiangular(in_float(p), in_float(a), length, xi).u; },
            [=](float u) { return single::pdf_equiangular(in_float(p), in_float(a), length, u); },
            [=](long double u) { return 1 / square(segment.at(u)); }};
}

Density surface(std::string name, Three p, Three b, float length, Three n)
{
    const Ray light(p, b);
    return {std::move(name), 0, length,
            [=](double xi) { return twice::sample_surface_rod(in_double(p), in_double(b), length, in_double(n), xi).v; },
            [=](double v) { return twice::pdf_surface_rod(in_double(p), in_double(b), length, in_double(n), v); },
            [=](double v) { return twice::invert_surface_rod(in_double(p), in_double(b), length, in_double(n), v); },
            [=](float xi) { return single::sample_surface_rod(in_float(p), in_float(b), length, in_float(n), xi).v; },
            [=](float v) { return single::pdf_surface_rod(in_float(p), in_float(b), length, in_float(n), v); },
            [=](long double v) { const auto y = light.at(v); const long double w = std::sqrt(square(y)); return std::max(dot(y, n), 0.0L) / (w * w * w); }};
}

Density distance(std::string name, float sigma, float length)
{
    return {std::move(name), 0, length,
            [=](double xi) { return twice::sample_distance(sigma, length, xi); },
            [=](double t) { return twice::pdf_distance(sigma, length, t); },
            [=](double t) { return twice::invert_distance(sigma, length, t); },
            [=](float xi) { return single::sample_distance(sigma, length, xi); },
            [=](float t) { return single::pdf_distance(sigma, length, t); },
            [=](long double t) { return std::exp(-static_cast<long double>(sigma) * t); }};
}

twice::ScatterCosine at(double c) { return {1 - c, 1 + c}; }
Density scatter(std::string name, float g)
{
    return {std::move(name), -1, 1,
            [=](double xi) { return twice::sample_henyey_greenstein(g, xi); },
            [=](double c) { return twice::pdf_henyey_greenstein(g, at(c)); },
            [=](double c) { return twice::invert_henyey_greenstein(g, at(c)); },
            [=](float xi) { return single::sample_henyey_greenstein(g, xi); },
            [=](float c) { return single::pdf_henyey_greenstein(g, {1 - c, 1 + c}); },
            [=](long double c) { return std::pow(1 + static_cast<long double>(g) * g - 2 * g * c, -1.5L); }};
}

Density linear(std::string name, float f0, float f1)
{
    return {std::move(name), 0, 1,
            [=](double xi) { return twice::sample_linear(f0, f1, xi); },
            [=](double r) { return twice::pdf_linear(f0, f1, r); },
            [=](double r) { return twice::invert_linear(f0, f1, r); },
            [=](float xi) { return single::sample_linear(f0, f1, xi); },
            [=](float r) { return single::pdf_linear(f0, f1, r); },
            [=](long double r) { return (1 - r) * f0 + r * f1; }};
}

std::vector<Density> densities()
{
    const Three a = unit({.1, .2, 1}), b = unit({1, -.3, .2}), n = unit({.2, 1, .1});
    return {rod("rod passing in front of the line", {-.7, .3, 1}, a, b, 2),
            rod("rod nearly crossing", {-.7, .253, .3}, a, b, 2),
            rod("rod running away", {.4, .3, 1}, a, b, 3),
            rod("rod nearly parallel", {.4, .3, 1}, a, unit({.1, .201, 1}), 3),
            equiangular("foot inside", {.3, .4, 1}, a, 3),
            equiangular("foot before", {.1, .2, -.4}, a, 3),
            equiangular("foot beyond", {.3, .1, 4}, a, 3),
            equiangular("close", {.11, .2, 1}, a, 3),
            surface("rod above a surface", {-.7, .3, 1}, b, 1, n),
            surface("rod that sets", {-.7, .3, .1}, unit({1, -.8, .2}), 2, n),
            surface("rod close to a surface", {-1, .05, .02}, unit({1, .01, 0}), 2, {0, 1, 0}),
            distance("thick", 3, 2), distance("thin", 1e-3f, 2), distance("empty", 0, 2),
            scatter("forward", .9f), scatter("backward", -.6f), scatter("isotropic", 0),
            linear("rising", 0, 2), linear("falling", 3, 1)};
}

class EverySampler : public testing::TestWithParam<Density> {};
INSTANTIATE_TEST_SUITE_P(Of, EverySampler, testing::ValuesIn(densities()), [](const auto& density) {
    std::string name = density.param.name;
    std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
    return name;
});

/// Integral of f over a piece that may hold a horizon: absolute accuracy 1e-12 of a density's unit.
template <class F>
double over(F&& f, double low, double high) { return double(integrate([&](long double x) { return static_cast<long double>(f(double(x))); }, low, high, 1e-13L, 40)); }

TEST_P(EverySampler, DensityIntegratesToOne) { EXPECT_NEAR(over(GetParam().pdf, GetParam().low, GetParam().high), 1, 1e-10); }

TEST_P(EverySampler, DensityIsTheOneThatQuadratureNormalises)
{
    const Density& d = GetParam();
    const long double total = integrate(d.shape, d.low, d.high, 1e-14L, 40);
    for (int i = 0; i < 50; ++i) {
        const double x = d.low + (d.high - d.low) * (i + .5) / 50;
        const double truth = double(d.shape(x) / total);
        EXPECT_NEAR(d.pdf(x), truth, 1e-9 * truth + 1e-300) << d.name << " at " << x;
    }
}

/// 64 cells, merged until each expects more than 5 draws of 100,000. False alarm: 1e-6 per test.
TEST_P(EverySampler, DrawsFollowTheDensity)
{
    const Density& d = GetParam();
    constexpr int cells = 64, draws = 100000;
    std::vector<double> counts(cells), probability(cells);
    for (int i = 0; i < draws; ++i) {
        const twice::Random2 xi = twice::random2(20120805u, std::uint32_t(i));
        const double x = d.sample(xi.first);
        ASSERT_GE(x, d.low);
        ASSERT_LE(x, d.high);
        counts[std::min(int((x - d.low) / (d.high - d.low) * cells), cells - 1)] += 1;
    }
    const long double total = integrate(d.shape, d.low, d.high, 1e-14L, 40);
    for (int i = 0; i < cells; ++i)
        probability[i] = double(integrate(d.shape, d.low + (d.high - d.low) * i / cells, d.low + (d.high - d.low) * (i + 1) / cells, 1e-14L, 40) / total);
    std::vector<double> observed{0}, expected{0};
    double impossible = 0;
    for (int i = 0; i < cells; ++i) {
        if (probability[i] == 0) impossible += counts[i];
        observed.back() += counts[i], expected.back() += probability[i] * draws;
        if (expected.back() > 5 && i + 1 < cells) observed.push_back(0), expected.push_back(0);
    }
    if (expected.back() <= 5) {
        const double o = observed.back(), e = expected.back();
        observed.pop_back(), expected.pop_back(), observed.back() += o, expected.back() += e;
    }
    EXPECT_EQ(impossible, 0);
    EXPECT_GT(chi_square_p(observed, expected), false_alarm_rate) << d.name;
}

TEST_P(EverySampler, InvertUndoesSample)
{
    const Density& d = GetParam();
    for (int i = 0; i < 1000; ++i) {
        const double xi = (i + .5) / 1000;
        EXPECT_NEAR(d.invert(d.sample(xi)), xi, 1e-11) << d.name;
    }
}

TEST_P(EverySampler, SampleIsIncreasingFromOneEndToTheOther)
{
    const Density& d = GetParam();
    double last = d.sample(0);
    for (int i = 1; i <= 1000; ++i) {
        const double x = d.sample(i / 1000. * (1 - 0x1p-24));
        EXPECT_GE(x, last - 1e-14 * (d.high - d.low)) << d.name;
        last = x;
    }
}

/// v and u to 16 epsilon of the interval, the density to 64 epsilon (inputs of these configurations are rounded once and conditioned by at most 10).
TEST_P(EverySampler, FloatAgreesWithDouble)
{
    const Density& d = GetParam();
    constexpr double e = std::numeric_limits<float>::epsilon();
    for (int i = 0; i < 1000; ++i) {
        const float xi = (float(i) + .5f) / 1024;
        const double x = d.sample(xi);
        EXPECT_NEAR(d.sample_in_float(xi), x, 16 * e * (d.high - d.low)) << d.name << " xi " << xi;
        const float rounded = float(x);
        EXPECT_NEAR(d.pdf_in_float(rounded), d.pdf(rounded), 64 * e * d.pdf(rounded) + 4 * e) << d.name << " at " << rounded;
    }
}

}  // namespace
}  // namespace tyndall::test
