// From XML to elements: places, substitution, includes, references; and what a hostile file gets for an answer.
#include <sys/stat.h>

#include "scene_text.hpp"

namespace tyndall::test {

TEST(SceneDocument, PlacesCountLinesAndCharactersFromOne)
{
    EXPECT_EQ(fault("<scene version=\"3.0.0\">\n  <sensr type=\"perspective\"/>\n</scene>").substr(0, 14), "scene.xml:2:3:");
    // the e with an accent is two bytes and one character
    EXPECT_EQ(fault("<scene version=\"3.0.0\">\n<!-- \xc3\xa9 --><sensr/>\n</scene>").substr(0, 15), "scene.xml:2:11:");
    EXPECT_EQ(fault("\xef\xbb\xbf<scene version=\"3.0.0\"><sensr/></scene>").substr(0, 15), "scene.xml:1:24:");
}

TEST(SceneDocument, UnknownElementIsRefusedWithTheNearestName)
{
    EXPECT_EQ(fault("<scene version=\"3.0.0\">\n  <sensr type=\"perspective\"/>\n</scene>"),
              "scene.xml:2:3: scene: unknown element <sensr> (did you mean \"sensor\"?)");
}

TEST(SceneDocument, BrokenXmlIsRefusedAtItsPlace)
{
    EXPECT_EQ(fault("<scene version=\"3.0.0\">\n<shape></scene>").find("scene.xml:2:"), 0u);
    EXPECT_NE(fault("<scene version=\"3.0.0\">\n<shape></scene>").find("not well-formed XML"), std::string::npos);
    EXPECT_NE(fault("").find("there is no element"), std::string::npos);
    EXPECT_NE(fault("just text").find("scene.xml:1:"), std::string::npos);
    EXPECT_NE(fault("<scene version=\"3.0.0\"/><scene version=\"3.0.0\"/>").find("second root element"), std::string::npos);
    EXPECT_NE(fault(std::string("<scene\0/>", 9)).find("zero byte"), std::string::npos);
    EXPECT_EQ(fault_of_body("<shape type=\"cube\" type=\"cube\"/>"), "scene.xml:2:1: <shape> has the attribute \"type\" twice");
    EXPECT_EQ(fault_of_body("<shape type=\"cube\">7</shape>"),
              "scene.xml:2:20: text inside <shape>: \"7\"; values are written as attributes");
}

TEST(SceneDocument, VersionIsAskedForAndChecked)
{
    EXPECT_EQ(fault("<scene/>"), "scene.xml:1:1: <scene> needs the attribute \"version\", for example version=\"3.0.0\"");
    EXPECT_NE(fault("<scene version=\"0.6.0\"/>").find("too old"), std::string::npos);
    EXPECT_NE(fault("<scene version=\"three\"/>").find("not of the form"), std::string::npos);
    for (const char* good : {"2.0.0", "2.1", "3.0.0", "3.9.1", "4.0.0"})
        EXPECT_EQ(fault(std::string("<scene version=\"") + good + "\">" + plain_sensor + "</scene>"), "") << good;
    EXPECT_NE(fault("<shape type=\"cube\"/>").find("the root element is <shape>"), std::string::npos);
}

TEST(SceneDocument, DefaultsAndDefinitionsReplaceNames)
{
    const std::string body = R"(<default name="g" value="0.3"/><default name="s" value="1"/>
<medium type="homogeneous" id="m"><float name="scale" value="$s$s"/><phase type="hg"><float name="g" value="$g"/></phase></medium>)";
    EXPECT_EQ(load_body(body).media[0].phase.g, .3);
    EXPECT_EQ(load_body(body).media[0].sigma_t.x, 11 * load_body(body).unit);  // "$s$s" is "11"
    EXPECT_EQ(load_body(body, {.definitions = {{"g", "-0.5"}}}).media[0].phase.g, -.5);
}

TEST(SceneDocument, TheLongestNameWins)
{
    const std::string body = R"(<default name="g" value="0.3"/><default name="g_blue" value="0.4"/>
<medium type="homogeneous"><phase type="hg"><float name="g" value="$g_blue"/></phase></medium>)";
    EXPECT_EQ(load_body(body).media[0].phase.g, .4);
}

