/// Virtual ray lights against their brute-force twin, layer by layer, where media, surfaces and lights lie in every way to each other.
/// Channels differ in extinction, so each is judged.
#include "support/picture_file.hpp"
#include "support/temporary_folder.hpp"
#include "whole_renderer.hpp"

using namespace tyndall;
using namespace tyndall::test;

namespace {

const std::string view = sensor({.origin = {.3, .6, 3}});
const std::string lamp = horizontal({.2, 1.2, .1}, .3, false, diffuse(Rgb(0)) + glow(Rgb(4, 3, 2)));
const std::string floor_below = horizontal({0, -.8, 0}, 1.5, true, diffuse(Rgb(.5, .25, .75)));
const std::string fog = medium("fog", Rgb(.5, 1, 2), Rgb(.95, .9, .8), .5), smoke = medium("smoke", Rgb(4, 3, 2), Rgb(.7), -.3),
                  haze = medium("haze", Rgb(.3), Rgb(.9));
const std::string glass = R"(<bsdf type="dielectric"><float name="int_ior" value="1.5"/><float name="ext_ior" value="1"/></bsdf>)";

struct Twins {
    WholeRender vrl, path;
};

Twins twins(const std::string& body, int vrl_passes = 400, int path_passes = 6000)
{
    const Scene scene = scene_of(body);
    return {render_whole(scene, {.method = Method::vrl, .passes = vrl_passes, .lights = 256}),
            render_whole(scene, {.method = Method::path, .passes = path_passes, .seed = 2})};
}

bool found(const WholeRender& r, const std::string& effect)
{
    for (const auto& known : r.report().effects)
        if (known.effect == effect) return known.found;
    ADD_FAILURE() << "the report knows no effect " << effect;
    return false;
}

void expect_twins(const Twins& t, std::initializer_list<Layer> layers, double precision = .02)
{
    for (const int channel : {0, 1, 2}) expect_layers_agree(t.vrl, t.path, layers, precision, channel);
}

TEST(AgainstPathTracing, FogCubeAroundAnOccluder)
{
    const Twins t = twins(fog + container(Vec3(-.5), Vec3(.5), "fog") + box({-.3, .05, -.3}, {.3, .15, .3}, diffuse(Rgb(.5))) +
                          floor_below + lamp + view);
    EXPECT_TRUE(found(t.vrl, "OCCLUDERS"));
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface});
}

TEST(AgainstPathTracing, NestedMedia)
{
    const Twins t = twins(fog + smoke + container(Vec3(-.5), Vec3(.5), "fog") + container({-.3, -.2, -.2}, {.1, .3, .3}, "smoke", "fog") +
                          floor_below + lamp + view);
    EXPECT_TRUE(found(t.vrl, "NONCONVEX_MEDIA"));
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface});
}

TEST(AgainstPathTracing, MediaThatShareAFace)
{
    const Twins t = twins(fog + smoke + container({-.6, -.5, -.5}, {0, .5, .5}, "fog") + container({0, -.5, -.5}, {.6, .5, .5}, "smoke") +
                          floor_below + lamp + view);
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface});
}

TEST(AgainstPathTracing, FogInABallIsWalkedOnTheHost)
{
    const Twins t = twins(fog + sphere({0, 0, 0}, .6, null_surface + side_ref("interior", "fog")) + floor_below + lamp + view);
    EXPECT_TRUE(found(t.vrl, "NONCONVEX_MEDIA"));
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface});
}

TEST(AgainstPathTracing, CameraAndLightInsideTheFog)
{
    const Twins t = twins(fog + container(Vec3(-1), Vec3(1), "fog") + sphere({.1, -.4, -.4}, .5, diffuse(Rgb(.6))) +
                          horizontal({-.2, .9, -.2}, .3, false, diffuse(Rgb(0)) + glow(Rgb(10, 20, 30), "fog")) +
                          sensor({.origin = {.1, .2, .9}, .target = {0, 0, -1}, .fov = 60, .medium = "fog"}));
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface}, .04);
}

TEST(AgainstPathTracing, SpotConstantAndDirectionalLight)
{
    const std::string lights =
        R"(<emitter type="directional"><vector name="direction" value="0.3 -1 -0.2"/><rgb name="irradiance" value="0.5 1 1.5"/></emitter>)"
        R"(<emitter type="spot"><transform name="to_world"><lookat origin="1 1 1" target="0 0 0" up="0 1 0"/></transform><rgb name="intensity" value="6"/>)"
        R"(<float name="cutoff_angle" value="30"/></emitter>)";
    const Twins t = twins(fog + container(Vec3(-.5), Vec3(.5), "fog") + floor_below + lights + constant_light(Rgb(.2)) + view);
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface});
}

