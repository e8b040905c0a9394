#include "selftest/selftest_output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "planted_kernel.hpp"
#include "tyndall/error.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;

/// Two cases in two places; one of them failed, with a name that XML and terminals mind, and with numbers that JSON has not.
SelftestResult made_up()
{
    SelftestResult result;
    result.device.platform = "P", result.device.name = "D\x1b[31m";
    for (const auto& [where, lanes] : {std::pair("host float", 0), std::pair("device", 16)})
        for (const char* name : {"RowA", "RowB"}) result.outcomes.push_back({.name = name, .where = where, .lanes = lanes, .outputs = 10, .worst_ulp = 1.5, .seconds = .25});
    const double nan = std::nan("");
    result.outcomes[3].misses = 2;
    result.outcomes[3].first = SelftestMiss{.set = "a \"b\" <c> & \x01", .output = 1, .got = nan, .value = nan, .low = 0, .high = 1, .in = {1, INFINITY}};
    result.seconds = 1;
    return result;
}

TEST(SelftestOutput, JunitIsWellFormedAndCounts)
{
    pugi::xml_document document;
    const std::string text = to_junit(made_up());
    ASSERT_TRUE(document.load_string(text.c_str())) << text;
    const pugi::xml_node suites = document.child("testsuites");
    EXPECT_EQ(suites.attribute("tests").as_int(), 4);
    EXPECT_EQ(suites.attribute("failures").as_int(), 1);
    const auto suite = suites.child("testsuite").next_sibling();
    EXPECT_STREQ(suite.attribute("name").value(), "device, 16 lanes");
    EXPECT_EQ(suite.attribute("failures").as_int(), 1);
    EXPECT_DOUBLE_EQ(suite.attribute("time").as_double(), .5);
    const auto failed = suite.child("testcase").next_sibling();
    EXPECT_STREQ(failed.attribute("name").value(), "RowB");
    EXPECT_THAT(failed.child("failure").attribute("message").value(), HasSubstr("a \"b\" <c> & ?"));
    EXPECT_FALSE(suite.child("testcase").child("failure"));
}

TEST(SelftestOutput, JsonIsWellFormedWithoutNanLiterals)
{
    const auto json = nlohmann::json::parse(to_json(made_up(), "1.2"));
    EXPECT_EQ(json["schema"], "tyndall-selftest/1");
    EXPECT_EQ(json["version"], "1.2");
    EXPECT_EQ(json["passed"], false);
    ASSERT_EQ(json["cases"].size(), 4u);
    EXPECT_EQ(json["cases"][0]["lanes"], nullptr);
    EXPECT_EQ(json["cases"][0]["worst_ulp"], 1.5);
    EXPECT_EQ(json["cases"][3]["lanes"], 16);
    EXPECT_EQ(json["cases"][3]["first_outside"]["got"], nullptr);
    EXPECT_EQ(json["cases"][3]["first_outside"]["in"][1], nullptr);
}

TEST(SelftestOutput, TableNamesWhatIsOutsideAndHidesEscapeCodes)
{
    const std::string table = to_table(made_up());
    EXPECT_THAT(table, HasSubstr("OUTSIDE RowB (device, 16 lanes): output 1 of"));
    EXPECT_THAT(table, HasSubstr("1 of 4 results are outside their bounds"));
    EXPECT_EQ(table.find('\x1b'), std::string::npos);
}

TEST(Selftest, RunsTheChosenRowsInEveryPlace)
{
    const SelftestResult result = run_selftest({.only = {"row14", "HORIZON"}, .lanes = {1, 16}});
    EXPECT_TRUE(result.passed());
    ASSERT_EQ(result.outcomes.size(), 8u);
    EXPECT_EQ(result.outcomes[0].name, "Row14NarrowPhaseFunction");
    EXPECT_EQ(result.outcomes[1].name, "Row38SurfaceHorizon");
    EXPECT_EQ(place_of(result.outcomes[4]), "device, 1 lane");
    EXPECT_EQ(place_of(result.outcomes[7]), "device, 16 lanes");
    EXPECT_THROW(run_selftest({.only = {"no such row"}}), UsageError);
}

TEST(Selftest, AWrongKernelFailsOnTheDeviceAlone)
{
    const SelftestResult result = run_selftest({.only = {"row01", "row14"}, .lanes = {16}, .source = wrong_potentials()});
    EXPECT_FALSE(result.passed());
    for (const SelftestOutcome& o : result.outcomes) EXPECT_EQ(o.misses != 0, o.where == "device" && o.name.starts_with("Row01")) << o.name << " " << o.where;
    const SelftestOutcome& failed = result.outcomes[4];
    // 1e-5 is 84 epsilon, beside a bound of 6.
    EXPECT_GT(failed.worst_share, 10);
    EXPECT_GT(failed.worst_ulp, 60);
    EXPECT_NEAR(failed.worst_relative, 1e-5, 1e-6);
    ASSERT_EQ(result.failed.size(), 1u);
    EXPECT_EQ(result.failed[0].lanes, 16);
}

}  // namespace
}  // namespace tyndall::test
