/// Scenes from memory: the same image as from a file, and refusals that name the element.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "description_faults.hpp"
#include "scenes.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

std::vector<float> copy(std::span<const float> values) { return {values.begin(), values.end()}; }

// The cube of a file and the triangles from memory are the same surfaces, so passes differ by rounding of places alone: no path decides otherwise in an image this
// small. Both run the same program; the tolerance is that rounding, amplified by 1 / w^2 at the nearest of the lights.
TEST(LibraryScene, FromMemoryIsTheSameAsFromText)
{
    const api::Image memory = api::render(api::Scene(fog_as_data()), few_passes(2));
    const api::Image text = api::render(api::Scene::parse(fog_as_text(), ".", "fog.xml"), few_passes(2));
    const auto a = memory.beauty(), b = text.beauty();
    ASSERT_EQ(a.size(), 3u * 24 * 18);
    ASSERT_EQ(b.size(), a.size());
    const double largest = *std::max_element(b.begin(), b.end());
    ASSERT_GT(largest, 0);
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-3 * b[i] + 1e-6 * largest) << "value " << i;
}

TEST(LibraryScene, AGlowingMeshAndAGridRender)
{
    api::SceneDescription scene = fog_as_data();
    scene.media[0].density = api::Grid{.size = {2, 2, 2}, .values = {0, 1, 2, 3, 4, 5, 6, 7}, .low = {-1, -1, -1}, .high = {1, 1, 1}};
    scene.meshes[1].radiance = {{1, 2, 3}};
    scene.emitters.clear();
    const api::Image image = api::render(api::Scene(scene), few_passes(1));
    EXPECT_GT(image.layer(Layer::emitted).size(), 0u);
    EXPECT_THAT(copy(image.beauty()), testing::Each(testing::Truly([](float x) { return std::isfinite(x); })));
    EXPECT_GT(*std::max_element(image.beauty().begin(), image.beauty().end()), 0);
}

TEST(LibraryScene, WarningsAreThoseOfFiles)
{
    api::SceneDescription scene = fog_as_data();
    scene.emitters[1].medium = api::vacuum;
    EXPECT_THAT(api::Scene(scene).warnings(), testing::Contains(testing::HasSubstr("point")));
    EXPECT_TRUE(api::Scene(fog_as_data()).warnings().empty()) << api::Scene(fog_as_data()).warnings()[0];
}

TEST(LibraryScene, AnotherFilm)
{
    const api::Scene scene(fog_as_data());
    EXPECT_EQ(scene.with_film(7, 5).width(), 7);
    EXPECT_EQ(scene.with_film(7, 5).height(), 5);
    EXPECT_EQ(scene.width(), 24);
    EXPECT_THROW(scene.with_film(0, 5), UsageError);
}

class LibraryFaults : public testing::TestWithParam<DescriptionFault> {};

TEST_P(LibraryFaults, AreRefusedByName) { expect_refused(fog_as_data(), GetParam()); }

using D = api::SceneDescription;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const DescriptionFault faults[] = {
    {"Extinction", [](D& s) { s.media[0].sigma_t[1] = -1; }, "medium 0 \"fog\": sigma_t = -1"},
    {"ExtinctionNan", [](D& s) { s.media[0].sigma_t[1] = nan; }, "medium 0 \"fog\": sigma_t"},
    {"Albedo", [](D& s) { s.media[0].albedo[0] = 1.5; }, "albedo = 1.5"},
    {"MeanCosine", [](D& s) { s.media[0].phase.g = 1; }, "g = 1"},
    {"Table", [](D& s) { s.media[0].phase = {.type = api::Phase::Type::table, .values = {0, 0}}; }, "table"},
    {"GridSize", [](D& s) { s.media[0].density = api::Grid{.size = {2, 2, 2}, .values = {1}}; }, "has 1 values"},
    {"GridValue", [](D& s) { s.media[0].density = api::Grid{.size = {1, 1, 1}, .values = {-1}}; }, "not negative"},
    {"Reflectance", [](D& s) { s.bsdfs[1].reflectance[2] = 2; }, "bsdf 1 \"plate\": reflectance = 2"},
    {"Glass", [](D& s) { s.bsdfs[1] = {.type = api::Bsdf::Type::dielectric, .eta = 0}; }, "eta = 0"},
    {"TwoSidedGlass", [](D& s) { s.bsdfs[1] = {.type = api::Bsdf::Type::dielectric, .two_sided = true}; }, "two-sided"},
    {"Corner", [](D& s) { s.meshes[0].triangles[3][2] = 8; }, "mesh 0 \"box\": triangle 3"},
    {"NoArea", [](D& s) { s.meshes[1].triangles = {{0, 0, 1}}; }, "no triangle of it has an area"},
    {"Normals", [](D& s) { s.meshes[1].normals = {{0, 1, 0}}; }, "1 normals for 4 vertices"},
    {"VertexNan", [](D& s) { s.meshes[1].vertices[0][0] = nan; }, "a vertex"},
    {"MeshBsdf", [](D& s) { s.meshes[1].bsdf = 2; }, "bsdf = 2"},
    {"MeshMedium", [](D& s) { s.meshes[0].interior = 1; }, "interior = 1"},
    {"GlowingNothing", [](D& s) { s.meshes[0].radiance = {{1, 1, 1}}; }, "its bsdf is null"},
    {"Direction", [](D& s) { s.emitters[0].direction = {0, 0, 0}; }, "emitter 0 \"spot\": direction has length zero"},
    {"Cutoff", [](D& s) { s.emitters[0].beam_degrees = 40; }, "beam_degrees = 40"},
    {"EmitterMedium", [](D& s) { s.emitters[1].medium = 3; }, "medium = 3"},
    {"Camera", [](D& s) { s.camera.up = {0, 0, 0}, s.camera.target = s.camera.origin; }, "camera"},
    {"View", [](D& s) { s.camera.fov_degrees = 180; }, "fov_degrees = 180"},
    {"Film", [](D& s) { s.camera.width = 0; }, "film of 0 x 18"},
    {"Clip", [](D& s) { s.camera.near_clip = 1e5; }, "near_clip"},
    {"Depth", [](D& s) { s.max_depth = -2; }, "max_depth = -2"},
};
INSTANTIATE_TEST_SUITE_P(Every, LibraryFaults, testing::ValuesIn(faults), [](const auto& info) { return info.param.name; });

}  // namespace
