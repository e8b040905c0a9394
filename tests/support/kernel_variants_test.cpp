/// The covering set covers.
#include "kernel_variants.hpp"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace tyndall::test {
namespace {

TEST(KernelVariants, EveryPairOfValuesThatCanOccurIsThere)
{
    const Choices counts = choice_counts();
    const std::vector<Choices> rows = covering_choices();
    std::set<std::tuple<std::size_t, int, std::size_t, int>> there;
    for (const Choices& row : rows) {
        EXPECT_EQ(allowed(row), row) << name_of(row);
        for (std::size_t a = 0; a < row.size(); ++a)
            for (std::size_t b = 0; b < row.size(); ++b) there.insert({a, row[a], b, row[b]});
    }
    std::size_t impossible = 0;
    for (std::size_t a = 0; a < counts.size(); ++a)
        for (std::size_t b = a + 1; b < counts.size(); ++b)
            for (int i = 0; i < counts[a]; ++i)
                for (int j = 0; j < counts[b]; ++j) {
                    Choices both(counts.size(), 1);  // what is forbidden without something else is allowed with everything
                    both[a] = i, both[b] = j;
                    for (int light = 0; light < counts[0]; ++light) {
                        if (a != 0) both[0] = light;
                        const Choices row = allowed(both);
                        if (row[a] == i && row[b] == j) EXPECT_TRUE(there.contains({a, i, b, j})) << a << '=' << i << ' ' << b << '=' << j;
                        else ++impossible;
                    }
                }
    EXPECT_GT(impossible, 0u);
    EXPECT_LE(rows.size(), 64u);
}

TEST(KernelVariants, AreTheSameEveryTime) { EXPECT_EQ(covering_choices(), covering_choices()); }

}  // namespace
}  // namespace tyndall::test
