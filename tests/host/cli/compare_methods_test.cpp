#include <nlohmann/json.hpp>

#include <csignal>
#include <limits>

#include "film/exr.hpp"
#include "program_fixture.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

class CompareMethods : public Program {
protected:
    std::string text_of(const std::string& name)
    {
        std::ifstream stream(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    std::vector<std::string> compare(std::vector<std::string> more)
    {
        more.insert(more.begin(), {"compare", "scene.xml", "--methods", "path", "--times", ".05,.1", "--repeats", "2", "--reference-time", ".2"});
        return more;
    }
};

TEST_F(CompareMethods, WritesPageDataAndReference)
{
    const auto result = run(compare({"-o", "page", "--seed", "5"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "page/index.html\npage/comparison.json\n");
    const Json json = Json::parse(text_of("page/comparison.json"));
    EXPECT_EQ(json.at("schema"), "tyndall-comparison/1");
    EXPECT_EQ(json.at("times"), Json({.05, .1}));
    EXPECT_EQ(json.at("repeats"), 2);
    const Json& path = json.at("candidates").at(0);
    EXPECT_EQ(path.at("name"), "path");
    EXPECT_EQ(path.at("runs").at(0).at("seed"), "6");
    EXPECT_EQ(path.at("runs").at(1).at("seed"), "7");
    EXPECT_EQ(path.at("render_command"), "tyndall render scene.xml --method path");
    EXPECT_GT(path.at("at_times").at(1).at("relative_mse").at("median"), 0);
    EXPECT_FALSE(path.at("bias").at("significant"));
    EXPECT_THAT(text_of("page/index.html"), HasSubstr("data:image/png;base64,"));
    const auto reference = read_exr(folder / "page/reference.exr");
    EXPECT_EQ(std::get<std::string>(reference.attributes.at("tyndall.method")), "path");
    EXPECT_EQ(std::get<std::string>(reference.attributes.at("tyndall.seed")), "5");
    EXPECT_THAT(json.at("command"), HasSubstr("--times .05,.1"));
}

TEST_F(CompareMethods, TakesItsOwnReferenceAgain)
{
    ASSERT_EQ(run(compare({"-o", "page"})).exit_code, 0);
    const auto result = run(compare({"-o", "again", "--reference", "page/reference.exr", "--seed", "50", "--json"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("warning")));
    const Json json = Json::parse(result.out);
    EXPECT_TRUE(json.at("reference").at("error_known"));
    EXPECT_GT(json.at("reference").at("relative_mse"), 0);
    EXPECT_FALSE(json.at("candidates").at(0).at("layers").empty());
}

TEST_F(CompareMethods, DialsAreOfMethodsThatHaveThem)
{
    const auto two = run({"compare", "scene.xml", "--dials", "--methods", "vrl,path", "-o", "page"});
    EXPECT_EQ(two.exit_code, 2);
    EXPECT_THAT(two.err, HasSubstr("every dial of one method"));
    const auto path = run({"compare", "scene.xml", "--dials", "--methods", "path", "-o", "page"});
    EXPECT_EQ(path.exit_code, 2);
    EXPECT_THAT(path.err, HasSubstr("\"path\" has none"));
    const auto precision = run({"compare", "scene.xml", "--precisions", "f16", "-o", "page"});
    EXPECT_EQ(precision.exit_code, 2);
    EXPECT_THAT(precision.err, HasSubstr("f64"));
    EXPECT_EQ(run({"compare", "scene.xml", "--clamps", "0", "-o", "page"}).exit_code, 2);
    EXPECT_EQ(run({"compare", "scene.xml", "--beam-radii", "2", "-o", "page"}).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "page"));
}

TEST_F(CompareMethods, OneLayerIsComparedAlone)
{
    const auto result = run(compare({"-o", "page", "--layer", "single", "--json"}));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json.at("layer"), "single");
    EXPECT_THAT(json.at("candidates").at(0).at("render_command"), HasSubstr("--layer single"));
    EXPECT_EQ(json.at("candidates").at(0).at("layers").size(), 1u);
}

TEST_F(CompareMethods, UnknownAndEmptyMethodsNameThoseThatThereAre)
{
    for (const char* method : {"vrll", ""}) {
        const auto result = run({"compare", "scene.xml", "--methods", method});
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_THAT(result.err, HasSubstr("must be one of vrl, "));
    }
    EXPECT_EQ(run({"compare", "scene.xml", "--methods", "path,path"}).exit_code, 2);
    EXPECT_EQ(run({"compare", "scene.xml", "--times", "0"}).exit_code, 2);
    EXPECT_EQ(run({"compare", "scene.xml", "--tolerance", "1%"}).exit_code, 2);
}

TEST_F(CompareMethods, AnUnwritableFolderIsFoundBeforeMeasuring)
{
    write_file("file", "not a folder");
    const auto result = run(compare({"-o", "file/page"}));
    EXPECT_EQ(result.exit_code, 6);
    EXPECT_THAT(result.err, HasSubstr("the folder cannot be made"));
    EXPECT_THAT(result.err, Not(HasSubstr("run 1")));
}

TEST_F(CompareMethods, ReferencesThatDoNotFitAreRefusedOrWarnedOf)
{
    ASSERT_EQ(run({"render", "scene.xml", "--method", "path", "--passes", "4", "-o", "good.exr"}).exit_code, 0);
    const auto size = run(compare({"-o", "page", "--reference", "good.exr", "--resolution", "8x8"}));
    EXPECT_EQ(size.exit_code, 3);
    EXPECT_THAT(size.err, HasSubstr("scene.xml: shows 8 x 8 pixels at (0, 0), but good.exr shows 16 x 12"));
    const auto other = run(compare({"-o", "page", "--reference", "good.exr", "-D", "density=2"}));
    EXPECT_EQ(other.exit_code, 0);
    EXPECT_THAT(other.err, HasSubstr("rendered from another scene"));
    EXPECT_THAT(text_of("page/index.html"), HasSubstr("rendered from another scene"));
    ExrImage bad = read_exr(folder / "good.exr");
    bad.channels.at("R").values[0] = std::numeric_limits<float>::quiet_NaN();
    write_exr(folder / "bad.exr", bad);
    const auto nan = run(compare({"-o", "page", "--reference", "bad.exr"}));
    EXPECT_EQ(nan.exit_code, 3);
    EXPECT_THAT(nan.err, HasSubstr("not finite, the first is nan in channel R at pixel (0, 0)"));
    EXPECT_EQ(run(compare({"-o", "page", "--reference", "none.exr"})).exit_code, 6);
}

TEST_F(CompareMethods, AnInterruptBeforeTheFirstRunWritesNothing)
{
    ChildProcess process(command({"compare", "scene.xml", "--methods", "path", "--reference-time", "60", "-o", "page"}), here());
    ASSERT_TRUE(process.wait_for_error_text("reference: path"));
    process.send(SIGINT);
    const auto result = process.wait();
    EXPECT_NE(result.exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "page/index.html"));
}

TEST_F(CompareMethods, AnInterruptKeepsWholeRepeats)
{
    ChildProcess process(command({"compare", "scene.xml", "--methods", "path", "--times", ".2", "--repeats", "200", "--reference-time", ".2", "-o", "page"}), here());
    ASSERT_TRUE(process.wait_for_error_text("run 3 of 200"));
    process.send(SIGINT);
    EXPECT_EQ(process.wait().exit_code, 130);
    const int repeats = Json::parse(text_of("page/comparison.json")).at("repeats");
    EXPECT_GE(repeats, 2);
    EXPECT_LT(repeats, 200);
}

}  // namespace
}  // namespace tyndall::test
