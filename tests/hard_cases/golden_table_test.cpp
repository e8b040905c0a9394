// The golden tables that the program carries are what the oracles say, and they find errors.
#include <gtest/gtest.h>

#include <fstream>

#include "selftest/check_row.hpp"
#include "tests/hard_cases/golden_text.hpp"

namespace tyndall::test {
namespace {

std::string file(const std::string& name)
{
    std::ifstream stream(TYNDALL_SOURCE_DIR "/host/selftest/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The first line in which they differ; empty if they are the same.
std::string difference(const std::string& ours, const std::string& theirs)
{
    std::istringstream a(ours), b(theirs);
    std::string line, other;
    for (int number = 1;; ++number) {
        const bool more = bool(std::getline(a, line)), other_more = bool(std::getline(b, other));
        if (!more && !other_more) return {};
        if (more != other_more || line != other) return "line " + std::to_string(number) + ": " + line + "\nis not " + other;
    }
}

TEST(GoldenTable, IsWhatTheOraclesWrite)
{
    const char* advice = "\nrun `write_golden_table host/selftest` from the build folder's tests/hard_cases and commit what it writes";
    EXPECT_EQ(difference(file("golden_float.inc"), golden_text<float>()), "") << advice;
    EXPECT_EQ(difference(file("golden_double.inc"), golden_text<double>()), "") << advice;
}

TEST(GoldenTable, HoldsEveryRow)
{
    for (std::size_t row = 0; row < golden_rows().size(); ++row) {
        const auto is_row = [&](const auto& entry) { return entry.row == int(row); };
        EXPECT_TRUE(std::ranges::any_of(golden_floats().sets, is_row) || std::ranges::any_of(golden_floats().means, is_row)) << golden_rows()[row];
        EXPECT_TRUE(std::ranges::any_of(golden_doubles().sets, is_row) || std::ranges::any_of(golden_doubles().means, is_row)) << golden_rows()[row];
    }
}

template <class Real>
SelftestOutcome judged(int row, const GoldenTable<Real>& table, Real factor)
{
    return judge_row<Real>(row, evaluate_row<Real>(row, table, [&](unsigned sampler, const auto& in) {
        auto out = evaluate_each_on_host<Real>(sampler, in);
        for (auto& outputs : out)
            for (Real& x : outputs) x *= factor;
        return out;
    }));
}

/// Every row, in both precisions: ours is within the bounds; a share of a thousandth more is not, nor is NaN.
template <class Real>
void expect_that_rows_find_errors(const GoldenTable<Real>& table)
{
    for (int row = 0; row < int(golden_rows().size()); ++row) {
        const SelftestOutcome right = judged<Real>(row, table, 1), wrong = judged<Real>(row, table, Real(1.001)), nan = judged<Real>(row, table, std::numeric_limits<Real>::quiet_NaN());
        EXPECT_EQ(right.misses, 0u) << right.name << ": " << (right.first ? sentence_of(*right.first) : "");
        EXPECT_LE(right.worst_share, 1) << right.name;
        EXPECT_GT(right.outputs, 0u);
        EXPECT_EQ(nan.misses, nan.outputs) << nan.name;
        const bool finite_only = right.name.starts_with("Row13") || right.name.starts_with("Row28");  // nothing but "finite and on the segment" is asked there
        EXPECT_TRUE(finite_only || wrong.misses > 0) << wrong.name;
    }
}

TEST(GoldenTable, FindsErrorsInFloat) { expect_that_rows_find_errors(golden_floats()); }
TEST(GoldenTable, FindsErrorsInDouble) { expect_that_rows_find_errors(golden_doubles()); }

TEST(GoldenTable, BoundsAreThoseOfTheOracleToTheLastBit)
{
    const Big third = Big(1) / 3;
    const float up = rounded_up<float>(third), down = -rounded_up<float>(-third);
    EXPECT_GE(Big(up), third);
    EXPECT_LE(Big(down), third);
    EXPECT_EQ(std::nextafter(down, 1.f), up);
    EXPECT_EQ(rounded_up<float>(Big(.5)), .5f);
    EXPECT_EQ(output_text<float>(Interval{}), "FINITE");
    EXPECT_EQ(output_text<float>(Interval{Big(0), Big(1)}), "BETWEEN(0.f, 1.f)");
    EXPECT_EQ(output_text<double>(Interval::around(Big(1), Big(.5))), "NEAR(1., 0.5, 1.5)");
}

TEST(GoldenTable, LiteralsReadBackAsTheSameNumber)
{
    EXPECT_EQ(literal(.1f), "0.1f");
    EXPECT_EQ(literal(1e30f), "1e+30f");
    EXPECT_EQ(literal(-0.f), "-0.f");
    EXPECT_EQ(literal(std::numeric_limits<double>::infinity()), "INFINITE");
}

TEST(GoldenTable, NodesOfMeansAreThoseOfTheRows)
{
    for (const HardIntegral<double>& integral : row30<double>().integrals) {
        const MeanNodes<double> nodes = mean_nodes<double>(integral.in.front(), integral.panels);
        EXPECT_EQ(nodes.in, integral.in);
        for (std::size_t i = 0; i < nodes.weight.size(); ++i) EXPECT_NEAR(nodes.weight[i], double(integral.weight[i]), 1e-18);
    }
}

}  // namespace
}  // namespace tyndall::test
