/// `tyndall info` of scenes with grids of voxels and with textures.
#include <nlohmann/json.hpp>

#include "program_fixture.hpp"
#include "tests/support/vol_file.hpp"

namespace tyndall::test {
namespace {

using testing::HasSubstr;

class Info : public Program {
protected:
    Info()
    {
        write_file("two.vol", vol_bytes(two_voxels(1, 3)));
        std::string scene = fog_scene;
        scene.replace(scene.find("homogeneous"), 11, "heterogeneous");
        const std::string number = "<float name=\"sigma_t\" value=\"$density\"/>";
        scene.replace(scene.find(number), number.size(), "<float name=\"scale\" value=\"$density\"/><volume name=\"sigma_t\" type=\"gridvolume\"><string name=\"filename\" value=\"two.vol\"/></volume>");
        write_file("scene.xml", scene);
    }
};

TEST_F(Info, JsonListsVolumesAndWhoUsesThem)
{
    const auto result = run({"info", "scene.xml", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto scene = nlohmann::json::parse(result.out);
    EXPECT_EQ(scene.at("media")[0].at("density"), 0);
    EXPECT_TRUE(scene.at("media")[0].at("albedo_volume").is_null());
    ASSERT_EQ(scene.at("volumes").size(), 1u);
    const auto volume = scene.at("volumes")[0];
    EXPECT_EQ(volume.at("name"), "two.vol");
    EXPECT_THAT(volume.at("where").get<std::string>(), HasSubstr("scene.xml:5:"));
    EXPECT_EQ(volume.at("size"), (nlohmann::json{2, 1, 1}));
    EXPECT_EQ(volume.at("channels"), 1);
    EXPECT_EQ(volume.at("least")[0], 1);
    EXPECT_EQ(volume.at("mean")[1], 2);
    EXPECT_EQ(volume.at("largest")[2], 3);
    EXPECT_EQ(volume.at("bytes"), 8);
    EXPECT_EQ(volume.at("low")[0], 0);
    EXPECT_EQ(volume.at("high")[2], 1);
}

TEST_F(Info, ABadFileOfVoxelsExitsWith3AndNamesThePlace)
{
    write_file("two.vol", vol_bytes(two_voxels(1, -3)));
    const auto result = run({"info", "scene.xml"});
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr("scene.xml:5:"));
    EXPECT_THAT(result.err, HasSubstr("two.vol: voxel (1, 0, 0) is -3; every value must be finite and not negative"));
}

TEST_F(Info, JsonListsTexturesAndWhoUsesThem)
{
    std::string scene = fog_scene;
    scene.insert(scene.find("<shape"), R"(<bsdf type="roughplastic" id="toy"><texture name="diffuse_reflectance" type="checkerboard"/></bsdf><bsdf type="diffuse"/>)");
    write_file("scene.xml", scene);
    const auto result = run({"info", "scene.xml", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json.at("bsdfs")[0].at("type"), "roughplastic");
    EXPECT_EQ(json.at("bsdfs")[0].at("diffuse_texture"), 0);
    EXPECT_TRUE(json.at("bsdfs")[1].at("reflectance_texture").is_null());
    EXPECT_EQ(json.at("textures")[0].at("type"), "checkerboard");
    EXPECT_EQ(json.at("textures")[0].at("largest")[0], .4);
}

TEST_F(Info, ABadPictureExitsWith3AndNamesThePlace)
{
    std::string scene = fog_scene;
    scene.insert(scene.find("<shape"), "<bsdf type=\"diffuse\">\n<texture name=\"reflectance\" type=\"bitmap\"><string name=\"filename\" value=\"wood.png\"/></texture></bsdf>\n");
    write_file("scene.xml", scene);
    const auto missing = run({"render", "scene.xml"});
    EXPECT_EQ(missing.exit_code, 3);
    EXPECT_THAT(missing.err, HasSubstr("scene.xml:23:43: cannot find \"wood.png\""));
    write_file("wood.png", "\x89PNG\r\n\x1a\n and no more");
    const auto damaged = run({"render", "scene.xml"});
    EXPECT_EQ(damaged.exit_code, 3);
    EXPECT_THAT(damaged.err, HasSubstr("scene.xml:23:43: texture \"bitmap\": wood.png: is no PNG that can be read"));
    EXPECT_EQ(files(), (std::vector<std::string>{"scene.xml", "two.vol", "wood.png"}));
}

}  // namespace
}  // namespace tyndall::test
