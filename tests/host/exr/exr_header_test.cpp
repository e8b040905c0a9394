// What the header of an OpenEXR file claims, as both readers meet it: images of the film, and pictures of scenes.
#include <ImfBoxAttribute.h>
#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfDeepImageStateAttribute.h>
#include <ImfDoubleAttribute.h>
#include <ImfEnvmapAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIntAttribute.h>
#include <ImfKeyCodeAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfOpaqueAttribute.h>
#include <ImfOutputFile.h>
#include <ImfPreviewImageAttribute.h>
#include <ImfRationalAttribute.h>
#include <ImfStringAttribute.h>
#include <ImfStringVectorAttribute.h>
#include <ImfTileDescriptionAttribute.h>
#include <ImfTimeCodeAttribute.h>
#include <ImfVecAttribute.h>
#include <gmock/gmock.h>

#include <fstream>
#include <string>
#include <vector>

#include "film/exr.hpp"
#include "scene/picture_files.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tyndall/error.hpp"

namespace tyndall {
namespace {

using testing::HasSubstr;

/// What both readers say of a file; "read" where they have nothing to say.
std::vector<std::string> verdicts(const std::string& bytes)
{
    const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.exr";
    std::ofstream(file, std::ios::binary) << bytes;
    std::vector<std::string> verdicts(2, "read");
    try {
        read_exr(file);
    } catch (const IoError& error) {
        verdicts[0] = error.what();
    }
    try {
        read_exr_picture(bytes);
    } catch (const PictureFault& fault) {
        verdicts[1] = fault.what();
    }
    return verdicts;
}

void expect_refused(const std::string& bytes, const std::string& reason)
{
    for (const std::string& verdict : verdicts(bytes)) EXPECT_THAT(verdict, HasSubstr(reason));
}

std::string number(std::uint32_t value)
{
    std::string bytes;
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
    return bytes;
}

/// `stated`: as many bytes as the header says, where that is not the value's size.
std::string attribute(const std::string& name, const std::string& type, const std::string& value, std::uint32_t stated = 0)
{
    return name + '\0' + type + '\0' + number(stated > 0 ? stated : static_cast<std::uint32_t>(value.size())) + value;
}

constexpr std::uint32_t single_part = 2, tiled = 0x202;
std::string file_of(const std::string& attributes, std::uint32_t version = single_part) { return "\x76\x2f\x31\x01" + number(version) + attributes + '\0'; }

std::string channels(int count, std::uint32_t sampling = 1)
{
    std::string list;
    for (int i = 0; i < count; ++i) list += std::string(1, static_cast<char>('A' + i)) + '\0' + number(2) + number(0) + number(sampling) + number(sampling);
    return attribute("channels", "chlist", list + '\0');
}

std::string window(std::uint32_t width, std::uint32_t height) { return attribute("dataWindow", "box2i", number(0) + number(0) + number(width - 1) + number(height - 1)); }
std::string compression(char kind) { return attribute("compression", "compression", std::string(1, kind)); }
std::string tiles(std::uint32_t width, std::uint32_t height) { return attribute("tiles", "tiledesc", number(width) + number(height) + '\0'); }

/// 1 x 1 pixel with an attribute of every type that OpenEXR 3.1 knows, and one that it does not.
std::string file_with_every_type()
{
    Imf::Header header(1, 1);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    const Imf::PreviewRgba pixels[6] = {};
    header.insert("a", Imf::Box2fAttribute()), header.insert("b", Imf::ChromaticitiesAttribute()), header.insert("c", Imf::DeepImageStateAttribute()), header.insert("d", Imf::DoubleAttribute());
    header.insert("e", Imf::EnvmapAttribute()), header.insert("f", Imf::FloatVectorAttribute({1, 2, 3})), header.insert("g", Imf::IntAttribute()), header.insert("h", Imf::KeyCodeAttribute());
    header.insert("i", Imf::M33fAttribute()), header.insert("j", Imf::M33dAttribute()), header.insert("k", Imf::M44fAttribute()), header.insert("l", Imf::M44dAttribute());
    header.insert("m", Imf::PreviewImageAttribute(Imf::PreviewImage(3, 2, pixels))), header.insert("n", Imf::RationalAttribute()), header.insert("o", Imf::StringAttribute("fog"));
    header.insert("p", Imf::StringVectorAttribute({"fog", "", "smoke"})), header.insert("q", Imf::TileDescriptionAttribute()), header.insert("r", Imf::TimeCodeAttribute());
    header.insert("s", Imf::V2iAttribute()), header.insert("t", Imf::V2dAttribute()), header.insert("u", Imf::V3iAttribute()), header.insert("v", Imf::V3fAttribute()), header.insert("w", Imf::V3dAttribute());
    header.insert("x", Imf::OpaqueAttribute("ours"));
    const test::TemporaryFolder folder;
    const float value = .5f;
    {
        Imf::OutputFile output((folder / "a.exr").c_str(), header);
        Imf::FrameBuffer frame;
        frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, &value, header.dataWindow()));
        output.setFrameBuffer(frame);
        output.writePixels();
    }
    return test::file_bytes(folder / "a.exr");
}

