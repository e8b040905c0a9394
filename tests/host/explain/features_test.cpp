/// What scenes call for, and which element is said to cause it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "kernels/shared/host_features.hpp"
#include "scene/scene_features.hpp"
#include "scene_parts.hpp"

namespace tyndall::test {
namespace {

struct Row {
    std::string what;
    Scene scene;
    std::uint32_t media_to_media, media_to_surface;
    std::set<std::string> facts;        ///< that are found
    std::map<std::string, int> causes;  ///< effect -> line of its element; 0: a setting
};

using namespace feature_bit;

std::vector<Row> empty_and_plain_scenes()
{
    return {
        {"nothing", scene_of({}), 0, 0, {}, {}},
        {"no medium", scene_of({lamp(), shape("sphere", "ball", here, white)}), occluders, occluders, {"LIGHTS", "RECEIVING_SURFACES"}, {{"LIGHTS", 2}, {"RECEIVING_SURFACES", 3}}},
        {"a lamp without power", scene_of({R"(<emitter type="point" id="lamp"><rgb name="intensity" value="0"/></emitter>)"}), 0, 0, {}, {}},
        {"fog everywhere, nothing else", scene_of({medium("fog"), lamp(in_fog)}, in_fog), 0, 0,
         {"LIGHTS", "MEDIA", "SCATTERING_MEDIA", "UNBOUNDED_MEDIA", "LIGHTS_IN_MEDIA"}, {{"MEDIA", 2}, {"UNBOUNDED_MEDIA", 2}, {"LIGHTS_IN_MEDIA", 3}}},
        {"albedo 0", scene_of({medium("fog", ".5", "0"), lamp(in_fog)}, in_fog), 0, 0, {"LIGHTS", "MEDIA", "ONLY_ABSORBING_MEDIA", "UNBOUNDED_MEDIA", "LIGHTS_IN_MEDIA"},
         {{"ONLY_ABSORBING_MEDIA", 2}}},
        {"extinction 0", scene_of({medium("fog", "0"), lamp(in_fog)}, in_fog), 0, 0, {"LIGHTS", "UNBOUNDED_MEDIA", "LIGHTS_IN_MEDIA"}, {}},
        {"scattering in one channel only", scene_of({medium("fog", ".5", "0, .5, 0"), lamp(in_fog)}, in_fog), 0, 0,
         {"LIGHTS", "MEDIA", "SCATTERING_MEDIA", "UNBOUNDED_MEDIA", "LIGHTS_IN_MEDIA"}, {}},
    };
}

std::vector<Row> scenes_of_media()
{
    const std::set<std::string> open_fog{"LIGHTS", "MEDIA", "SCATTERING_MEDIA", "UNBOUNDED_MEDIA", "LIGHTS_IN_MEDIA"}, box{"LIGHTS", "MEDIA", "SCATTERING_MEDIA", "CONVEX_CONTAINERS"};
    return {
        {"forward scattering", scene_of({medium("fog", ".5", ".8", forward), lamp(in_fog)}, in_fog), anisotropic, anisotropic, open_fog, {{"ANISOTROPIC", 2}}},
        {"Henyey-Greenstein with g = 0", scene_of({medium("fog", ".5", ".8", R"(<phase type="hg"><float name="g" value="0"/></phase>)"), lamp(in_fog)}, in_fog), 0, 0, open_fog, {}},
        {"Rayleigh's phase function", scene_of({medium("fog", ".5", ".8", R"(<phase type="rayleigh"/>)"), lamp(in_fog)}, in_fog), anisotropic | phase_lobes, anisotropic | phase_lobes, open_fog,
         {{"ANISOTROPIC", 2}, {"PHASE_LOBES", 2}}},
        {"a table", scene_of({medium("fog", ".5", ".8", R"(<phase type="tabphase"><string name="values" value="1, 2"/></phase>)"), lamp(in_fog)}, in_fog), anisotropic | phase_lobes,
         anisotropic | phase_lobes, open_fog, {{"PHASE_LOBES", 2}}},
        {"a blend without its second part", scene_of({medium("fog", ".5", ".8", R"(<phase type="blendphase"><float name="weight" value="0"/>)" + forward + R"(<phase type="rayleigh"/></phase>)"),
          lamp(in_fog)}, in_fog), anisotropic, anisotropic, open_fog, {{"ANISOTROPIC", 2}}},
        {"coloured extinction", scene_of({medium("fog", ".5, .4, .5"), lamp(in_fog)}, in_fog), coloured, coloured, open_fog, {{"COLOURED", 2}}},
        {"coloured albedo is no coloured extinction", scene_of({medium("fog", ".5", ".9, .5, .1"), lamp(in_fog)}, in_fog), 0, 0, open_fog, {}},
        {"a box of fog", scene_of({medium("fog"), lamp(), container("cube", "box", here)}), 0, boundaries, box, {{"BOUNDARIES", 4}, {"CONVEX_CONTAINERS", 4}}},
        {"a ball of fog", scene_of({medium("fog"), container("sphere", "ball", here), lamp()}), boundaries | nonconvex_media | occluders, boundaries | nonconvex_media | occluders,
         {"LIGHTS", "MEDIA", "SCATTERING_MEDIA"}, {{"NONCONVEX_MEDIA", 3}, {"OCCLUDERS", 3}, {"BOUNDARIES", 3}}},
        {"two boxes of one fog", scene_of({medium("fog"), lamp(), container("cube", "left", small), container("cube", "right", R"(<translate x="3"/>)")}), boundaries, boundaries, box,
         {{"BOUNDARIES", 4}}},
        {"two boxes of two fogs", scene_of({medium("fog"), medium("mist", ".1"), lamp(), container("cube", "left", small), container("cube", "right", R"(<translate x="3"/>)", "mist")}),
         boundaries | many_media, boundaries | many_media, box, {{"MANY_MEDIA", 3}}},
        {"two boxes that overlap", scene_of({medium("fog"), lamp(), container("cube", "left", here), container("cube", "right", R"(<translate x="1"/>)")}),
         boundaries | nonconvex_media | occluders, boundaries | nonconvex_media | occluders, {"LIGHTS", "MEDIA", "SCATTERING_MEDIA"}, {{"NONCONVEX_MEDIA", 5}}},
    };
}

/// A box of fog whose extinction and albedo come from grids; -1: from none. The grids stand in lines 7 and 8.
Scene box_of_grids(int density_channels, int albedo_channels)
{
    Scene scene = scene_of({medium("fog"), lamp(), container("cube", "box", here)});
    const auto add = [&](int channels, int line) {
        if (channels < 0) return none;
        scene.volumes.push_back({.name = "smoke.vol", .channels = channels, .values = std::vector<float>(static_cast<std::size_t>(channels), .5f), .where = {"scene.xml", line, 9}});
        return static_cast<int>(scene.volumes.size()) - 1;
    };
    scene.media[0].density = add(density_channels, 7), scene.media[0].albedo_volume = add(albedo_channels, 8);
    return scene;
}

std::vector<Row> scenes_of_grids()
{
    const std::set<std::string> box{"LIGHTS", "MEDIA", "SCATTERING_MEDIA", "CONVEX_CONTAINERS"};
    return {
        {"a grid of extinction", box_of_grids(1, -1), heterogeneous, heterogeneous | boundaries, box, {{"HETEROGENEOUS", 7}}},
        {"grids of extinction and albedo", box_of_grids(1, 1), heterogeneous, heterogeneous | boundaries, box, {{"HETEROGENEOUS", 7}}},
        {"a coloured albedo is no coloured extinction", box_of_grids(1, 3), heterogeneous, heterogeneous | boundaries, box, {{"HETEROGENEOUS", 7}}},
        {"a grid of albedo alone", box_of_grids(-1, 1), heterogeneous, heterogeneous | boundaries, box, {{"HETEROGENEOUS", 8}}},
        {"a coloured grid", box_of_grids(3, -1), heterogeneous | coloured_grids | coloured, heterogeneous | coloured_grids | coloured | boundaries, box,
         {{"HETEROGENEOUS", 7}, {"COLOURED_GRIDS", 7}, {"COLOURED", 7}}},
    };
}

std::vector<Row> scenes_of_surfaces()
{
    const std::set<std::string> fog{"LIGHTS", "MEDIA", "SCATTERING_MEDIA", "UNBOUNDED_MEDIA", "LIGHTS_IN_MEDIA"};
    const auto with = [](std::set<std::string> set, const std::string& more) { return set.insert(more), set; };
    const auto without = [](std::set<std::string> set, const std::string& less) { return set.erase(less), set; };
    const std::set<std::string> box{"LIGHTS", "MEDIA", "SCATTERING_MEDIA", "CONVEX_CONTAINERS", "RECEIVING_SURFACES", "SURFACES_IN_REACH"};
    return {
        {"a ball in fog", scene_of({medium("fog"), lamp(in_fog), shape("sphere", "ball", small, white)}, in_fog), occluders, occluders, with(with(fog, "RECEIVING_SURFACES"), "SURFACES_IN_REACH"), {{"OCCLUDERS", 4}}},
        {"a black ball in fog", scene_of({medium("fog"), lamp(in_fog), shape("sphere", "ball", small, black)}, in_fog), occluders, occluders, fog, {}},
        {"a glass ball in fog", scene_of({medium("fog"), lamp(in_fog), shape("sphere", "ball", small, glass)}, in_fog), occluders, occluders, with(fog, "SPECULAR_SURFACES"),
         {{"SPECULAR_SURFACES", 4}}},
        {"a mirror in fog", scene_of({medium("fog"), lamp(in_fog), shape("rectangle", "mirror", small, mirror)}, in_fog), occluders, occluders, with(fog, "SPECULAR_SURFACES"), {}},
        {"a box of fog on a table", scene_of({medium("fog"), lamp(), container("cube", "box", here), shape("rectangle", "table", below, white)}), 0, boundaries, box, {{"RECEIVING_SURFACES", 5}}},
        {"a box of fog behind a table", scene_of({medium("fog"), lamp(), container("cube", "box", here), shape("rectangle", "table", R"(<rotate x="1" angle="90"/><translate y="-2"/>)", white)}),
         0, boundaries, without(box, "SURFACES_IN_REACH"), {{"RECEIVING_SURFACES", 5}}},
        {"a box of fog behind a table with two sides",
         scene_of({medium("fog"), lamp(), container("cube", "box", here),
                   shape("rectangle", "table", R"(<rotate x="1" angle="90"/><translate y="-2"/>)", R"(<bsdf type="twosided"><bsdf type="diffuse"/></bsdf>)")}),
         0, boundaries, box, {{"SURFACES_IN_REACH", 5}}},
        {"a box of fog through which a wall runs", scene_of({medium("fog"), lamp(), container("cube", "box", here), shape("rectangle", "wall", R"(<rotate x="1" angle="90"/><translate y=".9"/>)", white)}),
         occluders, boundaries | occluders, box, {{"SURFACES_IN_REACH", 5}}},
        {"a box of fog beside a ball", scene_of({medium("fog"), lamp(), container("cube", "box", small), shape("sphere", "ball", R"(<translate x="3"/>)", white)}), 0,
         boundaries | occluders, box, {{"OCCLUDERS", 5}}},
        {"a box of fog around a ball", scene_of({medium("fog"), lamp(), container("cube", "box", here), shape("sphere", "ball", small, white)}), occluders, boundaries | occluders, box,
         {{"OCCLUDERS", 5}}},
    };
}

const Effect& effect(const SceneFeatures& features, const std::string& name)
{
    for (const Effect& e : features.effects)
        if (e.row.name == name) return e;
    throw std::logic_error("no effect " + name);
}

void expect_row(const Row& row)
{
    SCOPED_TRACE(row.what);
    const SceneFeatures features = features_of(row.scene);
    EXPECT_EQ(feature_names(features.media_to_media), feature_names(row.media_to_media));
    EXPECT_EQ(feature_names(features.media_to_surface), feature_names(row.media_to_surface));
    std::set<std::string> found;
    for (const Effect& e : features.effects)
        if (e.found && e.row.bit == 0) found.emplace(e.row.name);
    EXPECT_EQ(found, row.facts);
    for (const auto& [name, line] : row.causes) {
        EXPECT_TRUE(effect(features, name).found) << name;
        EXPECT_EQ(effect(features, name).where.line, line) << name << ": " << effect(features, name).cause;
        EXPECT_GT(effect(features, name).where.column, 0) << name;
    }
}

TEST(Features, OfScenesWithoutAnythingOrFogAlone) { std::ranges::for_each(empty_and_plain_scenes(), expect_row); }
TEST(Features, OfMediaAndTheirBoundaries) { std::ranges::for_each(scenes_of_media(), expect_row); }
TEST(Features, OfGrids) { std::ranges::for_each(scenes_of_grids(), expect_row); }
TEST(Features, OfSurfacesAmongMedia) { std::ranges::for_each(scenes_of_surfaces(), expect_row); }

TEST(Features, SettingsCauseTheirs)
{
    const SceneFeatures features = features_of(scene_of({medium("fog"), lamp(in_fog)}, in_fog), true, 5);
    EXPECT_EQ(features.media_to_media, short_lights | depth_limit);
    EXPECT_EQ(effect(features, "DEPTH_LIMIT").cause, "setting: max_depth = 5");
    EXPECT_EQ(effect(features, "DEPTH_LIMIT").where.line, 0);
}

TEST(Features, EveryBitHasOneCauseAndEveryFoundEffectAnElementOrASetting)
{
    for (const auto& rows : {empty_and_plain_scenes(), scenes_of_media(), scenes_of_grids(), scenes_of_surfaces()})
        for (const Row& row : rows) {
            const SceneFeatures features = features_of(row.scene, true);
            std::uint32_t to_media = 0, to_surface = 0;
            for (const FeatureCause& c : features.causes) {
                std::uint32_t& mask = c.layer == Layer::media_to_media ? to_media : to_surface;
                EXPECT_EQ(mask & c.bit, 0u) << row.what << ": said twice: " << c.cause;
                mask |= c.bit;
            }
            EXPECT_EQ(to_media, features.media_to_media);
            EXPECT_EQ(to_surface, features.media_to_surface);
            ASSERT_EQ(features.effects.size(), effect_list().size());
            for (const Effect& e : features.effects) EXPECT_EQ(e.found, !e.cause.empty()) << row.what << ": " << e.row.name;
        }
}

TEST(Features, ContainersAreOfTheShapesThatBoundMedia)
{
    const SceneFeatures features = features_of(scene_of({medium("fog"), lamp(), shape("sphere", "ball", R"(<translate x="3"/>)", white), container("cube", "box", small)}));
    ASSERT_EQ(features.containers.size(), 1u);
    EXPECT_EQ(features.containers[0].shape, 1);
    EXPECT_EQ(features.containers[0].planes.size(), 6u);
}

TEST(Features, ANullRefOfTheCameraMakesContainersUnusable)
{
    const SceneFeatures features = features_of(scene_of({medium("mist"), medium("fog"), lamp(), container("cube", "box", small, "mist")}, in_fog));
    EXPECT_TRUE(features.media_to_media & nonconvex_media);
    EXPECT_EQ(effect(features, "NONCONVEX_MEDIA").cause, "the sensor is in a medium that no boundary holds");
    EXPECT_EQ(effect(features, "NONCONVEX_MEDIA").where.line, 1);
}

}  // namespace
}  // namespace tyndall::test