TEST(SceneDocument, UndefinedNameIsAnErrorWithTheNearest)
{
    EXPECT_EQ(fault_of_body("<default name=\"radius\" value=\"1\"/>\n <shape type=\"$raduis\"/>"),
              "scene.xml:3:2: $raduis is not defined (did you mean \"radius\"?); give it a <default>, or define it with -D raduis=value");
}

TEST(SceneDocument, UnusedDefinitionIsAnErrorWithTheNearest)
{
    EXPECT_EQ(fault_of_body("<default name=\"radius\" value=\"1\"/>", {.definitions = {{"raduis", "2"}}}),
              "scene.xml: nothing uses the definition \"raduis\" (did you mean \"radius\"?)");
}

TEST(SceneDocument, RefsReachForwardsAndThroughAliases)
{
    const Scene scene = load_body(R"(<shape type="sphere"><ref id="again"/><ref name="interior" id="m"/></shape>
<alias id="black" as="again"/><bsdf type="diffuse" id="black"><float name="reflectance" value="0"/></bsdf><medium type="homogeneous" id="m"/>)");
    EXPECT_EQ(scene.bsdfs[static_cast<std::size_t>(scene.shapes[0].bsdf)].name, "black");
    EXPECT_EQ(scene.shapes[0].interior, 0);
}

TEST(SceneDocument, WrongRefsAreRefused)
{
    EXPECT_EQ(fault_of_body("<medium type=\"homogeneous\" id=\"fog\"/>\n<shape type=\"cube\"><ref name=\"interior\" id=\"fgo\"/></shape>"),
              "scene.xml:3:20: nothing has the id \"fgo\" (did you mean \"fog\"?)");
    EXPECT_NE(fault_of_body("<shape type=\"cube\"><ref name=\"interior\"/></shape>").find("needs the attribute \"id\""), std::string::npos);
    EXPECT_NE(
        fault_of_body("<bsdf type=\"null\" id=\"a\"/><shape type=\"cube\" id=\"a\"/>").find("the id \"a\" is taken, at scene.xml:2:1"),
        std::string::npos);
    EXPECT_NE(fault_of_body("<alias id=\"a\" as=\"b\"/><alias id=\"b\" as=\"a\"/><shape type=\"cube\"><ref id=\"a\"/></shape>")
                  .find("nothing has the id"),
              std::string::npos);
    EXPECT_NE(fault_of_body("<bsdf type=\"twosided\" id=\"a\"><ref id=\"a\"/></bsdf>").find("cannot be a side"), std::string::npos);
    EXPECT_NE(fault_of_body("<integrator type=\"path\" id=\"a\"><ref id=\"a\"/></integrator>").find("in a circle"), std::string::npos);
}

TEST(SceneDocument, IncludesAreSplicedInWithTheirOwnPlaces)
{
    const TemporaryFolder folder;
    folder.write("parts/room.xml", "<scene version=\"3.0.0\">\n<medium type=\"homogeneous\" id=\"fog\"/>\n</scene>");
    folder.write("parts/ball.xml", "<shape type=\"sphere\"><ref name=\"interior\" id=\"fog\"/></shape>");
    const auto file = folder.write("scene.xml", around("<include filename=\"parts/room.xml\"/><include filename=\"parts/ball.xml\"/>"));
    const Scene scene = load_scene(file);
    EXPECT_EQ(scene.shapes[0].interior, 0);
    EXPECT_EQ(to_string(scene.media[0].where), (folder.path() / "parts/room.xml").string() + ":2:1");
    folder.write("parts/ball.xml", "\n <shape type=\"sphre\"/>");
    EXPECT_EQ(fault_of_file(file).find((folder.path() / "parts/ball.xml").string() +
                                       ":2:2: shape type \"sphre\" is not supported (did you mean \"sphere\"?)"),
              0u)
        << fault_of_file(file);
}

