// Textures in scenes: what is looked up where, and what is refused.
#include <gmock/gmock.h>

#include <fstream>
#include <iterator>
#include <limits>

#include "scene/describe.hpp"
#include "scene/picture_files.hpp"
#include "scene/texture_lookup.hpp"
#include "scene_text.hpp"
#include "tests/support/picture_file.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Scenes in a folder with pictures. The bsdf's tag is line 2, what stands inside starts line 3.
class Textures : public testing::Test {
protected:
    TemporaryFolder folder;

    /// 4 x 2: red is the column over 4, green the row over 2, blue .1.
    Textures()
    {
        std::vector<float> values;
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 4; ++x) values.insert(values.end(), {static_cast<float>(x) / 4, static_cast<float>(y) / 2, .1f});
        exr("steps.exr", 4, 2, {"R", "G", "B"}, values);
    }
    void exr(const std::string& name, int width, int height, const std::vector<std::string>& channels, const std::vector<float>& values) const
    {
        folder.write(name, exr_bytes(width, height, channels, values, folder.path() / "scratch.exr"));
    }
    void png(const std::string& name, const PngFile& file) const { folder.write(name, png_bytes(file)); }

    static std::string bitmap(const std::string& file, const std::string& rest = "", const std::string& role = "reflectance")
    {
        return "<texture type=\"bitmap\" name=\"" + role + "\"><string name=\"filename\" value=\"" + file + "\"/>" + rest + "</texture>";
    }
    std::filesystem::path scene(const std::string& inside, const std::string& type = "diffuse", const std::string& shape = "<shape type=\"rectangle\">") const
    {
        return folder.write("scene.xml", "<scene version=\"3.0.0\">" + plain_sensor + "\n<bsdf type=\"" + type + "\" id=\"painted\">\n" + inside + "</bsdf>" + shape + "<ref id=\"painted\"/></shape></scene>");
    }
    Scene load(const std::string& inside, const std::string& type = "diffuse") const { return load_scene(scene(inside, type)); }
    Texture texture(const std::string& inside) const { return load(inside).textures.at(0); }
    /// Without the folder's name.
    std::string fault(const std::string& inside, const std::string& type = "diffuse") const
    {
        const std::string message = fault_of_file(scene(inside, type)), place = folder.path().string() + "/";
        return message.starts_with(place) ? message.substr(place.size()) : message;
    }
};

/// Red and green as Mitsuba 3.9.1 evaluates the same texture with the same file.
TEST_F(Textures, BitmapsAreLookedUpAsMitsubaDoes)
{
    struct Row {
        Vec2 uv;
        double nearest[3][2], bilinear[3][2];  // repeat, mirror, clamp
    };
    const Row rows[] = {{{0, 0}, {{0, 0}, {0, 0}, {0, 0}}, {{.375, .25}, {0, 0}, {0, 0}}},
                        {{.1, .25}, {{0, 0}, {0, 0}, {0, 0}}, {{.075, 0}, {0, 0}, {0, 0}}},
                        {{.25, .25}, {{.25, 0}, {.25, 0}, {.25, 0}}, {{.125, 0}, {.125, 0}, {.125, 0}}},
                        {{.125, .9}, {{0, .5}, {0, .5}, {0, .5}}, {{0, .35}, {0, .5}, {0, .5}}},
                        {{1.125, .25}, {{0, 0}, {.75, 0}, {.75, 0}}, {{0, 0}, {.75, 0}, {.75, 0}}},
                        {{-.125, .25}, {{.75, 0}, {0, 0}, {0, 0}}, {{.75, 0}, {0, 0}, {0, 0}}},
                        {{.99, .99}, {{.75, .5}, {.75, .5}, {.75, .5}}, {{.405, .26}, {.75, .5}, {.75, .5}}}};
    const char* wraps[] = {"repeat", "mirror", "clamp"};
    for (int w = 0; w < 3; ++w)
        for (const bool smooth : {false, true}) {
            const std::string rest = std::string("<string name=\"wrap_mode\" value=\"") + wraps[w] + "\"/><string name=\"filter_type\" value=\"" + (smooth ? "bilinear" : "nearest") + "\"/>";
            const Texture t = texture(bitmap("steps.exr", rest));
            for (const Row& row : rows) {
                const double* expected = smooth ? row.bilinear[w] : row.nearest[w];
                expect_near(texture_at(t, row.uv), {expected[0], expected[1], .1}, 1e-7, std::string(wraps[w]) + (smooth ? " bilinear " : " nearest ") + std::to_string(row.uv.x));
            }
        }
}

