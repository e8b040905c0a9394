/// Virtual point lights on surfaces against path tracing, wherever they stand and whatever lies between.
#include <fstream>

#include "support/temporary_folder.hpp"
#include "surface_lights.hpp"

using namespace tyndall;
using namespace tyndall::test;
using namespace tyndall::test::surface_lights;

namespace {

TEST(SurfaceLights, TwoMediaSideBySide)
{
    expect_agreement(scene_of(fog + smoke + container({-.7, -.5, -.4}, {-.1, .5, .4}, "fog") + container({.1, -.5, -.4}, {.7, .5, .4}, "smoke") + wall + floor_below + lamp + view), .03);
}

TEST(SurfaceLights, NestedMediaAreWalkedOnTheHost)
{
    expect_agreement(scene_of(fog_cube + smoke + container({-.3, -.2, -.2}, {.1, .3, .3}, "smoke", "fog") + wall + floor_below + lamp + view), .03);
}

TEST(SurfaceLights, WallsThatEndTheMedium)
{
    const std::string shell = box(Vec3(-1.5), Vec3(1.5), diffuse(Rgb(.6, .4, .2)) + side_ref("interior", "fog")), ball = sphere({.1, -.3, -.3}, .3, diffuse(Rgb(.6)) + side_ref("exterior", "fog"));
    const std::string inside_lamp = horizontal({.2, 1.2, .1}, .3, false, diffuse(Rgb(0)) + glow(Rgb(10, 20, 30), "fog"));
    expect_agreement(scene_of(fog + shell + ball + inside_lamp + sensor({.origin = {.1, .2, 1.2}, .target = {0, 0, -1}, .fov = 40, .medium = "fog"})), .06, {Layer::surface_to_media});
}

TEST(SurfaceLights, ADensityGrid)
{
    const Scene scene = parse_scene("<scene version=\"3.0.0\">" + puff + container(Vec3(-.5), Vec3(.5), "puff") + wall + floor_below + lamp + view + "</scene>", TYNDALL_SOURCE_DIR "/scenes/plume", "scene.xml");
    expect_agreement(scene, .05);
}

/// No medium at all: the light between surfaces alone, and paths of three vertices alone.
TEST(SurfaceLights, SurfacesInAVacuum)
{
    const Scene scene = scene_of(wall + floor_below + occluder + lamp + view);
    expect_agreement(scene, .02, {Layer::surface_indirect});
    expect_agreement(scene, .02, {Layer::surface_indirect}, 3);
}

/// Light that arrives at a shading normal and leaves from the true surface.
TEST(SurfaceLights, ShadingNormalsThatLean)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "leaning.obj") << "v -1.5 -.8 1.5\nv 1.5 -.8 1.5\nv 1.5 -.8 -1.5\nv -1.5 -.8 -1.5\nvn .5 1 .2\nvn -.6 1 0\nvn 0 1 .7\nvn .3 1 -.4\nf 1//1 2//2 3//3\nf 1//1 3//3 4//4\n";
    const std::string leaning = "<shape type=\"obj\"><string name=\"filename\" value=\"leaning.obj\"/>" + diffuse(Rgb(.5, .25, .75)) + "</shape>";
    expect_agreement(parse_scene("<scene version=\"3.0.0\">" + fog_cube + wall + leaning + lamp + view + "</scene>", folder.path(), "scene.xml"), .03);
}

}  // namespace
