#include "cli/config_file.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

using testing::HasSubstr;

class ConfigFile : public testing::Test {
protected:
    std::vector<ConfigValue> read(const std::string& text)
    {
        std::ofstream(folder / "site.conf", std::ios::binary) << text;
        return read_config(folder / "site.conf");
    }
    std::string fault(const std::string& text)
    {
        try {
            read(text);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "no error";
    }
    test::TemporaryFolder folder;
};

TEST_F(ConfigFile, LinesAreNamesAndValues)
{
    const auto values = read("# a comment\n\n passes = 64\r\ntarget-error=1%  # in time\n[bench]\n\tlanes = 1,4\n# end");
    ASSERT_EQ(values.size(), 3u);
    EXPECT_EQ(values[0].option + " " + values[0].value + " " + values[0].section, "passes 64 ");
    EXPECT_EQ(to_string(values[0].where), (folder / "site.conf").string() + ":3:2");
    EXPECT_EQ(values[1].option + " " + values[1].value + " " + values[1].section, "target-error 1% ");
    EXPECT_EQ(values[2].option + " " + values[2].value + " " + values[2].section, "lanes 1,4 bench");
    EXPECT_TRUE(read("").empty());
}

TEST_F(ConfigFile, QuotesKeepWhatElseWouldBeLost)
{
    EXPECT_EQ(read("device = \"a # b\" # not this")[0].value, "a # b");
    EXPECT_EQ(read("device = a#b")[0].value, "a#b");
    EXPECT_EQ(read("device = \"\"")[0].value, "");
    EXPECT_EQ(read(R"(output = "a \"b\" \\ c\d")")[0].value, R"(a "b" \ c\d)");
    EXPECT_EQ(read("define = density=2")[0].value, "density=2");
}

TEST_F(ConfigFile, WhatIsWrittenIsReadBack)
{
    for (const std::string value : {"64", "", " ", "a b", "#", "a # b", "\"", "\\", "\\\"x\\\\", "1%", "density=2", "a\tb"})
        EXPECT_EQ(read("define = " + config_text(value) + "   # source")[0].value, value) << config_text(value);
}

TEST_F(ConfigFile, MistakesHaveTheirPlace)
{
    const std::string file = (folder / "site.conf").string();
    const std::pair<const char*, const char*> cases[] = {
        {"passes", ":1:1: \"passes\" has no value"},
        {"\n  --passes = 3", ":2:3: \"--passes\" is no name of an option"},
        {"passes =", ":1:1: \"passes\" has an empty value"},
        {"passes = # 3", ":1:1: \"passes\" has an empty value"},
        {"device = \"a", ":1:1: the quote is not closed"},
        {"device = \"a\" b", ":1:1: something follows the closing quote"},
        {"[bench", ":1:1: a section must be"},
        {"[ben ch]", ":1:1: \"ben ch\" is no name of a command"},
        {"= 3", ":1:1: \"\" is no name of an option"},
        {"\x1b[2J = 3", ":1:1: \"\\x1b[2J\" is no name of an option"},
    };
    for (const auto& [text, sentence] : cases) EXPECT_THAT(fault(text), HasSubstr(sentence)) << text;
    for (const auto& [text, sentence] : cases) EXPECT_THAT(fault(text), testing::StartsWith(file));
}

TEST_F(ConfigFile, WhatIsNoFileOfThatSizeIsRefused)
{
    EXPECT_THROW(read_config(folder / "missing"), UsageError);
    EXPECT_THROW(read_config(folder.path()), UsageError);
    EXPECT_THROW(read_config("/dev/zero"), UsageError);
    EXPECT_THROW(read(std::string((1u << 20) + 1, '#')), UsageError);
}

}  // namespace
}  // namespace tyndall
