/// Textures and environment maps of scenes from memory: the image of the same scene from files, by C++ and by C; refusals that name the element.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "description_faults.hpp"
#include "scenes.hpp"
#include "support/picture_file.hpp"
#include "support/temporary_folder.hpp"
#include "tyndall/tyndall.h"

using namespace tyndall;
using namespace tyndall::test;

namespace {

constexpr int width = 5, height = 3;  ///< of the picture on the plate
constexpr int around = 8, down = 4;   ///< of the map

std::vector<float> plate_texels()
{
    std::vector<float> texels;
    for (int i = 0; i < width * height; ++i)
        for (int c = 0; c < 3; ++c) texels.push_back(static_cast<float>((7 * i + 5 * c) % 11) / 11);
    return texels;
}

std::vector<float> map_texels()
{
    std::vector<float> texels;
    for (int i = 0; i < around * down; ++i)
        for (int c = 0; c < 3; ++c) texels.push_back(static_cast<float>(1 + (3 * i + c) % 7));
    return texels;
}

/// Local axes +y and +z of the map after turns of 30 degrees around x and 40 around y.
const double a = std::numbers::pi / 6, b = std::numbers::pi * 2 / 9;
const api::Triple up{std::sin(a) * std::sin(b), std::cos(a), std::sin(a) * std::cos(b)}, middle{std::cos(a) * std::sin(b), -std::sin(a), std::cos(a) * std::cos(b)};
const std::vector<std::array<double, 2>> plate_uvs{{0, 1}, {1, 1}, {1, 0}, {0, 0}};
const std::array<double, 6> to_uv{2, 0, .25, 0, 3, -.5};

/// The fog's box and plate with a picture on the plate, in light from everywhere.
api::SceneDescription pictured_as_data()
{
    api::SceneDescription scene = fog_as_data();
    scene.textures = {{.name = "picture", .width = width, .height = height, .texels = plate_texels(), .filter = api::Texture::Filter::nearest, .wrap = api::Texture::Wrap::mirror, .to_uv = to_uv}};
    scene.environment_maps = {{.width = around, .height = down, .texels = map_texels()}};
    scene.bsdfs[1].reflectance_texture = 0;
    scene.meshes[1].uvs = plate_uvs;
    scene.emitters = {{.type = api::Emitter::Type::environment, .value = {.5, .5, .5}, .up = up, .middle = middle}};
    return scene;
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

/// Writes the same pictures as files beside it.
std::string pictured_as_text(const std::filesystem::path& folder)
{
    std::ofstream(folder / "plate.exr", std::ios::binary) << exr_bytes(width, height, {"R", "G", "B"}, plate_texels(), folder / "scratch.exr");
    std::ofstream(folder / "map.exr", std::ios::binary) << exr_bytes(around, down, {"R", "G", "B"}, map_texels(), folder / "scratch.exr");
    std::string text = replaced(fog_as_text(), "<rgb name=\"reflectance\" value=\".5 .25 .75\"/>", R"(<texture name="reflectance" type="bitmap"><string name="filename" value="plate.exr"/>
<string name="filter_type" value="nearest"/><string name="wrap_mode" value="mirror"/><transform name="to_uv"><scale x="2" y="3"/><translate x=".25" y="-.5"/></transform></texture>)");
    text = text.substr(0, text.find("<emitter"));
    return text + R"(<emitter type="envmap"><string name="filename" value="map.exr"/><float name="scale" value=".5"/>
<transform name="to_world"><rotate x="1" angle="30"/><rotate y="1" angle="40"/></transform></emitter></scene>)";
}

RenderSettings by_paths()
{
    RenderSettings settings = few_passes(2);
    settings.method = Method::path;
    return settings;
}

// As for scenes without pictures: the same surfaces, decisions and random numbers; places differ by their rounding. A path that decides otherwise for it moves one pixel.
TEST(LibraryPictures, FromMemoryAreThoseOfFiles)
{
    const TemporaryFolder folder;
    const api::Image memory = api::render(api::Scene(pictured_as_data()), by_paths());
    const api::Image text = api::render(api::Scene::parse(pictured_as_text(folder.path()), folder.path(), "fog.xml"), by_paths());
    const auto got = memory.beauty(), wanted = text.beauty();
    ASSERT_EQ(got.size(), wanted.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < got.size(); ++i) different += !(std::abs(got[i] - wanted[i]) <= 1e-3f * wanted[i] + 1e-6f);
    EXPECT_LE(different, 6u) << "of " << got.size();
    EXPECT_GT(*std::max_element(wanted.begin(), wanted.end()), 0);
    EXPECT_TRUE(api::Scene(pictured_as_data()).warnings().empty());
}

// The picture lies below the boundary of a plastic.
TEST(LibraryPictures, PlasticsFromMemoryAreThoseOfFiles)
{
    const TemporaryFolder folder;
    api::SceneDescription scene = pictured_as_data();
    std::string text = pictured_as_text(folder.path());
    text = replaced(replaced(text, "<bsdf type=\"diffuse\">", "<bsdf type=\"roughplastic\"><float name=\"int_ior\" value=\"1.5\"/><float name=\"ext_ior\" value=\"1\"/><float name=\"alpha\" value=\".2\"/>"),
                    "<texture name=\"reflectance\"", "<boolean name=\"nonlinear\" value=\"true\"/><texture name=\"diffuse_reflectance\"");
    scene.bsdfs[1] = {.name = "plate", .type = api::Bsdf::Type::rough_plastic, .reflectance = {1, 1, 1}, .eta = 1.5, .alpha = .2, .two_sided = true, .below_texture = 0, .nonlinear = true};
    const api::Image memory = api::render(api::Scene(scene), by_paths());
    const api::Image from_text = api::render(api::Scene::parse(text, folder.path(), "fog.xml"), by_paths());
    const auto got = memory.beauty(), wanted = from_text.beauty();
    std::size_t different = 0;
    for (std::size_t i = 0; i < got.size(); ++i) different += !(std::abs(got[i] - wanted[i]) <= 1e-3f * wanted[i] + 1e-6f);
    EXPECT_LE(different, 6u) << "of " << got.size();
    scene.bsdfs[1].nonlinear = false;
    const api::Image linear = api::render(api::Scene(scene), by_paths());
    EXPECT_FALSE(std::equal(got.begin(), got.end(), linear.beauty().begin()));
}

TEST(LibraryPictures, EachPartOfThemMatters)
{
    const auto image = [](const api::SceneDescription& scene) {
        const api::Image rendered = api::render(api::Scene(scene), by_paths());
        return std::vector<float>(rendered.beauty().begin(), rendered.beauty().end());
    };
    const std::vector<float> all = image(pictured_as_data());
    using Change = void (*)(api::SceneDescription&);
    const std::pair<const char*, Change> changes[] = {
        {"filter", [](api::SceneDescription& s) { s.textures[0].filter = api::Texture::Filter::bilinear; }},
        {"wrap", [](api::SceneDescription& s) { s.textures[0].wrap = api::Texture::Wrap::clamp; }},
        {"to_uv", [](api::SceneDescription& s) { s.textures[0].to_uv[2] = 0; }},
        {"coordinates", [](api::SceneDescription& s) { std::swap(s.meshes[1].uvs[0], s.meshes[1].uvs[2]); }},
        {"checkerboard", [](api::SceneDescription& s) { s.textures[0] = {.type = api::Texture::Type::checkerboard}; }},
        {"up", [](api::SceneDescription& s) { s.emitters[0].up = {0, 1, 0}; }},
        {"factor", [](api::SceneDescription& s) { s.emitters[0].value[1] = .25; }},
    };
    for (const auto& [what, change] : changes) {
        api::SceneDescription scene = pictured_as_data();
        change(scene);
        EXPECT_NE(image(scene), all) << what;
    }
}

TEST(LibraryPictures, ATextureOnAMeshWithoutCoordinatesIsAWarning)
{
    api::SceneDescription scene = pictured_as_data();
    scene.meshes[1].uvs.clear();
    EXPECT_THAT(api::Scene(scene).warnings(), testing::Contains(testing::HasSubstr("mesh 1 \"plate\": has no texture coordinates")));
}

// ---- from C ----

struct Freed {
    void operator()(tyndall_description* description) const { tyndall_description_destroy(description); }
    void operator()(tyndall_scene* scene) const { tyndall_scene_destroy(scene); }
    void operator()(tyndall_image* image) const { tyndall_image_destroy(image); }
    void operator()(tyndall_settings* settings) const { tyndall_settings_destroy(settings); }
};

#define OK(call) ASSERT_EQ(call, TYNDALL_OK) << tyndall_last_error()

/// The scene above through the C interface.
void describe_in_c(tyndall_description* to, const api::SceneDescription& scene)
{
    int medium = -1, boundary = -1, plate = -1, board = -1, picture = -1, box = -1, floor = -1;
    const double grey[]{.5, .5, .5};
    OK(tyndall_add_medium(to, scene.media[0].sigma_t.data(), scene.media[0].albedo.data(), .5, &medium));
    OK(tyndall_set_phase_table(to, medium, scene.media[0].phase.values.data(), scene.media[0].phase.values.size()));
    OK(tyndall_add_null(to, &boundary));
    OK(tyndall_add_diffuse(to, scene.bsdfs[1].reflectance.data(), 1, &plate));
    OK(tyndall_add_picture(to, width, height, 3, scene.textures[0].texels.data(), &picture));
    OK(tyndall_set_lookup(to, picture, TYNDALL_NEAREST, TYNDALL_MIRROR, to_uv.data()));
    OK(tyndall_add_checkerboard(to, grey, grey, &board));
    OK(tyndall_set_textures(to, plate, picture, TYNDALL_NO_TEXTURE));
    const api::Mesh &first = scene.meshes[0], &second = scene.meshes[1];
    OK(tyndall_add_mesh(to, first.vertices[0].data(), 8, first.triangles[0].data(), 12, boundary, medium, TYNDALL_VACUUM, nullptr, &box));
    OK(tyndall_add_mesh(to, second.vertices[0].data(), 4, second.triangles[0].data(), 2, plate, TYNDALL_NO_BOUNDARY, TYNDALL_NO_BOUNDARY, nullptr, &floor));
    OK(tyndall_set_normals(to, floor, second.normals[0].data(), 4));
    OK(tyndall_set_texture_coordinates(to, floor, plate_uvs[0].data(), 4));
    OK(tyndall_add_environment(to, around, down, scene.environment_maps[0].texels.data(), grey, up.data(), middle.data()));
    OK(tyndall_set_camera(to, scene.camera.origin.data(), scene.camera.target.data(), scene.camera.up.data(), 35, 24, 18, TYNDALL_VACUUM));
    OK(tyndall_set_max_depth(to, 5));
    EXPECT_EQ(picture, 0);
    EXPECT_EQ(board, 1);
}

TEST(CPictures, GiveTheBytesOfTheCppInterface)
{
    api::SceneDescription scene = pictured_as_data();
    scene.media[0].phase = {.type = api::Phase::Type::table, .values = {1, 2, 4}};
    scene.meshes[1].normals.assign(4, {.1, 1, 0});
    scene.camera.box_filter = false, scene.max_depth = 5;
    scene.meshes[0].exterior = api::vacuum;
    tyndall_description* made = nullptr;
    OK(tyndall_description_create(&made));
    const std::unique_ptr<tyndall_description, Freed> description(made);
    describe_in_c(made, scene);
    tyndall_scene* scene_made = nullptr;
    OK(tyndall_scene_create(made, &scene_made));
    const std::unique_ptr<tyndall_scene, Freed> c_scene(scene_made);
    tyndall_settings* settings_made = nullptr;
    OK(tyndall_settings_create(&settings_made));
    const std::unique_ptr<tyndall_settings, Freed> settings(settings_made);
    OK(tyndall_settings_set(settings_made, "passes", "2"));
    OK(tyndall_settings_set(settings_made, "method", "path"));
    tyndall_image* image_made = nullptr;
    OK(tyndall_render(scene_made, settings_made, &image_made));
    const std::unique_ptr<tyndall_image, Freed> image(image_made);
    const api::Image wanted = api::render(api::Scene(scene), by_paths());
    const float* got = tyndall_image_layer(image_made, "beauty");
    EXPECT_EQ(std::vector<float>(got, got + wanted.beauty().size()), std::vector<float>(wanted.beauty().begin(), wanted.beauty().end()));
}

TEST(CPictures, AreRefusedByName)
{
    tyndall_description* made = nullptr;
    OK(tyndall_description_create(&made));
    const std::unique_ptr<tyndall_description, Freed> description(made);
    const std::vector<float> texels = plate_texels();
    const double one[]{1, 1, 1};
    OK(tyndall_add_picture(made, width, height, 3, texels.data(), nullptr));
    OK(tyndall_add_diffuse(made, one, 0, nullptr));
    EXPECT_EQ(tyndall_add_picture(made, width, height, 2, texels.data(), nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_add_picture(made, 1 << 30, 1 << 30, 3, texels.data(), nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_add_picture(made, width, height, 3, nullptr, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_set_lookup(made, 0, 2, 0, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_set_lookup(made, 0, 0, 3, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_set_lookup(made, 1, 0, 0, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_THAT(tyndall_last_error(), testing::HasSubstr("texture 1 has not been added"));
    EXPECT_EQ(tyndall_set_textures(made, 0, 1, TYNDALL_NO_TEXTURE), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_set_textures(made, 1, 0, TYNDALL_NO_TEXTURE), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_set_texture_coordinates(made, 0, one, 1), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_set_normals(made, 0, one, 1), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_set_rayleigh(made, 0), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_add_environment(made, 2, 2, nullptr, one, nullptr, nullptr), TYNDALL_USAGE_ERROR);
    int plastic = -1;
    OK(tyndall_add_plastic(made, one, 1.5, .1, 1, &plastic));
    OK(tyndall_set_textures(made, plastic, 0, TYNDALL_NO_TEXTURE));
    EXPECT_EQ(tyndall_add_plastic(made, nullptr, 1.5, .1, 1, nullptr), TYNDALL_USAGE_ERROR);
    EXPECT_EQ(tyndall_set_max_depth(nullptr, 3), TYNDALL_USAGE_ERROR);
}

// ---- refusals ----

class LibraryPictureFaults : public testing::TestWithParam<DescriptionFault> {};

TEST_P(LibraryPictureFaults, AreRefusedByName) { expect_refused(pictured_as_data(), GetParam()); }

using D = api::SceneDescription;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
const DescriptionFault faults[] = {
    {"TexelsMissing", [](D& s) { s.textures[0].texels.pop_back(); }, "texture 0 \"picture\": a picture of 5 x 3 pixels with 3 channels has 44 values"},
    {"Empty", [](D& s) { s.textures[0].width = 0; }, "a picture of 0 x 3 pixels"},
    {"Huge", [](D& s) { s.textures[0].width = s.textures[0].height = 1 << 30; }, "has 45 values"},
    {"Channels", [](D& s) { s.textures[0].channels = 2; }, "channels = 2"},
    {"TooBright", [](D& s) { s.textures[0].texels[4] = 1.5f; }, "pixel (1, 0) is 1.5"},
    {"TexelNan", [](D& s) { s.textures[0].texels[16] = nan; }, "pixel (0, 1) is nan"},
    {"Checkerboard", [](D& s) { s.textures[0] = {.type = api::Texture::Type::checkerboard, .even = {2, 0, 0}}; }, "even = 2"},
    {"ToUv", [](D& s) { s.textures[0].to_uv[5] = nan; }, "a number of to_uv"},
    {"TextureOfBsdf", [](D& s) { s.bsdfs[1].reflectance_texture = 1; }, "bsdf 1 \"plate\": reflectance_texture = 1"},
    {"TextureOfGlass", [](D& s) { s.bsdfs[1] = {.type = api::Bsdf::Type::dielectric, .transmittance_texture = -1}; }, "transmittance_texture = -1"},
    {"PlasticWithoutBoundary", [](D& s) { s.bsdfs[1] = {.type = api::Bsdf::Type::plastic, .eta = 1}; }, "makes no boundary"},
    {"BelowPlastic", [](D& s) { s.bsdfs[1] = {.type = api::Bsdf::Type::plastic, .below = {0, 2, 0}}; }, "below = 2"},
    {"Coordinates", [](D& s) { s.meshes[1].uvs.pop_back(); }, "3 texture coordinates for 4 vertices"},
    {"CoordinateNan", [](D& s) { s.meshes[1].uvs[0][1] = nan; }, "a texture coordinate"},
    {"MapSize", [](D& s) { s.environment_maps[0].height = 1; }, "environment map 0 \"environment map\": a map of 8 x 1 pixels"},
    {"MapTexels", [](D& s) { s.environment_maps[0].texels.resize(3); }, "has 3 values"},
    {"MapNegative", [](D& s) { s.environment_maps[0].texels[0] = -1; }, "pixel (0, 0) is -1"},
    {"MapInfinite", [](D& s) { s.environment_maps[0].texels[0] = std::numeric_limits<float>::infinity(); }, "pixel (0, 0) is inf"},
    {"Map", [](D& s) { s.emitters[0].map = 1; }, "map = 1"},
    {"Parallel", [](D& s) { s.emitters[0].middle = s.emitters[0].up; }, "up and middle are parallel"},
};
INSTANTIATE_TEST_SUITE_P(Every, LibraryPictureFaults, testing::ValuesIn(faults), [](const auto& info) { return info.param.name; });

}  // namespace