TEST(SceneDocument, PathAddsASearchFolder)
{
    const TemporaryFolder folder;
    folder.write("models/ball.xml", "<shape type=\"sphere\"/>");
    EXPECT_EQ(load_scene(folder.write("scene.xml", around("<path value=\"models\"/><include filename=\"ball.xml\"/>"))).shapes.size(), 1u);
    EXPECT_NE(fault_of_file(folder.write("scene.xml", around("<path value=\"nowhere\"/>"))).find("cannot find \"nowhere\""),
              std::string::npos);
    EXPECT_NE(fault_of_file(folder.write("scene.xml", around("<path value=\"/\"/>"))).find("outside the scene's folder"),
              std::string::npos);
}

TEST(SceneDocument, IncludeCyclesAreRefused)
{
    const TemporaryFolder folder;
    const auto itself = folder.write("itself.xml", around("<include filename=\"itself.xml\"/>"));
    EXPECT_NE(fault_of_file(itself).find("includes itself"), std::string::npos);
    const auto a = folder.write("a.xml", around("<include filename=\"b.xml\"/>"));
    folder.write("b.xml", "<scene version=\"3.0.0\"><include filename=\"c.xml\"/></scene>");
    folder.write("c.xml", "<scene version=\"3.0.0\"><include filename=\"b.xml\"/></scene>");
    EXPECT_NE(fault_of_file(a).find("includes itself"), std::string::npos);
}

TEST(SceneDocument, IncludesCannotMultiplyWithoutEnd)
{
    const TemporaryFolder folder;
    for (int i = 0; i < 15; ++i) {
        const std::string next = "<include filename=\"" + std::to_string(i + 1) + ".xml\"/>";
        folder.write(std::to_string(i) + ".xml", "<scene version=\"3.0.0\">" + next + next + "</scene>");
    }
    folder.write("15.xml", "<scene version=\"3.0.0\"/>");
    EXPECT_NE(fault_of_file(folder.write("scene.xml", around("<include filename=\"0.xml\"/>"))).find("more than 1000 includes"),
              std::string::npos);
}

TEST(SceneDocument, DoctypeAndEntitiesAreRefused)
{
    const std::string bomb = "<!DOCTYPE scene [\n<!ENTITY a \"ha\">\n<!ENTITY b \"&a;&a;&a;\">\n]>\n<scene version=\"3.0.0\">&b;</scene>";
    EXPECT_NE(fault(bomb).find("a DOCTYPE is not accepted"), std::string::npos);
    EXPECT_NE(fault("<!DOCTYPE scene SYSTEM \"file:///etc/passwd\"><scene version=\"3.0.0\"/>").find("a DOCTYPE is not accepted"),
              std::string::npos);
}

TEST(SceneDocument, SizeDepthAndCountAreCapped)
{
    std::string deep = "<scene version=\"3.0.0\">";
    for (int i = 0; i < 100000; ++i) deep += "<bsdf type=\"twosided\">";
    for (int i = 0; i < 100000; ++i) deep += "</bsdf>";
    EXPECT_NE(fault(deep + "</scene>").find("nested deeper than 64"), std::string::npos);
    std::string many;
    for (int i = 0; i < 1'000'001; ++i) many += "<a/>";
    EXPECT_NE(fault_of_body(many).find("more than 1000000 tags"), std::string::npos);
    EXPECT_NE(fault("<scene version=\"3.0.0\"><!--" + std::string(33u << 20, ' ') + "--></scene>").find("bytes; the limit is"),
              std::string::npos);
}

TEST(SceneDocument, NamesCannotGrowWithoutEnd)
{
    std::string body = "<default name=\"a\" value=\"xxxxxxxxxx\"/>";
    for (char c = 'b'; c < 'l'; ++c) {
        const std::string before = std::string("$") + static_cast<char>(c - 1);
        body += std::string("<default name=\"") + c + "\" value=\"" + before + before + before + before + before + before + before +
                before + "\"/>";
    }
    EXPECT_NE(fault_of_body(body).find("grows beyond 65536 bytes"), std::string::npos);
}