/// As Mitsuba 3.9.1: the transform acts on (u, v, 0).
TEST_F(Textures, ToUvMovesTextureCoordinates)
{
    struct Row {
        std::string steps;
        double expected[4][2];
    };
    const Row rows[] = {{R"(<scale x="2" y="3"/>)", {{0, 0}, {.5, 0}, {0, .5}, {0, .5}}},
                        {R"(<translate x=".25" y=".5"/>)", {{.25, .5}, {.5, .5}, {.25, 0}, {.75, .5}}},
                        {R"(<rotate z="1" angle="90"/>)", {{.75, 0}, {.75, 0}, {.25, 0}, {.5, .5}}},
                        {R"(<scale value="2"/><translate x=".25"/>)", {{.25, 0}, {.75, 0}, {.25, 0}, {.25, .5}}},
                        {R"(<matrix value="1 0 .5 0 1 .5 0 0 1"/>)", {{0, 0}, {.25, 0}, {0, .5}, {.5, 0}}}};
    const Vec2 places[] = {{.01, .01}, {.26, .01}, {.01, .51}, {.6, .3}};
    for (const Row& row : rows) {
        const Texture t = texture(bitmap("steps.exr", "<string name=\"filter_type\" value=\"nearest\"/><transform name=\"to_uv\">" + row.steps + "</transform>"));
        for (int i = 0; i < 4; ++i) expect_near(texture_at(t, places[i]), {row.expected[i][0], row.expected[i][1], .1}, 1e-7, row.steps);
    }
}

TEST_F(Textures, CheckerboardIsMitsubas)
{
    const Texture plain = texture(R"(<texture type="checkerboard" name="reflectance"/>)");
    for (const auto& [uv, value] : {std::pair(Vec2(.1, .1), .4), {Vec2(.6, .1), .2}, {Vec2(.1, .6), .2}, {Vec2(.6, .6), .4}, {Vec2(-.1, .1), .2}}) EXPECT_EQ(texture_at(plain, uv), Rgb(value));
    const Scene scene = load(R"(<texture type="checkerboard" name="reflectance"><rgb name="color0" value=".1 .2 .9"/><rgb name="color1" value=".3 .1 .1"/></texture>)");
    EXPECT_EQ(scene.bsdfs[0].reflectance, Rgb(.3, .2, .9)) << "a textured colour holds the largest values";
    EXPECT_EQ(scene.bsdfs[0].reflectance_texture, 0);
}

TEST_F(Textures, PngIsDecodedFromTheSrgbCurveUnlessRaw)
{
    png("two.png", {.width = 2, .samples = {255, 128, 0, 10, 11, 12}});
    const Texture linear = texture(bitmap("two.png")), raw = texture(bitmap("two.png", R"(<boolean name="raw" value="true"/>)"));
    ASSERT_EQ(linear.texels.size(), 6u);
    EXPECT_NEAR(linear.texels[0], 1, 1e-7);
    EXPECT_NEAR(linear.texels[1], .2158605, 1e-6);      // ((128/255 + .055)/1.055)^2.4
    EXPECT_NEAR(linear.texels[3], 10 / 255. / 12.92, 1e-7);  // the straight part
    EXPECT_NEAR(raw.texels[1], 128 / 255., 1e-7);
}

TEST_F(Textures, EveryKindOfPngIsRead)
{
    const std::string raw = R"(<boolean name="raw" value="true"/>)";
    png("grey.png", {.width = 2, .colour = PngFile::Colour::grey, .samples = {51, 204}});
    png("deep.png", {.bits = 16, .samples = {257, 65535, 13107}});
    png("palette.png", {.colour = PngFile::Colour::palette, .samples = {1}, .palette = {0, 0, 0, 51, 102, 153}});
    png("rgba.png", {.colour = PngFile::Colour::rgba, .samples = {51, 102, 153, 7}});
    png("pale.png", {.width = 1, .height = 2, .colour = PngFile::Colour::grey_alpha, .samples = {51, 7, 102, 0}});
    png("even.png", {.samples = {51, 51, 51}});
    const auto values = [&](const std::string& name) { return texture(bitmap(name, raw)).texels; };
    using testing::FloatNear, testing::ElementsAre;
    const auto near = [](double v) { return FloatNear(static_cast<float>(v), 1e-7f); };
    EXPECT_THAT(values("grey.png"), ElementsAre(near(.2), near(.8)));
    EXPECT_THAT(values("deep.png"), ElementsAre(near(257 / 65535.), near(1), near(.2)));
    EXPECT_THAT(values("palette.png"), ElementsAre(near(.2), near(.4), near(.6)));
    EXPECT_THAT(values("rgba.png"), ElementsAre(near(.2), near(.4), near(.6)));
    EXPECT_THAT(values("pale.png"), ElementsAre(near(.2), near(.4)));
    EXPECT_THAT(values("even.png"), ElementsAre(near(.2))) << "equal channels become one";
}

