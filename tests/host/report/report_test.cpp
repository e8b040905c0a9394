#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "report/readable.hpp"
#include "report/report_output.hpp"

namespace tyndall {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

Report full_report()
{
    Report report;
    report.version = "0.1.0 (abc)";
    report.scene = "juice/scene.xml";
    report.method = "vrl";
    report.device = "a device", report.driver = "1.2", report.build_options = "-DLANES=16";
    report.scene_hash = 0xfedcba9876543210u, report.seed = std::numeric_limits<std::uint64_t>::max();
    report.width = 64, report.height = 48, report.passes = 7, report.threads = 2, report.lanes = 16, report.max_depth = 5;
    report.pairs = 3000000, report.shadow_segments = 1000000, report.seconds = 2, report.error = .0124;
    report.stopped_by = "time";
    report.effects = {{"ANISOTROPIC", true}, {"OCCLUDERS", false}};
    report.layers = {{"single", "equi-angular", false, "", true}, {"surface_direct", "skipped", true, "no surface reflects", true}};
    report.stages = {{"sample_pairs", 1.5, 3000000}, {"film", 0, 7}};
    report.warnings = {"scene.xml:1:2: careful"};
    report.exposure = -1.5;
    report.outputs = {"a.exr"};
    return report;
}

TEST(ReportJson, HasTheKeysOfItsSchema)
{
    const auto report = json::parse(to_json(full_report()));
    EXPECT_EQ(report.at("schema"), "tyndall-report/1");
    for (const auto* key :
         {"version", "scene",    "method",  "seed",   "width",  "height",  "passes", "max_depth", "threads",  "device", "stopped_by",
          "error",   "exposure", "timings", "counts", "stages", "effects", "layers", "numerics",  "warnings", "outputs"})
        EXPECT_TRUE(report.contains(key)) << key;
    for (const auto* key : {"light_paths", "virtual_lights", "eye_segments", "eye_points", "pairs", "shadow_segments", "launches"})
        EXPECT_TRUE(report.at("counts").at(key).is_number_unsigned()) << key;
    for (const auto* key :
         {"not_finite_pixels", "not_finite_pairs", "unsafe_shadow_segments", "floored_pairs", "runaway_walks", "worst_pair", "first_cases"})
        EXPECT_TRUE(report.at("numerics").contains(key)) << key;
}

TEST(ReportJson, KeepsValuesExactly)
{
    const auto report = json::parse(to_json(full_report()));
    EXPECT_EQ(report.at("seed"), "18446744073709551615");
    EXPECT_EQ(report.at("scene").at("hash"), "fedcba9876543210");
    EXPECT_EQ(report.at("error"), .0124);
    EXPECT_EQ(report.at("timings").at("pairs_per_second"), 1.5e6);
    EXPECT_EQ(report.at("device").at("lanes"), 16);
    EXPECT_EQ(report.at("effects").at("ANISOTROPIC"), true);
    EXPECT_EQ(report.at("layers")[1].at("why"), "no surface reflects");
    EXPECT_EQ(report.at("stages")[0].at("per_second"), 2e6);
    EXPECT_EQ(report.at("stages")[1].at("per_second"), nullptr);  // no time was taken
}

TEST(ReportJson, UnknownAndNotFiniteNumbersAreNull)
{
    auto report = full_report();
    report.error = -1, report.max_depth = -1, report.exposure.reset();
    report.seconds = std::numeric_limits<double>::quiet_NaN(), report.pass_seconds = std::numeric_limits<double>::infinity();
    const auto text = to_json(report);
    const auto parsed = json::parse(text);  // refuses NaN and Infinity literals
    for (const auto* key : {"error", "max_depth", "exposure"}) EXPECT_TRUE(parsed.at(key).is_null()) << key;
    for (const auto* key : {"seconds", "pass_seconds", "pairs_per_second"}) EXPECT_TRUE(parsed.at("timings").at(key).is_null()) << key;
    EXPECT_THAT(text, Not(HasSubstr("nan")));
    EXPECT_THAT(text, Not(HasSubstr("inf")));
}

TEST(ReportJson, SurvivesHostileNames)
{
    auto report = full_report();
    report.scene = "a\x1b[31m\"\n\xff.xml";
    const auto text = to_json(report);
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_THAT(json::parse(text).at("scene").at("file").get<std::string>(), HasSubstr(".xml"));
}

TEST(ReportJson, AnEmptyReportIsValidToo) { EXPECT_TRUE(json::parse(to_json(Report{})).at("device").is_null()); }

TEST(ReportTable, NamesWhatAReaderAsksFor)
{
    const auto table = to_table(full_report());
    for (const auto* text : {"juice/scene.xml", "64 x 48, 7 passes", "a device, 16 lanes", "stopped by time", "1.24 %", "3.00 M (1.50 M/s)",
                             "effects found    ANISOTROPIC", "not in the scene OCCLUDERS", "equi-angular", "skipped: no surface reflects",
                             "sample_pairs", "75.0 %", "warning: scene.xml:1:2: careful", "wrote a.exr", "-1.50 stops"})
        EXPECT_THAT(table, HasSubstr(text));
    EXPECT_THAT(table, Not(HasSubstr("numerics")));
}

TEST(ReportTable, TellsOfNumbersThatWereNotFinite)
{
    auto report = full_report();
    report.ledger.not_finite_pairs = 3;
    report.ledger.first_cases = {"pixel (1, 2), light 3"};
    EXPECT_THAT(to_table(report), HasSubstr("3 pairs were not finite and count as 0"));
    EXPECT_THAT(to_table(report), HasSubstr("pixel (1, 2), light 3"));
}

TEST(ReportTable, EscapesControlCharacters)
{
    auto report = full_report();
    report.device = "evil\x1b]0;title\x07";
    EXPECT_EQ(to_table(report).find('\x1b'), std::string::npos);
    EXPECT_THAT(to_table(report), HasSubstr("evil\\x1b]0;title\\x07"));
}

TEST(Readable, CountsHaveThreeDigits)
{
    EXPECT_EQ(readable_count(0), "0");
    EXPECT_EQ(readable_count(999), "999");
    EXPECT_EQ(readable_count(999.7), "1.00 K");
    EXPECT_EQ(readable_count(1234), "1.23 K");
    EXPECT_EQ(readable_count(99960), "100 K");
    EXPECT_EQ(readable_count(45.678e6), "45.7 M");
    EXPECT_EQ(readable_count(7.89e9), "7.89 G");
    EXPECT_EQ(readable_count(std::numeric_limits<double>::infinity()), "unknown");
}

TEST(Readable, SecondsMinutesHours)
{
    EXPECT_EQ(readable_seconds(.4213), "0.42 s");
    EXPECT_EQ(readable_seconds(59.96), "60.0 s");
    EXPECT_EQ(readable_seconds(185.2), "3 min 05 s");
    EXPECT_EQ(readable_seconds(7625), "2 h 07 min");
    EXPECT_EQ(readable_seconds(-1), "unknown");
}

TEST(Readable, PercentAndUnknown)
{
    EXPECT_EQ(readable_percent(.01239), "1.24 %");
    EXPECT_EQ(readable_percent(-1), "unknown");
}

TEST(Readable, TerminalSafeKeepsUtf8AndEscapesControls)
{
    EXPECT_EQ(terminal_safe("Nov\xc3\xa1k"), "Nov\xc3\xa1k");
    EXPECT_EQ(terminal_safe("a\tb\x7f"), "a\\x09b\\x7f");
    EXPECT_EQ(terminal_safe("\xc2\x9b"
                            "31m"),
              "\\x9b31m");  // the one-character form of ESC [
}

}  // namespace
}  // namespace tyndall
