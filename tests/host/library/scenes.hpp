#pragma once
/// The same small scene as data and as text.
#include <string>

#include "tyndall/tyndall.hpp"

namespace tyndall::test {

/// A box [-1, 1]^3 of triangles, outwards.
inline api::Mesh box_mesh(std::string name)
{
    api::Mesh box{.name = std::move(name)};
    for (double z : {-1, 1})
        for (double y : {-1, 1})
            for (double x : {-1, 1}) box.vertices.push_back({x, y, z});
    box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return box;
}

/// Fog in a box, a plate below it, a spot, a point light inside of the fog.
inline api::SceneDescription fog_as_data()
{
    api::SceneDescription scene;
    scene.media = {{.name = "fog", .sigma_t = {.5, 1, 2}, .albedo = {.9, .7, .5}, .phase = {.type = api::Phase::Type::henyey_greenstein, .g = .5}}};
    scene.bsdfs = {{.name = "boundary", .type = api::Bsdf::Type::null}, {.name = "plate", .reflectance = {.5, .25, .75}, .two_sided = true}};
    api::Mesh box = box_mesh("box");
    box.interior = 0;
    api::Mesh plate{.name = "plate", .vertices = {{-3, -1.5, -3}, {3, -1.5, -3}, {3, -1.5, 3}, {-3, -1.5, 3}}, .triangles = {{0, 2, 1}, {0, 3, 2}}, .bsdf = 1};
    scene.meshes = {box, plate};
    scene.emitters = {{.name = "spot", .type = api::Emitter::Type::spot, .value = {9, 8, 7}, .position = {2, 4, 1}, .direction = {-2, -4, -1}, .cutoff_degrees = 30, .beam_degrees = 20},
                      {.name = "point", .value = {1, 2, 3}, .position = {.25, .5, 0}, .medium = 0}};
    scene.camera = {.origin = {0, .5, 6}, .target = {0, -.25, 0}, .fov_degrees = 35, .width = 24, .height = 18, .box_filter = true};
    return scene;
}

/// What tyndall::api::Scene::parse reads as the same scene.
inline std::string fog_as_text()
{
    return R"(<scene version="3.0.0">
<sensor type="perspective"><float name="fov" value="35"/><transform name="to_world"><lookat origin="0, .5, 6" target="0, -.25, 0" up="0, 1, 0"/></transform>
<film type="hdrfilm"><integer name="width" value="24"/><integer name="height" value="18"/><rfilter type="box"/></film></sensor>
<medium type="homogeneous" id="fog"><rgb name="sigma_t" value=".5 1 2"/><rgb name="albedo" value=".9 .7 .5"/><phase type="hg"><float name="g" value=".5"/></phase></medium>
<shape type="cube"><bsdf type="null"/><ref name="interior" id="fog"/></shape>
<shape type="rectangle"><transform name="to_world"><rotate x="1" angle="-90"/><scale value="3"/><translate y="-1.5"/></transform>
<bsdf type="twosided"><bsdf type="diffuse"><rgb name="reflectance" value=".5 .25 .75"/></bsdf></bsdf></shape>
<emitter type="spot"><rgb name="intensity" value="9 8 7"/><float name="cutoff_angle" value="30"/><float name="beam_width" value="20"/>
<transform name="to_world"><lookat origin="2, 4, 1" target="0, 0, 0" up="0, 1, 0"/></transform></emitter>
<emitter type="point"><rgb name="intensity" value="1 2 3"/><point name="position" x=".25" y=".5" z="0"/><ref id="fog"/></emitter></scene>)";
}

/// Cheap, with the check of the device left to its own tests.
inline RenderSettings few_passes(int passes)
{
    RenderSettings settings;
    settings.passes = passes, settings.lights = 64, settings.selftest = false;
    return settings;
}

}  // namespace tyndall::test