TEST_F(Textures, ExrIsLinearAndMayBeGrey)
{
    exr("y.exr", 2, 1, {"Y"}, {.25f, .75f});
    exr("depth.exr", 1, 1, {"Z"}, {.5f});
    exr("alpha.exr", 1, 1, {"R", "G", "B", "A"}, {.1f, .2f, .3f, .4f});
    EXPECT_EQ(texture(bitmap("y.exr")).texels, (std::vector<float>{.25f, .75f}));
    EXPECT_EQ(texture(bitmap("depth.exr")).texels, (std::vector<float>{.5f}));
    EXPECT_EQ(texture(bitmap("alpha.exr")).texels, (std::vector<float>{.1f, .2f, .3f}));
}

TEST_F(Textures, StandOnEveryReflectance)
{
    const auto at = [&](const std::string& type, const std::string& role) { return load(bitmap("steps.exr", "", role), type).bsdfs.at(0); };
    for (const char* type : {"dielectric", "thindielectric", "roughdielectric"}) {
        EXPECT_EQ(at(type, "specular_reflectance").reflectance_texture, 0) << type;
        EXPECT_EQ(at(type, "specular_transmittance").transmittance_texture, 0) << type;
        EXPECT_EQ(at(type, "specular_transmittance").reflectance_texture, none) << type;
    }
    for (const char* type : {"conductor", "roughconductor", "plastic", "roughplastic"}) EXPECT_EQ(at(type, "specular_reflectance").reflectance_texture, 0) << type;
    for (const char* type : {"plastic", "roughplastic"}) EXPECT_EQ(at(type, "diffuse_reflectance").diffuse_texture, 0) << type;
}

TEST_F(Textures, OneTextureMayBeNamedByMany)
{
    const Scene scene = load_scene(folder.write(
        "scene.xml", "<scene version=\"3.0.0\">" + plain_sensor + R"(<texture type="bitmap" id="steps"><string name="filename" value="steps.exr"/></texture>
        <bsdf type="diffuse"><ref name="reflectance" id="steps"/></bsdf><bsdf type="twosided"><bsdf type="plastic"><ref name="diffuse_reflectance" id="steps"/></bsdf></bsdf><shape type="cube"/></scene>)"));
    EXPECT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(scene.bsdfs.at(2).diffuse_texture, 0) << "the two-sided one holds its side's texture";
}

TEST_F(Textures, TheHashCoversTheFile)
{
    exr("y.exr", 1, 1, {"Y"}, {.25f});
    const auto before = load(bitmap("y.exr")).hash;
    exr("y.exr", 1, 1, {"Y"}, {.5f});
    EXPECT_NE(load(bitmap("y.exr")).hash, before);
}

TEST_F(Textures, DescriptionNamesThem)
{
    const std::string text = describe(load(bitmap("steps.exr")));
    EXPECT_THAT(text, HasSubstr("diffuse reflectance \"steps.exr\"\n"));
    EXPECT_THAT(text, HasSubstr("texture    \"steps.exr\": bitmap of 4 x 2 pixels, coloured, at most 0.75 0.5 0.1\n"));
}

TEST_F(Textures, MeshWithoutCoordinatesIsWarnedAbout)
{
    folder.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string bare = R"(<shape type="obj"><string name="filename" value="bare.obj"/><boolean name="face_normals" value="true"/>)";
    EXPECT_THAT(load_scene(scene(bitmap("steps.exr"), "diffuse", bare)).warnings, testing::Contains(HasSubstr("shape \"obj\": has no texture coordinates")));
    EXPECT_THAT(load(bitmap("steps.exr")).warnings, testing::Not(testing::Contains(HasSubstr("texture coordinates"))));
}

TEST_F(Textures, BadFilesAreRefusedWithTheirPlace)
{
    const std::string good = exr_bytes(4, 2, {"R", "G", "B"}, std::vector<float>(24, .5f), folder.path() / "scratch.exr"), png_file = png_bytes({.width = 2, .samples = {1, 2, 3, 4, 5, 6}});
    folder.write("foreign.exr", "P6 1 1 255 abc");
    exr("nan.exr", 2, 1, {"Y"}, {.5f, not_a_number});
    exr("bright.exr", 2, 1, {"Y"}, {.5f, 1.5f});
    exr("dark.exr", 1, 2, {"R", "G", "B"}, {.5f, .5f, .5f, .5f, -.25f, .5f});
    exr("odd.exr", 1, 1, {"a", "b"}, {.5f, .5f});
    folder.write("large.png", "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", big_endian(70000) + big_endian(70000) + std::string{8, 2, 0, 0, 0}) + png_chunk("IDAT", stored("")));
    folder.write("cut.png", png_file.substr(0, 50));
    folder.write("cut.exr", good.substr(0, good.size() - 3));
    std::string lying = good;
    lying[lying.find("chlist") + 10] = 0x7f;  // the channels' size: two billion bytes
    folder.write("lying.exr", lying);
    std::string damaged = png_file;
    damaged[20] ^= 1;
    folder.write("crc.png", damaged);
    const std::pair<const char*, const char*> cases[] = {{"foreign.exr", "foreign.exr: is neither a PNG nor an OpenEXR file"},
                                                         {"nan.exr", "nan.exr: pixel (1, 0) is nan; every value must be a finite number"},
                                                         {"bright.exr", "bright.exr: pixel (1, 0) is 1.5; a surface reflects between 0 and 1 of the light"},
                                                         {"dark.exr", "dark.exr: pixel (0, 1) is -0.25; a surface reflects"},
                                                         {"odd.exr", "odd.exr: has 2 channels, but neither R, G and B nor Y"},
                                                         {"large.png", "large.png: says that it has 70000 x 70000 pixels; 67108864 are possible"},
                                                         {"cut.png", "cut.png: is no PNG that can be read: the file is cut off"},
                                                         {"crc.png", "crc.png: is no PNG that can be read: IHDR: CRC error"},
                                                         {"cut.exr", "cut.exr: is"},
                                                         {"lying.exr", "lying.exr: claims more bytes in its header than there are"},
                                                         {"none.png", "cannot find \"none.png\""},
                                                         {"../up.png", "leads outside the scene's folder"},
                                                         {"", "needs <string name=\"filename\""}};
    for (const auto& [file, message] : cases) {
        EXPECT_THAT(fault(bitmap(file)), StartsWith("scene.xml:3:43: ")) << file;
        EXPECT_THAT(fault(bitmap(file)), HasSubstr(message)) << file;
    }
}