TEST(SceneDocument, OneLongLineCostsLinearTime)
{
    std::string body;
    for (int i = 0; i < 100000; ++i) body += "<bsdf type=\"null\"/>";
    EXPECT_EQ(load_body(body).bsdfs.size(), 100000u);  // 190 Gbyte to count if every place were counted from the line's start
}

TEST(SceneFiles, NamesStayInsideTheScenesFolder)
{
    const TemporaryFolder outer;
    outer.write("secret.xml", "<shape type=\"sphere\"/>");
    std::filesystem::create_directories(outer.path() / "inner");
    std::filesystem::create_symlink(outer.path() / "secret.xml", outer.path() / "inner/link.xml");
    std::filesystem::create_directory_symlink(outer.path(), outer.path() / "inner/up");
    const std::string absolute = (outer.path() / "secret.xml").string();
    for (const std::string& name : {std::string("../secret.xml"), std::string("sub/../../secret.xml"), absolute, std::string("link.xml"),
                                    std::string("up/secret.xml"), std::string("../no_such_file.xml"), std::string("/no_such_file.xml")}) {
        const auto file = outer.write("inner/scene.xml", around("<include filename=\"" + name + "\"/>"));
        EXPECT_NE(fault_of_file(file).find("leads outside the scene's folder"), std::string::npos) << name << ": " << fault_of_file(file);
    }
    const auto file = outer.write("inner/scene.xml", around("<include filename=\"../secret.xml\"/>"));
    EXPECT_EQ(load_scene(file, {.allow_outside = true}).shapes.size(), 1u);
}

TEST(SceneFiles, FifosDevicesAndFoldersAreRefusedAtOnce)
{
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder.path() / "fifo").c_str(), 0600), 0);
    std::filesystem::create_directories(folder.path() / "sub");
    for (const char* name : {"fifo", "sub"}) {
        const auto file = folder.write(
            "scene.xml", around(std::string("<shape type=\"ply\"><string name=\"filename\" value=\"") + name + "\"/></shape>"));
        EXPECT_NE(fault_of_file(file).find("is not a regular file"), std::string::npos) << name;
    }
    const auto device = folder.write("scene.xml", around("<shape type=\"ply\"><string name=\"filename\" value=\"/dev/zero\"/></shape>"));
    EXPECT_NE(fault_of_file(device, {.allow_outside = true}).find("is not a regular file"), std::string::npos);
    EXPECT_NE(fault_of_file(folder.path() / "fifo").find("is not a regular file"), std::string::npos);
    EXPECT_NE(fault_of_file("/dev/zero").find("is not a regular file"), std::string::npos);
}

TEST(SceneFiles, MissingSceneIsASentence)
{
    EXPECT_EQ(fault_of_file("no/such/scene.xml"), "no/such/scene.xml: cannot read \"no/such/scene.xml\": No such file or directory");
}

TEST(SceneHash, ChangesWithEveryFileAndDefinition)
{
    const TemporaryFolder folder;
    folder.write("part.xml", "<shape type=\"sphere\"/>");
    const auto file = folder.write("scene.xml", around("<default name=\"g\" value=\"0\"/><include filename=\"part.xml\"/>"));
    const auto first = load_scene(file).hash;
    EXPECT_EQ(load_scene(file).hash, first);
    EXPECT_NE(load_scene(file, {.definitions = {{"g", "0"}}}).hash, first);
    folder.write("part.xml", "<shape type=\"sphere\" />");
    EXPECT_NE(load_scene(file).hash, first);
    EXPECT_NE(parse("<scene version=\"3.0.0\">" + plain_sensor + "</scene>").hash,
              parse("<scene version=\"3.0.0\">" + plain_sensor + " </scene>").hash);
}

TEST(SceneHash, DoesNotDependOnWhereTheFolderIs)
{
    const TemporaryFolder one, two;
    std::uint64_t hashes[2];
    int i = 0;
    for (const TemporaryFolder* folder : {&one, &two}) {
        folder->write("part.xml", "<shape type=\"sphere\"/>");
        hashes[i++] = load_scene(folder->write("scene.xml", around("<include filename=\"part.xml\"/>"))).hash;
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace tyndall::test
