/// The document that lists the effects says what the program knows.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "scene/scene_features.hpp"

namespace tyndall::test {
namespace {

std::string table()
{
    std::string rows = "| effect | | what it means | without it there is no work for |\n|---|---|---|---|\n";
    for (const EffectRow& row : effect_list())
        rows += "| `" + std::string(row.name) + "` | " + (row.bit ? "kernel" : "fact") + " | " + std::string(row.meaning) + " | " + std::string(row.saving) + " |\n";
    return rows + "\n";
}

TEST(FeaturesDocument, HasTheTableOfTheProgramsOwnList)
{
    std::ifstream file(std::string(TYNDALL_SOURCE_DIR) + "/host/docs/features.md");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_NE(text.str().find(table()), std::string::npos) << "the table must be\n" << table();
}

TEST(EffectList, SaysEverythingOnceAndInWords)
{
    std::vector<std::string_view> names;
    for (const EffectRow& row : effect_list()) {
        EXPECT_EQ(std::count(names.begin(), names.end(), row.name), 0) << row.name;
        names.push_back(row.name);
        EXPECT_FALSE(row.meaning.empty()) << row.name;
        EXPECT_TRUE(row.bit == 0 || !row.saving.empty()) << row.name << ": a kernel feature must save something";
    }
}

}  // namespace
}  // namespace tyndall::test