/// No length of a file that is cut off may be read as a picture, or crash.
TEST_F(Textures, EveryPrefixOfAFileIsRefused)
{
    const std::string files[] = {exr_bytes(3, 2, {"R", "G", "B"}, std::vector<float>(18, .5f), folder.path() / "scratch.exr"), png_bytes({.width = 2, .samples = {1, 2, 3, 4, 5, 6}})};
    for (const std::string& bytes : files)
        for (std::size_t length = 0; length < bytes.size(); ++length) EXPECT_THROW(read_picture(bytes.substr(0, length)), PictureFault) << length << " of " << bytes.size();
}

/// A fuzzer's finding: OpenEXR would take 2.4 GB for a row of tiles as high as the file says.
TEST_F(Textures, TilesThatNoPictureFillsAreRefusedBeforeMemoryIsAskedFor)
{
    std::ifstream file(TYNDALL_SOURCE_DIR "/tests/fuzz/corpus/picture/exr_huge_tiles", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    ASSERT_FALSE(bytes.empty());
    try {
        read_picture(bytes);
        FAIL() << "it was read";
    } catch (const PictureFault& fault) {
        EXPECT_THAT(fault.what(), HasSubstr("says that its tiles have 4 x 67108865 pixels"));
    }
}

TEST_F(Textures, MisspeltOrDoubledOnesAreRefused)
{
    EXPECT_THAT(fault(bitmap("steps.exr", "", "reflektance")), HasSubstr("3:1: bsdf \"painted\": a <texture> needs the name of what it colours (did you mean \"reflectance\"?); it may be: reflectance"));
    EXPECT_THAT(fault(bitmap("steps.exr") + bitmap("steps.exr")), HasSubstr("bsdf \"painted\": reflectance is given twice"));
    EXPECT_THAT(fault(bitmap("steps.exr") + R"(<rgb name="reflectance" value=".5"/>)"), HasSubstr("reflectance is given twice"));
    EXPECT_THAT(fault(R"(<texture type="bitmap" name="reflectance"/>)"), HasSubstr("texture \"bitmap\": needs <string name=\"filename\""));
    EXPECT_THAT(fault(R"(<texture type="wood" name="reflectance"/>)"), HasSubstr("texture type \"wood\" is not supported; supported: bitmap, checkerboard"));
    EXPECT_THAT(fault(bitmap("steps.exr", R"(<string name="wrap_mode" value="repeet"/>)")), HasSubstr("wrap_mode = \"repeet\" is not supported (did you mean \"repeat\"?)"));
    EXPECT_THAT(fault(bitmap("steps.exr", R"(<float name="filter" value="1"/>)")), HasSubstr("unknown parameter \"filter\""));
    EXPECT_THAT(fault(bitmap("steps.exr", "", "alpha"), "roughconductor"), HasSubstr("alpha as <texture type=\"bitmap\"> is not supported; write it as <float> or <integer>"));
    EXPECT_THAT(fault(R"(<texture type="checkerboard" name="reflectance"><rgb name="color0" value="1.5"/></texture>)"), HasSubstr("color0 = 1.5 must lie between 0 and 1"));
}

}  // namespace
}  // namespace tyndall::test
