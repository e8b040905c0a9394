#include "comparison/page_image.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>

#include "comparison/stage_costs.hpp"
#include "report/comparison_page.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// IEEE 754-2019, binary16, read by its definition.
double value_of(std::uint16_t bits)
{
    const int exponent = bits >> 10 & 31, mantissa = bits & 1023;
    const double value = exponent ? std::ldexp(1024 + mantissa, exponent - 25) : std::ldexp(mantissa, -24);
    return bits & 0x8000 ? -value : value;
}

TEST(PageImage, HalvesAreNearest)
{
    EXPECT_EQ(short_half(1), 0x3c00);
    EXPECT_EQ(short_half(-2), 0xc000);
    EXPECT_EQ(short_half(0), 0);
    EXPECT_EQ(short_half(65504), 0x7bff);
    EXPECT_EQ(short_half(1e9), 0x7bff);
    EXPECT_EQ(short_half(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(short_half(std::ldexp(1., -24)), 1);
    for (double x = 1e-7; x < 6e4; x *= 1.0173) {
        const double step = std::max(std::exp2(std::floor(std::log2(x)) - 7), std::exp2(-24));
        EXPECT_LE(std::abs(value_of(short_half(x)) - x), .5 * step * (1 + 1e-12)) << x;
        EXPECT_EQ(value_of(short_half(-x)), -value_of(short_half(x)));
    }
}

TEST(PageImage, RoundsUpAcrossAPowerOfTwo)
{
    EXPECT_EQ(value_of(short_half(1.9999)), 2);
    EXPECT_EQ(value_of(short_half(std::ldexp(1.9999, -15))), std::ldexp(1., -14)) << "out of the subnormal numbers";
}

TEST(PageImage, IsScaledSoThatNothingIsCutOff)
{
    for (const double size : {1e-20, 3., 1e12}) {
        const std::vector<Rgb> image{Rgb(size, 0, -size), Rgb(std::numeric_limits<double>::infinity())};
        const PageImage page = page_image(image, 2);
        const double largest = size * std::ldexp(1., -page.exponent);
        EXPECT_GE(largest, 1 << 14);
        EXPECT_LT(largest, 1 << 15);
        EXPECT_THAT(page.uri, testing::StartsWith("data:image/png;base64,iVBORw0KGgo"));
    }
    EXPECT_EQ(page_image(std::vector<Rgb>{Rgb(0)}, 1).exponent, 0);
}

TEST(Base64, IsThatOfTheStandard)
{
    // RFC 4648, section 10
    const std::pair<const char*, const char*> vectors[] = {{"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};
    for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
    EXPECT_EQ(base64("\xff\xff\xfe"), "///+");
}

TEST(ComparisonPage, HoldsTheDataAndCannotBeBrokenOutOf)
{
    const std::string page = comparison_page(R"({"scene": "</script><script>alert(1)</script>"})");
    EXPECT_THAT(page, HasSubstr(R"({"scene": "\u003c/script>\u003cscript>alert(1)\u003c/script>"})"));
    EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
    for (const char* place : {"/*style*/", "/*scripts*/", "/*data*/"}) EXPECT_THAT(page, Not(HasSubstr(place)));
    EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
    EXPECT_THAT(page, Not(HasSubstr("@import")));
}

TEST(StageCosts, SumToTheSecondsOfTheRender)
{
    Report report{.seconds = 10, .before_seconds = 1};
    report.stages = {{"pilot", .2}, {"build_kernels", .7}, {"trace_eyes", .5}, {"trace_lights", .5}, {"media_to_media", 5}, {"trace_paths", 2},
                     {"media_to_media.sample_pairs", 1}, {"media_to_media.accumulate_pairs", .5}, {"shadow_segments", 2}};
    std::map<std::string, double> costs;
    double sum = 0;
    for (const StageCost& cost : stage_costs(report)) costs[cost.stage] = cost.seconds, sum += cost.seconds;
    EXPECT_DOUBLE_EQ(sum, 10);
    EXPECT_EQ(costs.at("prepare"), 1);
    EXPECT_EQ(costs.at("trace"), 3);
    EXPECT_EQ(costs.at("sample"), 1);
    EXPECT_EQ(costs.at("shadow"), 2);
    EXPECT_EQ(costs.at("accumulate"), .5);
    EXPECT_EQ(costs.at("transfer"), 1.5);
    EXPECT_EQ(costs.at("rest"), 1);
}

}  // namespace
}  // namespace tyndall::test
