#pragma once
/// Runs a row through something that evaluates inputs, and says which case missed which interval.
#include <gtest/gtest.h>

#include <functional>

#include "tests/hard_cases/angle_rows.hpp"
#include "tests/hard_cases/grid_rows.hpp"
#include "tests/hard_cases/guided_rows.hpp"
#include "tests/hard_cases/pair_rows.hpp"
#include "tests/hard_cases/rod_rows.hpp"
#include "tests/hard_cases/scatter_rows.hpp"
#include "tests/hard_cases/surface_rows.hpp"

namespace tyndall::test {

template <class Real>
using Evaluator = std::function<std::vector<std::array<Real, 4>>(unsigned sampler, const std::vector<std::array<Real, 14>>& in)>;

template <class Real>
std::vector<std::array<Real, 4>> evaluate_each_on_host(unsigned sampler, const std::vector<std::array<Real, 14>>& in)
{
    std::vector<std::array<Real, 4>> out;
    for (const auto& i : in) out.push_back(evaluate_on_host(sampler, i));
    return out;
}

template <class Real>
std::string describe(const HardCase<Real>& c, const std::array<Real, 4>& out, std::size_t k)
{
    std::ostringstream text;
    text.precision(std::numeric_limits<Real>::max_digits10);
    text << c.name << ": output " << k << " = " << out[k] << " outside [" << c.expected[k].low << ", " << c.expected[k].high << "], inputs";
    for (const Real x : c.in) text << ' ' << x;
    return text.str();
}

template <class Real>
void check_integral(const HardIntegral<Real>& integral, const Evaluator<Real>& evaluate)
{
    const auto out = evaluate(integral.sampler, integral.in);
    Big sum = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        ASSERT_TRUE(std::isfinite(out[i][integral.output])) << integral.name << ", node " << i;
        sum += integral.weight[i] * Big(out[i][integral.output]);
    }
    EXPECT_TRUE(integral.expected.holds(sum)) << integral.name << ": " << sum << " outside [" << integral.expected.low << ", " << integral.expected.high << "]";
}

template <class Real>
void check_row(const HardRow<Real>& row, const Evaluator<Real>& evaluate)
{
    std::vector<std::array<Real, 14>> in;
    for (const HardCase<Real>& c : row.cases) in.push_back(c.in);
    std::size_t failures = 0, checked = 0;
    for (std::size_t i = 0; i < row.cases.size();) {  // a row may mix samplers: one launch per run of equal ones
        std::size_t end = i;
        while (end < row.cases.size() && row.cases[end].sampler == row.cases[i].sampler) ++end;
        const auto out = evaluate(row.cases[i].sampler, {in.begin() + std::ptrdiff_t(i), in.begin() + std::ptrdiff_t(end)});
        for (std::size_t j = i; j < end; ++j)
            for (std::size_t k = 0; k < 4; ++k, ++checked) {
                const Real x = out[j - i][k];
                const bool holds = std::isfinite(x) && row.cases[j].expected[k].holds(Big(x));
                if (!holds && ++failures <= 10) ADD_FAILURE() << describe(row.cases[j], out[j - i], k);
            }
        i = end;
    }
    EXPECT_EQ(failures, 0u) << "of " << checked << " outputs";
    EXPECT_GT(checked + row.integrals.size(), 0u);
    for (const HardIntegral<Real>& integral : row.integrals) check_integral(integral, evaluate);
}

}  // namespace tyndall::test