TEST(AgainstPathTracing, GlassBallInFogLitByAnArea)
{
    const Twins t = twins(fog + container(Vec3(-.6), Vec3(.6), "fog") + sphere({0, -.1, 0}, .3, glass + side_ref("exterior", "fog")) +
                              floor_below + lamp + view,
                          300, 8000);
    EXPECT_TRUE(found(t.vrl, "SPECULAR_SURFACES"));
    expect_twins(t, {Layer::media_to_media, Layer::media_to_surface}, .03);
    expect_twins(t, {specular(Layer::media_to_media)}, .2);
}

/// Light paths carry flux through facets, camera paths radiance: they agree only if refraction divides by the index squared in one of them alone. The lamp inside the glass makes the two
/// differ by 2.25 if it does not.
TEST(AgainstPathTracing, FrostedGlassAroundALampInFog)
{
    const std::string frosted = R"(<bsdf type="roughdielectric"><string name="distribution" value="ggx"/><float name="alpha" value=".3"/><float name="int_ior" value="1.5"/><float name="ext_ior" value="1"/></bsdf>)";
    const Twins t = twins(fog + container(Vec3(-.6), Vec3(.6), "fog") + sphere({0, .1, 0}, .3, frosted + side_ref("exterior", "fog")) +
                              sphere({0, .1, 0}, .1, diffuse(Rgb(0)) + glow(Rgb(20, 15, 10))) + floor_below + view,
                          300, 6000);
    EXPECT_TRUE(found(t.vrl, "GLOSSY_SURFACES"));
    EXPECT_FALSE(found(t.vrl, "SPECULAR_SURFACES"));
    expect_twins(t, {Layer::media_to_media, Layer::media_to_surface}, .05);
}

/// media_to_surface is shared: virtual lights reach the floor, paths the plastic and the metal. Neither part may be missing or counted twice.
TEST(AgainstPathTracing, PlasticAndRoughMetalBesideADiffuseFloor)
{
    const std::string plastic = R"(<bsdf type="plastic"><rgb name="diffuse_reflectance" value=".1 .4 .6"/></bsdf>)",
                      metal = R"(<bsdf type="roughconductor"><float name="alpha" value=".25"/><rgb name="eta" value=".2 .9 1.1"/><rgb name="k" value="3.9 2.4 2.2"/></bsdf>)";
    const Twins t = twins(fog + container({-.5, -.3, -.5}, Vec3(.5), "fog") + sphere({-.5, -.55, .5}, .25, plastic) + sphere({.5, -.55, .5}, .25, metal) + floor_below + lamp + view, 300, 6000);
    EXPECT_TRUE(found(t.vrl, "GLOSSY_SURFACES"));
    EXPECT_TRUE(found(t.vrl, "SPECULAR_SURFACES"));
    for (const auto& layer : t.vrl.report().layers)
        if (layer.layer == "media_to_surface") { EXPECT_EQ(layer.technique, "virtual ray lights, path tracing"); }
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface}, .05);
}

/// Eye points carry the colour that stands where they stand: squares of light and dark under one half of the fog, none under the other.
TEST(AgainstPathTracing, TexturedFloorAndBall)
{
    const auto checkered = [](const std::string& role, const Rgb& even, const Rgb& odd, const std::string& to_uv) {
        return "<texture type=\"checkerboard\" name=\"" + role + "\">" + rgb("color0", even) + rgb("color1", odd) + "<transform name=\"to_uv\">" + to_uv + "</transform></texture>";
    };
    const std::string wood = "<bsdf type=\"twosided\"><bsdf type=\"diffuse\">" + checkered("reflectance", Rgb(.9, .1, .7), Rgb(0, .8, .3), R"(<scale x=".7" y="1.5"/>)") + "</bsdf></bsdf>",
                      toy = "<bsdf type=\"plastic\">" + checkered("diffuse_reflectance", Rgb(.8), Rgb(.1), R"(<scale value="4"/>)") + "</bsdf>";
    const Twins t = twins(fog + container({-.9, -.5, -.5}, {.1, .5, .5}, "fog") + sphere({.5, -.5, .3}, .3, toy) + horizontal({0, -.8, 0}, 1.5, true, wood) + lamp + view, 300, 6000);
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface, Layer::surface_direct}, .08);
}

