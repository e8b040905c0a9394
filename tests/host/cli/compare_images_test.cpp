#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

#include "film/exr.hpp"
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

constexpr int width = 16, height = 16;

/// Grey images of a known value, with a layer and variances.
ExrImage grey(float value)
{
    ExrImage image{.width = width, .height = height, .display_width = width, .display_height = height};
    const std::vector<float> values(width * height, value);
    for (const char* prefix : {"", "single."})
        for (const char* colour : {"R", "G", "B"}) image.channels[std::string(prefix) + colour].values = values;
    for (const char* channel : {"variance.R", "variance.G", "variance.B"}) image.channels[channel].values.assign(values.size(), .0001f);
    image.attributes["tyndall.scene_hash"] = std::string("aa");
    return image;
}

class CompareImages : public Program {
protected:
    void write(const char* name, const ExrImage& image) { write_exr(folder / name, image); }
};

TEST_F(CompareImages, SaysHowFarTheyAreApart)
{
    write("a.exr", grey(1.03125f)), write("b.exr", grey(1));
    const auto result = run({"compare", "a.exr", "b.exr", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json json = Json::parse(result.out);
    const double difference = 1. / 32, relative_mse = difference * difference / (1 + .0025);  // exact in float
    EXPECT_EQ(json.at("schema"), "tyndall-image-comparison/1");
    EXPECT_NEAR(json.at("relative_mse"), relative_mse, 1e-12);
    EXPECT_NEAR(json.at("error"), std::sqrt(relative_mse), 1e-12);
    EXPECT_NEAR(json.at("rmse"), difference, 1e-12);
    EXPECT_NEAR(json.at("bias"), difference, 1e-12);
    EXPECT_NEAR(json.at("noise_relative_mse"), .0002 / 1.0025, 1e-9);
    EXPECT_NEAR(json.at("bias_error")[0], std::sqrt(.0002 / (width * height)), 1e-8);
    EXPECT_NEAR(json.at("bias_error")[1], std::sqrt(.0002), 1e-8);
    EXPECT_NEAR(json.at("worst_block").at("relative"), difference, 1e-12);
    EXPECT_THAT(run({"compare", "a.exr", "b.exr"}).out, HasSubstr("+3.125 %"));
}

TEST_F(CompareImages, OutsideTheToleranceIsExitCode8)
{
    write("a.exr", grey(1.03125f)), write("b.exr", grey(1));
    EXPECT_EQ(run({"compare", "a.exr", "b.exr", "--tolerance", "3.2%"}).exit_code, 0);
    const auto result = run({"compare", "a.exr", "b.exr", "--tolerance", "3%"});
    EXPECT_EQ(result.exit_code, 8);
    EXPECT_THAT(result.err, HasSubstr("above the tolerance of 3.00 %"));
    EXPECT_THAT(result.out, HasSubstr("relMSE"));
}

TEST_F(CompareImages, LayersAreComparedAloneAndSummed)
{
    ExrImage a = grey(1), b = grey(1);
    a.channels["single.G"].values[17] = 3;
    write("a.exr", a), write("b.exr", b);
    EXPECT_EQ(run({"compare", "a.exr", "b.exr", "--tolerance", "0"}).exit_code, 0);
    const auto layer = run({"compare", "a.exr", "b.exr", "--layer", "single", "--tolerance", "0", "--json"});
    EXPECT_EQ(layer.exit_code, 8);
    EXPECT_EQ(Json::parse(layer.out).at("worst_pixel").at("x"), 1);
    EXPECT_EQ(Json::parse(layer.out).at("worst_pixel").at("y"), 1);
    EXPECT_THAT(layer.err, HasSubstr("outliers"));
    const Json sum = Json::parse(run({"compare", "a.exr", "b.exr", "--layer", "image,single", "--json"}).out);
    EXPECT_NEAR(sum.at("reference_mean"), 2, 1e-12);
    EXPECT_TRUE(sum.at("noise_relative_mse").is_null()) << "variances are known of the image alone";
}

TEST_F(CompareImages, MissingLayerIsNamedWithThoseThatThereAre)
{
    write("a.exr", grey(1)), write("b.exr", grey(1));
    const auto result = run({"compare", "a.exr", "b.exr", "--layer", "sngle"});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr("a.exr: has no layer \"sngle\" (did you mean \"single\"?)"));
    EXPECT_THAT(result.err, HasSubstr("image, single"));
}

TEST_F(CompareImages, DifferentSizesAreRefused)
{
    ExrImage small = grey(1);
    small.height = 8;
    for (auto& [name, channel] : small.channels) channel.values.resize(width * 8);
    write("a.exr", small), write("b.exr", grey(1));
    const auto result = run({"compare", "a.exr", "b.exr"});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr("a.exr: shows 16 x 8 pixels at (0, 0), but b.exr shows 16 x 16 pixels"));
    EXPECT_THAT(result.err, HasSubstr("--resolution"));
}

TEST_F(CompareImages, NaNIsRefusedWithItsPlace)
{
    ExrImage bad = grey(1);
    bad.channels["G"].values[width + 5] = std::numeric_limits<float>::quiet_NaN();
    bad.channels["G"].values[width + 6] = std::numeric_limits<float>::infinity();
    write("a.exr", grey(1)), write("bad.exr", bad);
    for (const auto& arguments : {std::vector<std::string>{"compare", "a.exr", "bad.exr"}, {"compare", "bad.exr", "a.exr"}}) {
        const auto result = run(arguments);
        EXPECT_EQ(result.exit_code, 3);
        EXPECT_THAT(result.err, HasSubstr("bad.exr: 2 values are not finite, the first is nan in channel G at pixel (5, 1)"));
    }
    EXPECT_EQ(run({"compare", "a.exr", "bad.exr", "--layer", "single"}).exit_code, 0) << "the layer is whole";
}

TEST_F(CompareImages, AnotherSceneIsAWarning)
{
    ExrImage other = grey(1);
    other.attributes["tyndall.scene_hash"] = std::string("bb");
    write("a.exr", grey(1)), write("b.exr", other);
    const auto result = run({"compare", "a.exr", "b.exr"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("scenes that differ (hash aa and bb)"));
    EXPECT_THAT(run({"compare", "a.exr", "a.exr"}).err, Not(HasSubstr("warning")));
}

TEST_F(CompareImages, FilesThatAreNotThereAndHalfAQuestionAreExplained)
{
    write("a.exr", grey(1));
    EXPECT_EQ(run({"compare", "a.exr", "none.exr"}).exit_code, 6);
    const auto half = run({"compare", "a.exr"});
    EXPECT_EQ(half.exit_code, 2);
    EXPECT_THAT(half.err, HasSubstr("two images"));
    EXPECT_EQ(run({"compare", "a.exr", "a.exr", "--tolerance", "-1"}).exit_code, 2);
}

TEST_F(CompareImages, RendersOfOneSceneDifferByTheirNoise)
{
    for (const char* seed : {"1", "2"})
        ASSERT_EQ(run({"render", "scene.xml", "--method", "path", "--passes", "64", "--seed", seed, "-o", std::string(seed) + ".exr"}).exit_code, 0);
    const Json json = Json::parse(run({"compare", "1.exr", "2.exr", "--json"}).out);
    const double ratio = json.at("relative_mse").get<double>() / json.at("noise_relative_mse").get<double>();
    EXPECT_GT(ratio, .5) << "576 values, of heavy-tailed noise";
    EXPECT_LT(ratio, 2);
}

}  // namespace
}  // namespace tyndall::test
