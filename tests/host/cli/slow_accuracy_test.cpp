/// `tyndall bench --accuracy` as a user runs it.
#include <nlohmann/json.hpp>

#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using Json = nlohmann::json;

class Accuracy : public Program {};

TEST_F(Accuracy, EveryDialIsPricedOnTheSceneThatComesAlong)
{
    const auto result = run({"bench", "--accuracy", "--time", "60", "--repeats", "2", "-o", "dials", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json json = Json::parse(result.out);
    ASSERT_GE(json.at("dials").size(), 10u);
    std::size_t values = 0;
    for (const Json& dial : json.at("dials")) values += dial.at("values").size();
    EXPECT_EQ(json.at("candidates").size(), values + 1);
    EXPECT_LE(json.at("verdicts").size(), values) << "pairs with the usual value alone";
    EXPECT_EQ(json.at("candidates").at(0).at("name"), "vrl");
    for (const char* file : {"index.html", "comparison.json", "scene.xml", "reference.exr"}) EXPECT_TRUE(std::filesystem::exists(folder / "dials" / file)) << file;
    EXPECT_THAT(result.err, testing::HasSubstr("kernel arithmetic"));
    const auto again = run({"render", "dials/scene.xml", "--passes", "1", "--resolution", "8x8"});
    EXPECT_EQ(again.exit_code, 0) << "the scene stands alone: " << again.err;
}

}  // namespace
}  // namespace tyndall::test
