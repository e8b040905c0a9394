#pragma once
/// The golden tables of host/selftest as text, from the rows and their oracles.
#include <charconv>
#include <cmath>
#include <string>

#include "selftest/golden.hpp"
#include "tests/hard_cases/check_row.hpp"

namespace tyndall::test {

/// Sets of inputs per row in the table: every n-th of the row, so that each of its kinds is there.
inline constexpr std::size_t sets_per_row = 40;

/// The shortest text that reads back as the same Real, as a C++ literal.
template <class Real>
std::string literal(Real x)
{
    if (std::isinf(x)) return x > 0 ? "INFINITE" : "-INFINITE";
    char text[64];
    std::string digits(text, std::to_chars(text, text + sizeof text, x).ptr);
    if (digits.find_first_of(".e") == std::string::npos) digits += ".";
    return digits + (sizeof(Real) == 4 ? "f" : "");
}

/// The smallest Real that is not below x; its largest for what is beyond.
template <class Real>
Real rounded_up(const Big& x)
{
    if (x > Big(std::numeric_limits<Real>::max())) return std::numeric_limits<Real>::infinity();
    if (x < Big(std::numeric_limits<Real>::lowest())) return std::numeric_limits<Real>::lowest();
    Real near = static_cast<Real>(x);
    while (Big(near) < x) near = std::nextafter(near, std::numeric_limits<Real>::infinity());
    for (Real below; Big(below = std::nextafter(near, -std::numeric_limits<Real>::infinity())) >= x;) near = below;
    return near;
}

/// An interval as Reals see it: x lies in it exactly if it lies in the one of the oracle.
template <class Real>
std::string output_text(const Interval& interval)
{
    const Real low = rounded_up<Real>(interval.low), high = -rounded_up<Real>(-interval.high);
    if (!(low > std::numeric_limits<Real>::lowest()) && !(high < std::numeric_limits<Real>::max())) return "FINITE";
    const auto top = high > std::numeric_limits<Real>::max() ? std::numeric_limits<Real>::max() : high;
    const auto bounds = literal(low) + ", " + literal(top) + ")";
    return interval.value ? "NEAR(" + literal(static_cast<Real>(*interval.value)) + ", " + bounds : "BETWEEN(" + bounds;
}

template <class Real>
std::string list_of(const std::array<Real, 14>& in)
{
    std::size_t used = in.size();
    while (used > 1 && in[used - 1] == 0 && !std::signbit(in[used - 1])) --used;
    std::string text;
    for (std::size_t i = 0; i < used; ++i) text += (i ? ", " : "") + literal(in[i]);
    return "{" + text + "}";
}

template <class Real>
std::string set_text(const char* row, const HardCase<Real>& c)
{
    std::array<std::string, 4> outputs;
    std::size_t used = 0;
    for (std::size_t k = 0; k < 4; ++k)
        if ((outputs[k] = output_text<Real>(c.expected[k])) != "FINITE") used = k + 1;
    std::string text;
    for (std::size_t k = 0; k < used; ++k) text += (k ? ", " : "") + outputs[k];
    return "{" + std::string(row) + ", \"" + c.name + "\", " + std::to_string(c.sampler) + ", " + list_of(c.in) + ", {" + text + "}},\n";
}

template <class Real>
std::string mean_text(const char* row, const HardIntegral<Real>& integral)
{
    auto in = integral.in.front();
    in[11] = 0;
    return "{" + std::string(row) + ", \"" + integral.name + "\", " + std::to_string(integral.sampler) + ", " + std::to_string(integral.panels) + ", " + list_of(in) + ", Words<double>::" +
           output_text<double>(integral.expected) + "},\n";
}

template <class Real>
struct GoldenText {
    std::string sets, means;

    void add(const char* name, const HardRow<Real>& row)
    {
        const std::size_t count = std::min(row.cases.size(), sets_per_row);
        for (std::size_t i = 0; i < count; ++i) sets += set_text(name, row.cases[i * row.cases.size() / count]);
        for (const auto& integral : row.integrals) means += mean_text(name, integral);
    }
};

/// The file host/selftest/golden_<precision>.inc.
template <class Real>
std::string golden_text()
{
    GoldenText<Real> text;
#define HARD_CASE(name, row) text.add(#row, row<Real>());
#include "selftest/rows.inc"
    return "// Written by tests/hard_cases/write_golden_table; tests/hard_cases/golden_table_test.cpp compares. Row, name, sampler, inputs, outputs in order.\n"
           "#ifdef GOLDEN_SETS\n" + text.sets + "#endif\n"
           "// Row, name, sampler, panels, inputs, mean of output 0 (host/selftest/golden.hpp).\n"
           "#ifdef GOLDEN_MEANS\n" + text.means + "#endif\n";
}

}  // namespace tyndall::test
