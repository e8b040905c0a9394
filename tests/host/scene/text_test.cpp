#include "scene/text.hpp"

#include <gtest/gtest.h>

#include "support/comma_locale.hpp"

namespace tyndall {

TEST(SceneText, RealsAreStrict)
{
    EXPECT_EQ(parse_real("0.25"), .25);
    EXPECT_EQ(parse_real(" +1e-3 "), 1e-3);
    EXPECT_EQ(parse_real("-7"), -7.);
    for (const char* wrong : {"", " ", "nan", "inf", "-inf", "1e400", "1,5", "0x10", "1.5x", "+-1", "++1", "1 2", "infinity"})
        EXPECT_FALSE(parse_real(wrong).has_value()) << wrong;
}

TEST(SceneText, RealsDoNotListenToTheLocale)
{
    const test::CommaLocale comma;
    EXPECT_EQ(parse_real("1.5"), 1.5);
    EXPECT_FALSE(parse_real("1,5").has_value());
}

TEST(SceneText, IntegersAreStrict)
{
    EXPECT_EQ(parse_integer("-12"), -12);
    EXPECT_EQ(parse_integer("+12"), 12);
    for (const char* wrong : {"", "1.0", "1e3", "99999999999999999999", "0x1", "a"})
        EXPECT_FALSE(parse_integer(wrong).has_value()) << wrong;
}

TEST(SceneText, ListsSplitAtBlanksAndCommas)
{
    EXPECT_EQ(split_list(" 1, 2,\t3\n4 "), (std::vector<std::string_view>{"1", "2", "3", "4"}));
    EXPECT_TRUE(split_list(" ,, ").empty());
}

TEST(SceneText, EditDistanceCountsSlips)
{
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("sigma_t", "sigma_t"), 0u);
    EXPECT_EQ(edit_distance("sigmat", "sigma_t"), 1u);
    EXPECT_EQ(edit_distance("widht", "width"), 1u);  // neighbours swapped
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(SceneText, SuggestsTheNearestNameOnlyIfItIsNear)
{
    EXPECT_EQ(suggestion("albdo", {"sigma_t", "albedo", "scale"}), " (did you mean \"albedo\"?)");
    EXPECT_EQ(suggestion("colour", {"sigma_t", "albedo", "scale"}), "");
}

TEST(SceneText, MessagesCarryNoEscapeCodes)
{
    EXPECT_EQ(printable("a\x1b[31mb\n"), "a\\x1b[31mb\\x0a");
    EXPECT_EQ(printable("caf\xc3\xa9"), "caf\xc3\xa9");
    EXPECT_EQ(printable("\xc2\x9b\xff"), "\\xc2\\x9b\\xff");  // C1 control, invalid byte
    EXPECT_EQ(printable(std::string(1000, 'x')).size(), 203u);
}

TEST(SceneText, PlacesAreWrittenFileLineColumn)
{
    EXPECT_EQ(to_string(SourceLocation{"a.xml", 3, 7}), "a.xml:3:7");
    EXPECT_EQ(to_string(SourceLocation{}), "scene built in memory");
}

}  // namespace tyndall