/// Found by tests/fuzz: OpenEXR reads four bytes of an "int", whatever the header states; it then took the stated rest for an attribute, and 2 GiB for its value.
TEST(ExrHeader, WhatIsHiddenInAnAttributeOfATypeOfFixedSizeIsNotReached)
{
    const std::string hidden = std::string("b\0c\0", 4) + number(0x7fffffff);
    const std::string bytes = file_of(attribute("a", "int", number(0) + hidden));
    EXPECT_EQ(bytes.size(), 31u);
    expect_refused(bytes, "states a size for a value of type \"int\"");
    // Behind the channels' empty name, and behind the last whole number of a vector.
    expect_refused(file_of(attribute("channels", "chlist", '\0' + hidden)), "states a size for a value of type \"chlist\"");
    expect_refused(file_of(attribute("a", "floatvector", number(0) + "b")), "states a size for a value of type \"floatvector\"");
    // A name whose zero byte OpenEXR does not see any more.
    expect_refused(file_of(attribute(std::string(255, 'a'), "int", number(0))), "has a name of more than 254 bytes");
}

TEST(ExrHeader, EveryTypeHasTheSizeThatOpenEXRWrites)
{
    const std::string good = file_with_every_type();
    EXPECT_THAT(verdicts(good), testing::Each("read"));
    for (const std::string type : {"box2f", "box2i", "chlist", "chromaticities", "compression", "deepImageState", "double", "envmap", "float", "floatvector", "int", "keycode", "lineOrder", "m33d", "m33f", "m44d", "m44f",
                                   "preview", "rational", "stringvector", "tiledesc", "timecode", "v2d", "v2f", "v2i", "v3d", "v3f", "v3i"}) {
        const std::size_t at = good.rfind('\0' + type + '\0');  // two attributes are named after their type
        if (at == good.npos) {
            ADD_FAILURE() << "no " << type;
            continue;
        }
        std::string bytes = good;
        char& size = bytes[at + type.size() + 2];
        for (const int change : {1, -2}) {
            size = static_cast<char>(size + change);
            expect_refused(bytes, "states a size for a value of type \"" + type + "\" in its header that is not the value's");
        }
    }
}

TEST(ExrHeader, ClaimsThatNoFileOfItsSizeCanHoldAreRefused)
{
    expect_refused(file_of(""), "has no channels");
    expect_refused(file_of(window(4, 4)), "has no channels");
    expect_refused(file_of(channels(1)), "has a data window that makes no sense");
    expect_refused(file_of(channels(1) + window(0x80000000, 4)), "has a data window that makes no sense");
    expect_refused(file_of(channels(1, 2) + window(4, 4)), "has subsampled channels");
    expect_refused(file_of(channels(1) + window(4096, 4096)), "says that it has more pixels than a file of its size can hold");
    expect_refused(file_of(channels(3) + window(1024, 1024)), "says that it has more pixels than a file of its size can hold");
    expect_refused(file_of(channels(1) + window(1, 1000000)), "says that it has more rows than a file of its size can hold");
    expect_refused(file_of(channels(1) + tiles(1, 1) + window(1000, 1000), tiled), "says that it has more tiles than a file of its size can hold");
    expect_refused(file_of(channels(1) + tiles(0, 1) + window(10, 10), tiled), "has tiles without pixels");
    expect_refused(file_of(channels(1) + window(10, 10), tiled), "has tiles without pixels");
    expect_refused(file_of(attribute("a", "idmanifest", number(0) + number(0))), "holds a manifest of objects");
    expect_refused(file_of(attribute("a", "ours", "fog", 1000)), "claims more bytes in its header than there are");
    expect_refused(file_of(attribute("a", "ours", "fog", 0xfffffff0)), "claims more bytes in its header than there are");
}

/// OpenEXR keeps a block of rows in memory, or a row of tiles, before it reads a pixel: here half a gibibyte and more.
TEST(ExrHeader, BlocksFarLargerThanThePictureAreRefused)
{
    const char dwab = 9, zip = 3;
    expect_refused(file_of(channels(1) + compression(dwab) + window(1 << 20, 1)), "takes 256 rows together, far more than there are in 1048576 x 1 pixels");
    expect_refused(file_of(channels(26) + compression(zip) + window(1 << 18, 1) + attribute("a", "string", std::string(400, ' '))), "takes 16 rows together");
    expect_refused(file_of(channels(1) + tiles(1 << 10, 1 << 17) + window(100, 1), tiled), "says that its tiles have 1024 x 131072 pixels, far more than there are in 100 x 1");
    expect_refused(file_of(channels(1) + tiles(1, 1 << 12) + window(1 << 20, 1), tiled), "says that its tiles have 1 x 4096 pixels");
    expect_refused(file_of(channels(1) + tiles(0xffffffff, 0xffffffff) + window(1, 1), tiled), "says that its tiles have 4294967295 x 4294967295 pixels");
}

}  // namespace
}  // namespace tyndall
