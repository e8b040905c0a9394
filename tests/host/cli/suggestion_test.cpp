#include "cli/suggestion.hpp"

#include <gtest/gtest.h>

namespace tyndall {
namespace {

const std::vector<std::string> known{"passes", "progress", "resolution", "crop"};

TEST(Suggestion, FindsInsertionsDeletionsReplacementsAndSwaps)
{
    EXPECT_EQ(nearest_name("pases", known), "passes");
    EXPECT_EQ(nearest_name("passses", known), "passes");
    EXPECT_EQ(nearest_name("pasfes", known), "passes");
    EXPECT_EQ(nearest_name("corp", known), "crop");
    EXPECT_EQ(nearest_name("resoluton", known), "resolution");
}

TEST(Suggestion, IsSilentWhenNothingIsNear)
{
    EXPECT_EQ(nearest_name("quantum", known), "");
    EXPECT_EQ(suggestion("quantum", known), "");
    EXPECT_EQ(nearest_name(std::string(100000, 'x'), known), "");
    EXPECT_EQ(nearest_name("x", {}), "");
}

TEST(Suggestion, ReadsAsAQuestion) { EXPECT_EQ(suggestion("pases", known), "; did you mean \"passes\"?"); }

}  // namespace
}  // namespace tyndall
