#pragma once
/// Random inputs that like to be degenerate, and how a property of them is checked.
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <iostream>

namespace tyndall::test {

/// rc::check prints the counterexample and the seed that reproduces it; RC_PARAMS overrides. The default configuration is fixed here.
template <class F>
bool holds(const std::string& what, F&& property, int successes = 20000)
{
    rc::detail::Configuration configuration;
    configuration.testParams.seed = 20120805;
    configuration.testParams.maxSuccess = successes;
    rc::detail::TestMetadata metadata;
    metadata.id = metadata.description = what;
    const auto result = rc::detail::checkTestable(std::forward<F>(property), metadata, configuration.testParams);
    rc::detail::printResultMessage(result, std::cerr);
    return result.template is<rc::detail::SuccessResult>();
}

/// Coordinates that like to coincide: whole numbers, halves, tiny ones, ordinary ones.
inline rc::Gen<float> coordinate()
{
    const auto scaled = [](double scale) { return rc::gen::map(rc::gen::inRange(-1000, 1001), [scale](int i) { return float(i * scale); }); };
    return rc::gen::weightedOneOf<float>({{3, rc::gen::element(0.f, 1.f, -1.f, .5f, -.5f)}, {3, scaled(1e-3)}, {1, scaled(1e-9)}, {1, scaled(1e-18)}, {1, scaled(10.)}});
}

struct Vector {
    double x, y, z;
};
inline rc::Gen<Vector> vector() { return rc::gen::map(rc::gen::tuple(coordinate(), coordinate(), coordinate()), [](const auto& t) { return Vector{std::get<0>(t), std::get<1>(t), std::get<2>(t)}; }); }

inline rc::Gen<Vector> direction()
{
    return rc::gen::map(rc::gen::suchThat(vector(), [](const Vector& v) { return v.x * v.x + v.y * v.y + v.z * v.z > 1e-30; }),
                        [](const Vector& v) {
                            const double n = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
                            return Vector{v.x / n, v.y / n, v.z / n};
                        });
}

/// Lengths: 0, or within 1e-9 ... 1e7, so that the integral of 1 / w^2 at contact, 1 / (epsilon^3 length), is a float.
inline rc::Gen<float> size()
{
    const auto scaled = [](float scale) { return rc::gen::map(rc::gen::inRange(0, 1001), [scale](int i) { return float(i) * scale; }); };
    return rc::gen::weightedOneOf<float>({{2, rc::gen::element(0.f, 1.f, 2.f, 1e-7f, 1e7f)}, {2, scaled(1e-3f)}, {1, scaled(1e-9f)}, {1, scaled(10)}});
}
inline rc::Gen<float> number()
{
    return rc::gen::weightedOneOf<float>({{1, rc::gen::element(0.f, 0x1.fffffep-1f, .5f, 0x1p-24f)}, {4, rc::gen::map(rc::gen::inRange(0, 1 << 24), [](int i) { return float(i) * 0x1p-24f; })}});
}

template <class Real>
void put(std::array<Real, 14>& in, std::size_t first, const Vector& v)
{
    in[first] = Real(v.x), in[first + 1] = Real(v.y), in[first + 2] = Real(v.z);
}

}  // namespace tyndall::test