/// A sky with a bright patch, in a file: light paths start on a disk around the scene, path tracing meets it or connects to it.
TEST(AgainstPathTracing, EnvironmentMap)
{
    const TemporaryFolder folder;
    std::vector<float> texels;
    for (int i = 0; i < 8 * 5; ++i) texels.insert(texels.end(), {i == 11 ? 30.f : .3f, i == 11 ? 25.f : .4f, i == 11 ? 20.f : .6f});
    exr_bytes(8, 5, {"R", "G", "B"}, texels, folder / "sky.exr");
    const std::string sky = R"(<emitter type="envmap"><string name="filename" value="sky.exr"/><float name="scale" value=".5"/><transform name="to_world"><rotate y="1" angle="40"/></transform></emitter>)";
    const Scene scene = parse_scene("<scene version=\"3.0.0\">" + fog + container(Vec3(-.5), Vec3(.5), "fog") + floor_below + sky + view + "</scene>", folder.path(), "scene.xml");
    const Twins t{render_whole(scene, {.method = Method::vrl, .passes = 400, .lights = 256}), render_whole(scene, {.method = Method::path, .passes = 6000, .seed = 2})};
    expect_twins(t, {Layer::emitted, Layer::surface_direct, Layer::single, Layer::media_to_media, Layer::media_to_surface}, .03);
}

/// A medium behind walls of glass: connections inside of it are straight, what crosses the wall is not theirs.
TEST(AgainstPathTracing, JuiceInAGlassBall)
{
    const Twins t = twins(fog + sphere({0, 0, 0}, .6, glass + side_ref("interior", "fog")) + sphere({.15, -.1, .2}, .15, diffuse(Rgb(.7))) + floor_below + lamp + view, 400, 8000);
    EXPECT_TRUE(found(t.vrl, "SPECULAR_SURFACES"));
    expect_twins(t, {Layer::media_to_media}, .05);
    expect_twins(t, {Layer::media_to_surface}, .15);
}

/// Two boxes in vacuum are clipped in the kernel. A small boundary inside one of them between the medium and itself changes nothing but
/// that the host must walk.
TEST(DisjointMedia, ClippedInTheKernelAreAsWalkedOnTheHost)
{
    const std::string two = fog + smoke + container({-.7, -.5, -.4}, {-.1, .5, .4}, "fog") +
                            container({.1, -.5, -.4}, {.7, .5, .4}, "smoke") + floor_below + lamp + view;
    const std::string third = container({-.4, -.1, -.1}, {-.3, 0, 0}, "fog", "fog");
    const WholeRender clipped = render_whole(scene_of(two), {.passes = 250, .lights = 256}),
                      walked = render_whole(scene_of(two + third), {.passes = 250, .lights = 256, .seed = 2});
    EXPECT_FALSE(found(clipped, "NONCONVEX_MEDIA"));
    EXPECT_TRUE(found(walked, "NONCONVEX_MEDIA"));
    for (const int channel : {0, 1, 2})
        expect_layers_agree(clipped, walked, {Layer::media_to_media, Layer::media_to_surface}, .02, channel);
    expect_twins({clipped, render_whole(scene_of(two), {.method = Method::path, .passes = 5000})},
                 {Layer::media_to_media, Layer::media_to_surface});
}

TEST(AgainstPathTracing, ThinHazeBesideThickSmoke)
{
    const Twins t = twins(haze + medium("soot", Rgb(30, 20, 10), Rgb(.9)) + container({-.6, -.5, -.5}, {0, .5, .5}, "haze") +
                              container({.1, -.3, -.3}, {.4, .3, .3}, "soot") + floor_below + lamp + view,
                          400, 5000);
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface}, .05);
}

/// Lights that end at their sampled collision divide by the chance of getting there, which a grid's table gives.
TEST(AgainstPathTracing, ShortLightsInADensityGrid)
{
    const std::string puff = R"(<medium type="heterogeneous" id="puff"><volume name="sigma_t" type="gridvolume"><string name="filename" value="plume.vol"/><transform name="to_world"><translate x="-0.5" y="-0.5" z="-0.5"/></transform></volume>
                             <rgb name="albedo" value=".95, .9, .8"/><float name="scale" value="8"/></medium>)";
    const std::string body = puff + container(Vec3(-.5), Vec3(.5), "puff") + floor_below + lamp + view;
    const Scene scene = parse_scene("<scene version=\"3.0.0\">" + body + "</scene>", TYNDALL_SOURCE_DIR "/scenes/plume", "scene.xml");
    const Twins t{render_whole(scene, {.method = Method::vrl, .passes = 300, .lights = 256, .segment_length = SegmentLength::short_}),
                  render_whole(scene, {.method = Method::path, .passes = 4000, .seed = 2})};
    EXPECT_TRUE(found(t.vrl, "SHORT_LIGHTS"));
    EXPECT_TRUE(found(t.vrl, "HETEROGENEOUS"));
    expect_twins(t, {Layer::single, Layer::media_to_media, Layer::media_to_surface}, .05);
}

}  // namespace
